// The rows of docs/faults.md that are about motion, each under its number.
#include <doctest/doctest.h>

#include <cmath>
#include <memory>

#include "tests/support/faulty_backend.h"
#include "tests/support/stepped_run.h"

using rob::motion::ServoBackend;
using rob::runtime::ExitCode;
using rob::runtime::RunResult;
using rob::runtime::Snapshot;
using rob::test::FaultyBackend;
using rob::test::kPublishedProgram;
using rob::test::SteppedRun;
using Fault = rob::test::FaultyBackend::Fault;

namespace {

/// A FaultyBackend together with the machine that it spoils.
class SpoiltGantry final : public ServoBackend {
 public:
  SpoiltGantry(Fault fault, double from)
      : machine_(rob::test::simulated(rob::motion::embedded_robot("gantry"))), faulty_(*machine_) {
    faulty_.inject(fault, from);
  }
  int axes() const noexcept override { return faulty_.axes(); }
  void open() override { faulty_.open(); }
  void close() noexcept override { faulty_.close(); }
  rob::motion::DriverStatus enable(double now) noexcept override { return faulty_.enable(now); }
  void disable(double now) noexcept override { faulty_.disable(now); }
  rob::motion::DriverStatus read(double now, rob::motion::ServoState& state) noexcept override {
    return faulty_.read(now, state);
  }
  rob::motion::DriverStatus write(double now,
                                  const rob::motion::ServoCommand& command) noexcept override {
    return faulty_.write(now, command);
  }

 private:
  std::unique_ptr<ServoBackend> machine_;
  FaultyBackend faulty_;
};

struct FaultRun {
  SteppedRun run;
  RunResult result;

  explicit FaultRun(Fault fault, double from = 4.0)
      : run(kPublishedProgram, std::make_unique<SpoiltGantry>(fault, from)), result(run.run()) {}

  void stands_within_limits() const {
    for (const Snapshot& row : run.rows) {
      CHECK(row.sample.reference.q.allFinite());
      CHECK(row.sample.reference.qd.head(2).cwiseAbs().maxCoeff() <= 0.020 + 1e-12);
      CHECK(row.sample.reference.qdd.head(2).cwiseAbs().maxCoeff() <= 0.100 + 1e-12);
    }
    CHECK(run.rows.back().sample.reference.qd.norm() == 0.0);
  }
};

void check_fault(const FaultRun& fault, const char* code) {
  CHECK(fault.result.status == "fault");
  CHECK(fault.result.exit_code == ExitCode::Fault);
  REQUIRE(fault.result.error.has_value());
  CHECK(fault.result.error->code == code);
  CHECK(fault.result.error->place.line == 2);  // x moves on line 2 at 4 s
  CHECK_FALSE(fault.result.error->help.empty());
  CHECK(fault.result.measured > 4.0);
  CHECK(fault.result.measured < 5.5);  // stopped at once, not at the end of the program
  fault.stands_within_limits();
}

}  // namespace

TEST_CASE("fault 18: a locked joint is warned of, then stops the run with axis and error") {
  const FaultRun fault(Fault::LockedJoint);
  check_fault(fault, "E502");
  CHECK(fault.result.error->message.find("axis x is ") == 0);
  bool warned = false;
  for (const auto& event : fault.result.events) {
    if (event.kind == "warning") warned = true;
    if (event.kind == "fault") break;
  }
  CHECK(warned);
}

TEST_CASE("fault 19: a frozen encoder stops the run and names the axis") {
  const FaultRun fault(Fault::FrozenEncoder);
  CHECK(fault.result.exit_code == ExitCode::Fault);
  REQUIRE(fault.result.error.has_value());
  CHECK(fault.result.error->message.find("axis x") != std::string::npos);
  fault.stands_within_limits();
}

TEST_CASE("fault 19: a jumping encoder stops the run and names the axis") {
  const FaultRun fault(Fault::JumpingEncoder);
  check_fault(fault, "E504");
}

TEST_CASE("fault 7: a position that is no number stops the run; no such reference is sent") {
  const FaultRun fault(Fault::NotANumber);
  check_fault(fault, "E505");
}

TEST_CASE("fault 28: a silent machine stops the run within three servo periods") {
  const FaultRun fault(Fault::Silent);
  check_fault(fault, "E506");
  for (const auto& event : fault.result.events) {
    if (event.kind == "fault") CHECK(event.time <= 4.0 + 3 * 0.005 + 1e-9);
  }
}

TEST_CASE("a machine that is gone stops the run at once") {
  check_fault(FaultRun(Fault::Lost), "E507");
}

TEST_CASE("a fault drops the effects behind it and says how many") {
  SteppedRun run("MOVE(100,0,0)\nlift = ON\nPRINT \"never\"\nMOVE(0,0,0)\n",
                 std::make_unique<SpoiltGantry>(Fault::Silent, 2.0));
  const RunResult result = run.run();
  CHECK(result.output.empty());
  CHECK(result.signals.empty());
  CHECK(result.dropped_effects == 2);
}

TEST_CASE("faults 15 and 16: late ticks up to 200 ms are made up, a later one holds the robot") {
  for (const int missed : {1, 5, 10, 15, 19, 21, 100}) {
    SteppedRun run(kPublishedProgram);
    run.task.step(1'000'000);
    run.controller.servo().enable(0);
    std::int64_t cycle = 0;
    for (; !run.controller.motion().over() && cycle < 5000; ++cycle) {
      if (cycle == 400) cycle += missed;  // at 4 s the tick does not come
      run.controller.servo().cycle(static_cast<double>(cycle) * 0.01);
      run.controller.motion().cycle(cycle, 0);
      run.recorder.drain();
    }
    const RunResult result = run.recorder.finish();
    CAPTURE(missed);
    if (missed < 20) {
      CAPTURE(result.error ? result.error->message : "");
      CHECK(result.status == "done");
      CHECK(result.measured == doctest::Approx(19.10).epsilon(1e-9));
    }
    if (missed > 21) {
      CHECK(result.status == "fault");
      CHECK(result.error->code == "E501");
      // It stands near where it was, not where it should be by then (x = 40 mm + …).
      CHECK(run.rows.back().sample.reference.q[0] < 0.072);
    }
    CHECK(run.rows.back().sample.reference.qd.norm() == 0.0);
  }
}
