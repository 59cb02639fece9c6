// A machine that follows references, as those on a wire do, under ticks that are late as threads
// are: what it is told is what was planned.
#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <random>

#include "motion/space/cycle_instant.h"
#include "tests/support/stepped_run.h"

using rob::motion::JointReference;
using rob::motion::JointVector;
using rob::test::SteppedRun;

namespace {

constexpr double kFollowingPeriod = 0.01;
constexpr double kOff = 0.0005;  // m, where x is found, beside where the program begins

/// Goes wherever it is told, at once.
class Follower final : public rob::motion::ServoBackend {
 public:
  explicit Follower(std::vector<JointReference>& told) : told_(told) {
    place_ = rob::motion::embedded_robot("gantry").start;
    place_[0] += kOff;
  }

  int axes() const noexcept override { return static_cast<int>(place_.size()); }
  void open() override {}
  void close() noexcept override {}
  rob::motion::DriverStatus enable(double) noexcept override { return {}; }
  void disable(double) noexcept override {}
  rob::motion::DriverStatus read(double now, rob::motion::ServoState& state) noexcept override {
    state.measured = {now, place_, JointVector::Zero(place_.size())};
    return rob::motion::DriverStatus::Ok;
  }
  rob::motion::DriverStatus write(double,
                                  const rob::motion::ServoCommand& command) noexcept override {
    told_.push_back(command.reference);
    place_ = command.reference.q;
    return rob::motion::DriverStatus::Ok;
  }
  bool follows_references() const noexcept override { return true; }

 private:
  std::vector<JointReference>& told_;
  JointVector place_;
};

struct Lateness {
  double servo;   // s, at most
  double motion;  // s, at most
};

/// A run in which the ticks come as late as threads do, and in the order that follows from it.
struct LateRun {
  std::vector<JointReference> told;
  std::vector<JointReference> planned;  // of each period
  bool done = false;

  LateRun(const Lateness& most, unsigned seed) {
    rob::motion::RobotModel robot = rob::motion::embedded_robot("gantry");
    robot.servo_period = kFollowingPeriod;
    SteppedRun run("MOVE (40, 40, 0)\nMOVE (140, 40, 30)\nSTOP\nMOVE (40, 0, 0)\nSTOP\n",
                   std::make_unique<Follower>(told), 1, robot);
    std::mt19937 random(seed);
    std::uniform_real_distribution<double> share(0, 1);
    run.task.step(1'000'000);
    run.controller.servo().enable(-kFollowingPeriod);
    std::int64_t made = 0;
    double next = most.motion * share(random);
    for (std::int64_t k = 0; !run.controller.motion().over() && k < 5000; ++k) {
      const double due = rob::motion::cycle_instant(k, kFollowingPeriod);
      const double now = due + most.servo * share(random);
      while (next < now) {
        run.controller.motion().cycle(made++, 0);
        next = std::max(next,
                        static_cast<double>(made) * kFollowingPeriod + most.motion * share(random));
      }
      run.controller.servo().cycle(now, due);
      run.recorder.drain();
      run.task.step(1000);
    }
    done = run.recorder.finish().status == "done";
    for (const auto& row : run.rows) planned.push_back(row.sample.reference);
  }

  /// m or rad, by cycle: what it was told beside what was planned for that instant.
  std::vector<double> off() const {
    std::vector<double> all;
    for (std::size_t k = 0; k < std::min(told.size(), planned.size()); ++k) {
      REQUIRE(told[k].time == planned[k].time);
      all.push_back((told[k].q - planned[k].q).cwiseAbs().maxCoeff());
    }
    return all;
  }
};

}  // namespace

TEST_CASE("a machine that follows references is led to them once, and told them bit for bit") {
  // x: 0.5 mm at a tenth of 20 mm/s, and two ramps of √(v/j) with j = 1000/2 mm/s³.
  const double join = kOff / 0.002 + 2 * std::sqrt(0.002 / 0.5);
  for (const unsigned seed : {1U, 2U, 3U}) {
    CAPTURE(seed);
    const LateRun run({0.003, 0.008}, seed);
    CHECK(run.done);
    const std::vector<double> off = run.off();
    REQUIRE(off.size() > 1000);
    CHECK(off[0] == doctest::Approx(kOff));
    for (std::size_t k = 0; k < off.size(); ++k) {
      CAPTURE(k);
      const double time = static_cast<double>(k) * kFollowingPeriod;
      if (time < join - 0.05) REQUIRE(off[k] > 0);
      if (time > join + kFollowingPeriod) REQUIRE(off[k] == 0);
    }
  }
}

TEST_CASE(
    "where references come periods late, a machine that follows them is led back every time") {
  for (const unsigned seed : {1U, 2U, 3U}) {
    CAPTURE(seed);
    const LateRun run({0.003, 0.03}, seed);
    CHECK(run.done);
    const std::vector<double> off = run.off();
    REQUIRE(off.size() > 1000);
    // x begins with 1.5·20 mm/s/1.375 s² at most; what a leap of it makes in three periods.
    const double most = 0.5 * (1.5 * 0.020 / 1.375) * 9 * kFollowingPeriod * kFollowingPeriod;
    std::size_t beside = 0;
    for (std::size_t k = 100; k < off.size(); ++k) {
      REQUIRE(off[k] < most);
      beside += off[k] > 0 ? 1 : 0;
    }
    CHECK(beside > 100);
    CHECK(off.back() == 0);
  }
}
