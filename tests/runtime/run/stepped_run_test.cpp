#include "tests/support/stepped_run.h"

#include <doctest/doctest.h>

#include <cmath>
#include <cstring>

#include "tests/support/no_allocation.h"

using rob::motion::JointVector;
using rob::runtime::RunResult;
using rob::runtime::Snapshot;
using rob::test::kPublishedProgram;
using rob::test::SteppedRun;

namespace {

/// The gantry, and what its outputs were told last.
struct OutputRecorder final : rob::motion::ServoBackend {
  std::unique_ptr<ServoBackend> machine =
      rob::test::simulated(rob::motion::embedded_robot("gantry"));
  std::uint64_t outputs = 0;

  int axes() const noexcept override { return machine->axes(); }
  void open() override { machine->open(); }
  void close() noexcept override { machine->close(); }
  rob::motion::DriverStatus enable(double now) noexcept override { return machine->enable(now); }
  void disable(double now) noexcept override { machine->disable(now); }
  rob::motion::DriverStatus read(double now, rob::motion::ServoState& state) noexcept override {
    return machine->read(now, state);
  }
  rob::motion::DriverStatus write(double now,
                                  const rob::motion::ServoCommand& command) noexcept override {
    outputs = command.outputs;
    return machine->write(now, command);
  }
};

double greatest(const std::vector<Snapshot>& rows, auto&& value) {
  double most = 0;
  for (const Snapshot& row : rows) most = std::max(most, value(row));
  return most;
}

bool same_bits(const JointVector& a, const JointVector& b) {
  return std::memcmp(a.data(), b.data(), sizeof(double) * static_cast<std::size_t>(a.size())) == 0;
}

}  // namespace

TEST_CASE("the published program takes exactly the time that was foretold") {
  SteppedRun run(kPublishedProgram);
  const RunResult result = run.run();
  CHECK(result.planned == doctest::Approx(19.10).epsilon(1e-12));
  CHECK(result.measured == doctest::Approx(19.10).epsilon(1e-12));
  CHECK(result.cycles == 1910);
  REQUIRE(run.rows.size() == 1911);  // 1910 intervals have 1911 ends
  CHECK(run.rows.front().sample.reference.time == 0.0);
  CHECK(run.rows.back().sample.reference.time == 19.10);
}

TEST_CASE("the last reference is the last target, to the bit") {
  SteppedRun run(kPublishedProgram);
  run.run();
  CHECK(run.rows.back().sample.reference.q[0] == 0.040);
  CHECK(run.rows.back().sample.reference.q[1] == 0.040);
  CHECK(run.rows.back().sample.reference.q[2] == 0.0);
}

TEST_CASE("two runs of one program have the same bits") {
  SteppedRun first(kPublishedProgram);
  SteppedRun second(kPublishedProgram);
  first.run();
  second.run();
  REQUIRE(first.rows.size() == second.rows.size());
  for (std::size_t i = 0; i < first.rows.size(); ++i) {
    CHECK(same_bits(first.rows[i].sample.reference.q, second.rows[i].sample.reference.q));
    CHECK(same_bits(first.rows[i].measured, second.rows[i].measured));
    CHECK(same_bits(first.rows[i].drive, second.rows[i].drive));
  }
}

TEST_CASE("the simulated gantry follows its references within 50 micrometres") {
  SteppedRun run(kPublishedProgram);
  run.run();
  const double worst = greatest(run.rows, [](const Snapshot& row) {
    return (row.measured - row.sample.reference.q).cwiseAbs().maxCoeff();
  });
  CHECK(worst < 50e-6);
  CHECK(worst > 0);  // a plant with friction and an encoder is never exact
}

TEST_CASE("prints and outputs take effect in motion order, at the corner they belong to") {
  SteppedRun run(
      "PRINT \"first\"\n"
      "MOVE(100,0,0)\n"
      "lift = ON\n"
      "PRINT \"corner\"\n"
      "MOVE(100,100,0)\n"
      "lift = OFF\n"
      "STOP\n"
      "PRINT \"done\"\n");
  const RunResult result = run.run();
  CHECK(result.output == std::vector<std::string>{"first", "corner", "done"});
  // Line 2 lasts 5 s and is left at 5.000; its target would be reached t_acc = 1.375 s later.
  // Line 5 is made exact by STOP: its output waits for standstill at 5 + 5 + 2.75 s.
  REQUIRE(result.signals.size() == 2);
  CHECK(result.signals[0].time == doctest::Approx(6.38));  // the first cycle at or after 6.375
  CHECK(result.signals[0].value);
  CHECK(result.signals[0].line == 3);
  CHECK(result.signals[1].time == doctest::Approx(12.75));
  CHECK(result.dropped_effects == 0);
}

