#include "drivers/sim/sim_gantry.h"

#include <doctest/doctest.h>

#include <cmath>
#include <stdexcept>
#include <vector>

#include "tests/drivers/gantry_bench.h"
#include "tests/support/no_allocation.h"
#include "tests/support/relative.h"

namespace rob::drivers {
namespace {

using motion::DriverStatus;
using motion::JointVector;

JointVector three(double x, double y, double theta) {
  JointVector v(3);
  v << x, y, theta;
  return v;
}

motion::ServoCommand drive_with(const JointVector& drive, std::uint64_t outputs = 0) {
  motion::ServoCommand command;
  command.drive = drive;
  command.outputs = outputs;
  return command;
}

motion::ServoState read(SimGantry& gantry, double now) {
  motion::ServoState state;
  CHECK(gantry.read(now, state) == DriverStatus::Ok);
  return state;
}

}  // namespace

TEST_CASE("the simulated gantry powers up at its start position, at rest") {
  SimGantryParameters parameters = test::gantry_parameters();
  parameters.start = three(0.04, 0.0400004, 0);
  SimGantry gantry(parameters);
  gantry.open();
  const motion::ServoState state = read(gantry, 12.5);
  CHECK(state.measured.time == 12.5);
  CHECK(state.measured.q[0] == test::relative(0.04, 1e-15));
  CHECK(state.measured.q[1] == test::relative(0.04, 1e-15));  // a whole count
  CHECK(state.measured.qd.isZero(0));
  CHECK(gantry.axes() == 3);
}

TEST_CASE("each axis obeys its own inertia and friction") {
  SimGantry gantry(test::gantry_parameters(0));
  gantry.open();
  gantry.enable(0);
  gantry.write(0, drive_with(three(2, -1, 0)));
  const double t = 0.2;
  const motion::ServoState state = read(gantry, t);
  // v = (u/b)·(1 − exp(−b·t/m)), q = (u/b)·t − (m/b)·v
  const double v = 0.5 * (1 - std::exp(-t / 3));
  CHECK(gantry.true_position(0) == test::relative(0.5 * t - 3 * v));
  CHECK(gantry.true_position(1) == test::relative(-0.5 * (0.5 * t - 3 * v)));
  CHECK(gantry.true_position(2) == 0);
  CHECK(std::abs(state.measured.q[0] - gantry.true_position(0)) <= 0.5e-6);
  // The estimate is 2/ω behind.
  CHECK(state.measured.qd[0] == test::relative(v - 2.0 / 600 * (2 - 4 * v) / 12, 0.01));
}

TEST_CASE("drives that are not enabled give no force, whatever is written") {
  SimGantry gantry(test::gantry_parameters(0));
  gantry.open();
  gantry.write(0, drive_with(three(60, 60, 2)));
  CHECK(read(gantry, 1).measured.q.isZero(0));
  gantry.enable(1);
  CHECK(read(gantry, 2).measured.q.isZero(0));  // holds until the first write
  gantry.write(2, drive_with(three(60, 0, 0)));
  CHECK(read(gantry, 2.1).measured.q[0] > 0.01);
}

TEST_CASE("after disable friction brings the axes to rest, and they stay there") {
  SimGantry gantry(test::gantry_parameters(0.3));
  gantry.open();
  gantry.enable(0);
  gantry.write(0, drive_with(three(6, 0, 0)));
  gantry.disable(0.05);
  const double v = (6 - 0.3) / 4 * (1 - std::exp(-0.05 / 3));
  const double stops_after = 3 * std::log(1 + 4 * v / 0.3);
  CHECK(read(gantry, 0.05 + 0.9 * stops_after).measured.qd[0] > 0);
  const double q = read(gantry, 0.05 + 1.1 * stops_after + 0.1).measured.q[0];
  const motion::ServoState late = read(gantry, 100);
  CHECK(late.measured.q[0] == q);
  CHECK(late.measured.qd[0] == 0);
}

TEST_CASE("drives that hear nothing for a quarter of a second brake and hold by themselves") {
  for (const double asked_at : {SimGantry::kWatchdog, 0.4, 60.0}) {
    SimGantry gantry(test::gantry_parameters(0));
    gantry.open();
    gantry.enable(0);
    gantry.write(1, drive_with(three(2, 0, 0)));
    const motion::ServoState state = read(gantry, 1 + asked_at);
    // v = 0.5·(1 − exp(−0.25/3)) = 40 mm/s; 60 N on 12 kg brake it in 8 ms, on 0.16 mm.
    const double v = 0.5 * (1 - std::exp(-SimGantry::kWatchdog / 3));
    const double q = 0.5 * SimGantry::kWatchdog - 3 * v;
    if (asked_at == SimGantry::kWatchdog) {
      CHECK(gantry.true_position(0) == test::relative(q));
      CHECK(state.measured.qd[0] == test::relative(v, 0.02));
      continue;
    }
    CHECK(gantry.true_position(0) == test::relative(q + v * v * 12 / (2 * 60), 1e-4));
    CHECK(state.measured.qd[0] == 0);
  }
}

TEST_CASE("drives that are written to in time are not cut in on") {
  SimGantry gantry(test::gantry_parameters(0));
  gantry.open();
  gantry.enable(0);
  for (int k = 0; k < 10; ++k) gantry.write(0.2 * k, drive_with(three(2, 0, 0)));
  const double v = 0.5 * (1 - std::exp(-2.0 / 3));
  read(gantry, 2.0);
  CHECK(gantry.true_position(0) == test::relative(0.5 * 2 - 3 * v));
}

TEST_CASE("however long a call was awaited, the answer is the same to a count") {
  SimGantry rare(test::gantry_parameters());
  SimGantry often(test::gantry_parameters());
  for (SimGantry* gantry : {&rare, &often}) {
    gantry->open();
    gantry->enable(0);
    gantry->write(0, drive_with(three(3, -2, 0.01)));
  }
  for (int k = 1; k < 40; ++k) read(often, k * 0.005);
  const motion::ServoState a = read(rare, 0.2);
  const motion::ServoState b = read(often, 0.2);
  for (int i = 0; i < 3; ++i) {
    CHECK(rare.true_position(i) == test::relative(often.true_position(i), 1e-10));
    // The estimates are equally late, by 2% of the velocity here.
    CHECK(a.measured.qd[i] == test::relative(b.measured.qd[i], 0.005));
  }
}

TEST_CASE("the same calls at the same times give the same bits") {
  const auto run = [] {
    SimGantry gantry(test::gantry_parameters());
    test::GantryBench bench(gantry, test::gantry_drives());
    std::vector<double> bits;
    while (bench.now() < 3) {
      bench.cycle(test::shuttle(bench.now()));
      for (int i = 0; i < 3; ++i) {
        bits.push_back(bench.state().measured.q[i]);
        bits.push_back(bench.state().measured.qd[i]);
        bits.push_back(bench.command().drive[i]);
      }
    }
    return bits;
  };
  CHECK(run() == run());
}

TEST_CASE("lift and gripper travel while the axes move, and report where they stand") {
  SimGantryParameters parameters = test::gantry_parameters();
  parameters.actuators = {{0, 0, 1, 0.5}, {1, 2, 3, 0.1}};
  SimGantry gantry(parameters);
  gantry.open();
  CHECK(read(gantry, 0).inputs == 0b0101);
  gantry.write(0, drive_with(JointVector::Zero(3), 0b11));
  CHECK(read(gantry, 0.05).inputs == 0b0000);
  CHECK(read(gantry, 0.10).inputs == 0b1000);
  CHECK(read(gantry, 0.50).inputs == 0b1010);
  gantry.write(0.50, drive_with(JointVector::Zero(3), 0b01));
  CHECK(read(gantry, 0.60).inputs == 0b0110);
}

TEST_CASE("opened again, the gantry is as after power-up") {
  SimGantryParameters parameters = test::gantry_parameters();
  parameters.actuators = {{0, 0, 1, 0.5}};
  SimGantry gantry(parameters);
  gantry.open();
  gantry.enable(0);
  gantry.write(0, drive_with(three(60, 60, 2), 1));
  read(gantry, 1);
  gantry.close();
  gantry.open();
  const motion::ServoState state = read(gantry, 50);
  CHECK(state.measured.q.isZero(0));
  CHECK(state.measured.qd.isZero(0));
  CHECK(state.inputs == 1);
}

TEST_CASE("a gantry that makes no sense is refused") {
  SimGantryParameters parameters = test::gantry_parameters();
  parameters.start = JointVector::Zero(2);
  CHECK_THROWS_AS(SimGantry{parameters}, std::invalid_argument);
  parameters = test::gantry_parameters();
  parameters.actuators = {{64, 0, 1, 0.5}};
  CHECK_THROWS_AS(SimGantry{parameters}, std::invalid_argument);
}

TEST_CASE("the simulated gantry takes no memory in the tick") {
  SimGantryParameters parameters = test::gantry_parameters();
  parameters.actuators = {{0, 0, 1, 0.5}};
  SimGantry gantry(parameters);
  gantry.open();
  const motion::ServoCommand command = drive_with(three(3, 0, 0), 1);
  motion::ServoState state;
  test::NoAllocation guard;
  gantry.enable(0);
  gantry.read(0, state);
  gantry.write(0, command);
  gantry.read(0.005, state);
  gantry.read(3, state);
  gantry.disable(3);
  CHECK(guard.count() == 0);
  CHECK(state.measured.q[0] > 0);
}

}  // namespace rob::drivers
