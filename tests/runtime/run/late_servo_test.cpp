// A robot whose threads are kept waiting, as on a busy computer: however late they are, a late tick
// is never taken for an encoder that jumps.
#include <doctest/doctest.h>

#include <algorithm>
#include <random>
#include <string>

#include "motion/robots/robot_file.h"
#include "motion/space/cycle_instant.h"
#include "runtime/time/clock.h"
#include "tests/support/process.h"
#include "tests/support/stepped_run.h"

using rob::test::SteppedRun;

namespace {

/// 1 kHz, 1 m/s: a millisecond is a millimetre.
rob::motion::RobotModel quick_robot() {
  static const std::string text = rob::test::read_whole_file(ROB_SOURCE_DIR "/tests/bench/xy.toml");
  return rob::motion::parse_robot_file(text, "xy.toml");
}

/// How late a thread is, s: punctual in most cycles, `often` up to `most`.
struct ServoLateness {
  double often;
  double most;
};

/// A run whose two ticks are kept waiting at random: before they begin, and the servo also after it
/// has begun, where its thread has looked at some things and not yet at others. The motion goes on
/// meanwhile.
class LateServoRun {
 public:
  LateServoRun(unsigned seed, const ServoLateness& lateness)
      : random_(seed),
        lateness_(lateness),
        run_(kProgram, rob::test::simulated(quick_robot()), 1, quick_robot()),
        period_(run_.robot.servo_period) {
    run_.task.step(1'000'000);
    run_.controller.plan_path();
    run_.controller.servo().enable(-period_);
  }

  rob::runtime::RunResult result() {
    for (std::int64_t cycle = 0; !run_.controller.motion().over() && cycle < 20'000;) {
      let_pass(std::max(time_, static_cast<double>(cycle) * period_ + late()));
      const double due = rob::motion::cycle_instant(cycle, period_);
      Clock clock(*this);
      run_.controller.servo().cycle(clock, due);
      run_.recorder.drain();
      cycle = std::max(cycle, static_cast<std::int64_t>(time_ / period_)) + 1;
    }
    return run_.recorder.finish();
  }

 private:
  static constexpr const char* kProgram =
      "MOVE (200, 100, 0) AT 800mm/s\nMOVE (-200, 150, 50) AT 800mm/s\nMOVE (0, 0, 0)\n"
      "MOVE (200, -100, 0) AT 500mm/s\nMOVE (0, 0, 0)\nSTOP\n";

  /// The servo's thread waits just before it looks.
  class Clock final : public rob::runtime::Clock {
   public:
    explicit Clock(LateServoRun& run) : run_(run) {}
    double now() const noexcept override {
      run_.let_pass(run_.time_ + run_.late());
      return run_.time_;
    }
    void sleep_until(double) noexcept override {}

   private:
    LateServoRun& run_;
  };

  double late() {
    std::uniform_real_distribution<double> share(0, 1);
    constexpr double kPunctual = 2e-4;
    return share(random_) < lateness_.often ? lateness_.most * share(random_)
                                            : kPunctual * share(random_);
  }
  void let_pass(double until) {
    while (motion_ <= until) {
      const double began = motion_;
      run_.controller.motion().cycle(made_, 0);
      run_.controller.plan_path();
      run_.task.step(1000);
      made_ = std::max(made_, static_cast<std::int64_t>(began / period_)) + 1;
      motion_ = std::max(began, static_cast<double>(made_) * period_ + late());
    }
    time_ = until;
  }

  std::mt19937 random_;
  ServoLateness lateness_;
  SteppedRun run_;
  double period_;
  double time_ = 0;    ///< s
  double motion_ = 0;  ///< when its next cycle comes
  std::int64_t made_ = 0;
};

}  // namespace

TEST_CASE("late ticks are no jump of an encoder, and less than 200 ms of them no end of the run") {
  for (const ServoLateness& lateness : {ServoLateness{0.02, 0.01}, ServoLateness{0.01, 0.04},
                                        ServoLateness{0.2, 0.02}, ServoLateness{0.005, 0.09}}) {
    for (unsigned seed = 1; seed <= 5; ++seed) {
      CAPTURE(seed);
      CAPTURE(lateness.often);
      CAPTURE(lateness.most);
      const rob::runtime::RunResult result = LateServoRun(seed, lateness).result();
      CHECK_MESSAGE(result.status == "done", result.error->message);
    }
  }
}

TEST_CASE("what is later than 200 ms is called late, by its time") {
  int late = 0;
  for (unsigned seed = 1; seed <= 10; ++seed) {
    const rob::runtime::RunResult result = LateServoRun(seed, {0.005, 0.3}).result();
    if (result.status == "done") continue;
    ++late;
    REQUIRE(result.error.has_value());
    CHECK(result.error->code == "E501");
    CHECK(result.error->message.find(" ms late") != std::string::npos);
  }
  CHECK(late > 0);
}