TEST_CASE("the lift takes its time, and its input is read when it has arrived") {
  SteppedRun run(
      "lift = ON\n"
      "WHILE NOT lift_up DO\n"
      "ENDWHILE\n"
      "MOVE(10,0,0)\n");
  const RunResult result = run.run();
  REQUIRE(result.lines.size() >= 1);
  double travel = 0;
  for (const auto& actuator : run.robot.actuators) travel = std::max(travel, actuator.travel_time);
  CHECK(result.lines[0].starts >= travel);
  CHECK(result.lines[0].starts <= travel + 0.05);
}

TEST_CASE("an output that is due in the last cycle still reaches the machine") {
  auto machine = std::make_unique<OutputRecorder>();
  const OutputRecorder& recorder = *machine;
  SteppedRun run("MOVE(10,0,0)\nSTOP\ngripper = ON\nEND\n", std::move(machine));
  const RunResult result = run.run();
  REQUIRE(result.signals.size() == 1);
  CHECK(recorder.outputs != 0);
}

TEST_CASE("at standstill an output that was written is read as it was written") {
  SteppedRun run("PRINT lift\nlift = ON\nPRINT lift\nMOVE(10,0,0)\nSTOP\nlift = OFF\nPRINT lift\n");
  CHECK(run.run().output == std::vector<std::string>{"FALSE", "TRUE", "FALSE"});
}

TEST_CASE("override at half lets everything take twice as long on the same path") {
  SteppedRun whole(kPublishedProgram);
  SteppedRun half(kPublishedProgram, nullptr, 0.5);
  const RunResult at_once = whole.run();
  const RunResult slowly = half.run();
  CHECK(slowly.planned == doctest::Approx(38.20));
  CHECK(slowly.measured == doctest::Approx(38.20));
  for (std::size_t i = 0; i < 3; ++i) {
    CHECK(*slowly.lines[i].miss_measured ==
          doctest::Approx(*at_once.lines[i].miss_measured).epsilon(0.01));
  }
}

TEST_CASE("fault 35: a hold slows down on the path and stands within the limits") {
  SteppedRun run(kPublishedProgram);
  run.each_cycle = [&](double time) {
    if (time >= 6.5) run.controller.request_hold();
  };
  const RunResult result = run.run();
  CHECK(result.measured < 7.0);
  const Snapshot& last = run.rows.back();
  CHECK(last.sample.reference.qd.norm() == 0.0);
  // Line 2 runs along y = 40 mm but for its corners: the robot stands on it.
  CHECK(last.sample.reference.q[1] == doctest::Approx(0.040).epsilon(1e-9));
  const double a = greatest(run.rows, [](const Snapshot& row) {
    return row.sample.reference.qdd.head(2).cwiseAbs().maxCoeff();
  });
  CHECK(a <= 0.100);  // a_max of the gantry, m/s²
}

TEST_CASE("fault 8: a target that turns out to be out of reach ends the run behind what was told") {
  SteppedRun run(
      "VAR far = 300mm\n"
      "MOVE(50,0,0)\n"
      "far = far + 200mm\n"
      "MOVE(x: far)\n"
      "MOVE(0,0,0)\n");
  RunResult result = run.run();
  REQUIRE(run.task.failure().has_value());
  CHECK(run.task.failure()->message == "axis x: 500 mm is beyond 400 mm");
  CHECK(run.task.failure()->place.line == 4);
  CHECK(run.rows.back().sample.reference.q[0] == 0.050);  // line 2 was finished, exactly
}

TEST_CASE("a program without END stops as if END stood on the line behind its last one") {
  for (const char* text : {"MOVE(100,0,0)\n", "MOVE(100,0,0)"}) {
    const RunResult result = SteppedRun(text).run();
    REQUIRE(result.lines.size() == 2);
    CHECK(result.lines[0].planned == doctest::Approx(5.0));
    CHECK(result.lines[1].line == 2);
    CHECK(result.lines[1].planned == doctest::Approx(2.75));
  }
}

