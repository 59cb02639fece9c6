// When a run ends: a machine that follows its references later has come to rest by its own account,
// where it was sent.
#include <doctest/doctest.h>

#include <memory>
#include <utility>

#include "tests/support/stepped_run.h"

using rob::motion::DriverStatus;
using rob::motion::JointVector;
using rob::runtime::RunResult;
using rob::test::SteppedRun;

namespace {

/// A machine that goes to its last command within a cycle. From `late_at` on its wire's thread is
/// kept waiting for `late` s: nothing is sent, not even the last command, and it reports nothing.
class Kept final : public rob::motion::ServoBackend {
 public:
  Kept(double late_at, double late) : late_at_(late_at), late_(late) {
    goal_ = at_ = rob::motion::embedded_robot("gantry").start;
  }
  int axes() const noexcept override { return 3; }
  void open() override {}
  void close() noexcept override {}
  DriverStatus enable(double) noexcept override { return {}; }
  void disable(double) noexcept override {}
  bool follows_references() const noexcept override { return true; }

  DriverStatus read(double now, rob::motion::ServoState& state) noexcept override {
    const bool waited = std::exchange(waits_, now >= late_at_ && now < late_at_ + late_);
    if (waits_) return DriverStatus::Pending;
    if (!waited) at_ = goal_;
    state.measured = {now, at_, JointVector::Zero(3)};
    state.seen = now;
    return DriverStatus::Ok;
  }
  DriverStatus write(double, const rob::motion::ServoCommand& command) noexcept override {
    if (!waits_) goal_ = command.reference.q;
    return DriverStatus::Ok;
  }

 private:
  double late_at_;
  double late_;
  bool waits_ = false;
  JointVector goal_;
  JointVector at_;
};

}  // namespace

TEST_CASE("a run does not end while the wire has not sent its last references") {
  for (const double before_end : {0.30, 0.20, 0.15, 0.10, 0.05}) {
    CAPTURE(before_end);
    const char* const program = "MOVE(140,40,0)\nSTOP\n";
    const double planned = SteppedRun(program).run().planned;
    SteppedRun run(program, std::make_unique<Kept>(planned - before_end, 0.19));
    const RunResult result = run.run();
    CHECK(result.status == "done");
    const auto& last = run.rows.back();
    CHECK(last.measured[0] == doctest::Approx(0.140).epsilon(1e-6));
  }
}