TEST_CASE("fault 11: targets on the limits are joined by corners inside them") {
  SteppedRun run(
      "MOVE(400,0,180)\nMOVE(400,300,-180)\nMOVE(0,300,180)\nMOVE(0,0,-180)\nMOVE(400,300,0)\n");
  run.run();
  for (const Snapshot& row : run.rows) {
    for (int i = 0; i < 3; ++i) {
      const auto& axis = run.robot.axes[static_cast<std::size_t>(i)];
      const double q = row.sample.reference.q[i];
      if (q < axis.min || q > axis.max) CHECK(q == doctest::Approx(axis.min));
    }
  }
}

TEST_CASE("fault 12: a time that is too short is stretched, with a warning of the true time") {
  SteppedRun run("MOVE(100,0,0) OVER 3s\nMOVE(0,0,0) AT 40mm/s\nMOVE(100,0,0) OVER 8s\n");
  const RunResult result = run.run();
  REQUIRE(result.findings.size() == 2);
  CHECK(result.findings[0].place.line == 1);
  CHECK(result.findings[0].message == "OVER is too short: this motion takes 5 s");
  CHECK(result.findings[1].place.line == 2);
  CHECK(result.lines[0].planned == doctest::Approx(5.0));
  CHECK(result.lines[1].planned == doctest::Approx(5.0));
  CHECK(result.lines[2].planned == doctest::Approx(8.0));
}

TEST_CASE("fault 14: a program that comes too late lets the robot arrive, stand, and go on") {
  SteppedRun run("MOVE(40,0,0)\nMOVE(40,40,0)\n");
  auto& controller = run.controller;
  rob::lang::MoveCommand first;
  first.count = 3;
  first.given = 7;
  first.target = {0.04, 0, 0};
  rob::lang::MoveCommand second = first;
  second.target = {0.04, 0.04, 0};
  controller.machine().move(1, first);
  controller.servo().enable(0);
  for (std::int64_t cycle = 0; !controller.motion().over() && cycle < 3000; ++cycle) {
    controller.servo().cycle(static_cast<double>(cycle) * 0.01);
    controller.motion().cycle(cycle, 0);
    run.recorder.drain();
    if (cycle == 1000) {  // 10 s: long after the decision point of line 1, at 2.75 s
      controller.machine().move(2, second);
      controller.machine().end(3);
    }
  }
  const RunResult result = run.recorder.finish();
  CHECK(result.status == "done");
  CHECK(result.starved == 1);
  REQUIRE(result.events.size() == 1);
  CHECK(result.events[0].kind == "late-decision");
  CHECK(result.events[0].time == doctest::Approx(2.75));
  CHECK(run.rows.at(900).sample.reference.q[0] == 0.04);  // arrived, exactly
  CHECK(run.rows.at(900).sample.reference.qd.norm() == 0.0);
  CHECK(run.rows.back().sample.reference.q[1] == 0.04);
  const double a = greatest(run.rows, [](const Snapshot& row) {
    return row.sample.reference.qdd.head(2).cwiseAbs().maxCoeff();
  });
  CHECK(a <= 1.5 * 0.020 / 1.375 + 1e-12);  // Paul's law's own peak: no jerk out of the ordinary
}

TEST_CASE("fault 13: an endless loop without motion lets the motion end and can be interrupted") {
  SteppedRun run("MOVE(20,0,0)\nWHILE TRUE DO\nENDWHILE\n");
  run.each_cycle = [&](double time) {
    if (time >= 6.0) run.controller.request_hold();
  };
  run.run();
  CHECK(run.rows.back().sample.reference.q[0] == 0.020);
  CHECK(run.rows.back().sample.reference.qd.norm() == 0.0);
}

TEST_CASE("the motion and servo cycles take no memory") {
  SteppedRun run(
      "FOR i = 1 TO 3 DO\n  MOVE(100,0,0)\n  lift = ON\n  MOVE(0,100,0)\n  lift = OFF\nENDFOR\n");
  auto& controller = run.controller;
  run.task.step(1'000'000);
  controller.servo().enable(0);
  int taken = 0;
  std::int64_t cycle = 0;
  for (; !controller.motion().over() && cycle < 100'000; ++cycle) {
    {
      const rob::test::NoAllocation guard;
      if (cycle > 0) controller.servo().cycle((static_cast<double>(cycle) - 0.5) * 0.01);
      controller.servo().cycle(static_cast<double>(cycle) * 0.01);
      controller.motion().cycle(cycle, 0);
      taken += guard.count();
    }
    run.recorder.drain();
    run.task.step(1000);
  }
  CHECK(controller.motion().over());
  CHECK(taken == 0);
}
