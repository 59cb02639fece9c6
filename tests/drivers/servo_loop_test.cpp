#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <vector>

#include "drivers/sim/sim_gantry.h"
#include "tests/drivers/gantry_bench.h"
#include "tests/support/degrees.h"
#include "tests/support/no_allocation.h"

// The servo law on the simulated gantry: 5 ms, counts of 1 µm, velocities estimated.

namespace rob::drivers {
namespace {

using motion::FollowingFinding;
using motion::JointVector;
using rob::test::kDegree;

struct Followed {
  JointVector worst = JointVector::Zero(3);  // |where the axis is − reference|
  int findings = 0;
};

Followed follow_shuttle(double coulomb) {
  SimGantry gantry(test::gantry_parameters(coulomb));
  test::GantryBench bench(gantry, test::gantry_drives(coulomb));
  Followed followed;
  while (bench.now() < test::kShuttleTime) {
    const motion::JointReference reference = test::shuttle(bench.now());
    const FollowingFinding found = bench.cycle(reference);
    followed.findings += found.verdict != FollowingFinding::Verdict::None ? 1 : 0;
    for (int i = 0; i < 3; ++i) {
      const double error = std::abs(gantry.true_position(i) - reference.q[i]);
      followed.worst[i] = std::max(followed.worst[i], error);
    }
  }
  return followed;
}

motion::JointReference x_at(double q, double t) {
  motion::JointReference reference = test::GantryBench::standing(JointVector::Zero(3));
  reference.q[0] = q;
  reference.time = t;
  return reference;
}

// What is left of a step of 0.1 mm along x.
struct Settled {
  double overshoot = 0;
  double error = 0;  // the worst after 3 s
  double force = 0;  // the greatest after 3 s
};

Settled step_response(const motion::DriveData& plant, const motion::DriveData& believed,
                      double jitter) {
  constexpr double kStep = 100e-6;
  SimGantry gantry({{plant}, JointVector::Zero(1), {}});
  gantry.open();
  gantry.enable(0);
  motion::ServoLaw law(std::vector{believed}, test::kServoPeriod);
  law.reset(0);
  std::mt19937 random(7);
  std::uniform_real_distribution<double> late(0, jitter);
  const JointVector zero = JointVector::Zero(1);
  motion::ServoState state;
  motion::ServoCommand command;
  Settled settled;
  for (int k = 0; k < 1200; ++k) {
    const double t = k * test::kServoPeriod + late(random);
    gantry.read(t, state);
    command.drive = law.update(t, {t, JointVector::Constant(1, kStep), zero, zero}, state.measured);
    gantry.write(t, command);
    const double error = gantry.true_position(0) - kStep;
    settled.overshoot = std::max(settled.overshoot, error);
    if (t < 3) continue;
    settled.error = std::max(settled.error, std::abs(error));
    settled.force = std::max(settled.force, std::abs(command.drive[0]));
  }
  return settled;
}

}  // namespace

TEST_CASE("the gantry follows the triangle's speeds and accelerations to 0.05 mm") {
  for (const double coulomb : {0.0, 0.1, 0.3, 0.5}) {
    CAPTURE(coulomb);
    const Followed followed = follow_shuttle(coulomb);
    CHECK(followed.worst[0] < 0.05e-3);
    CHECK(followed.worst[1] < 0.05e-3);
    CHECK(followed.worst[2] < 0.02 * kDegree);
    CHECK(followed.findings == 0);
  }
}

TEST_CASE("the integral takes Coulomb friction out of a steady motion") {
  SimGantry gantry(test::gantry_parameters(0.5));
  test::GantryBench bench(gantry, test::gantry_drives(0.5));
  double early = 0;
  double late = 0;
  while (bench.now() < 3.9) {
    const motion::JointReference reference = test::shuttle(bench.now());
    bench.cycle(reference);
    const double error = std::abs(gantry.true_position(0) - reference.q[0]);
    if (bench.now() < 0.9) early = std::max(early, error);
    if (bench.now() > 2.5) late = std::max(late, error);
  }
  CHECK(early > 0.5 * 0.5 / 19200);  // C/kp would stay without it
  CHECK(late < 2e-6);
}

TEST_CASE("quantised positions and estimated velocities leave the loop stable") {
  const motion::DriveData drive = test::gantry_drives()[0];
  for (const double coulomb : {0.0, 0.1, 0.3, 0.5}) {
    CAPTURE(coulomb);
    motion::DriveData plant = drive;
    plant.coulomb_friction = coulomb;
    const Settled settled = step_response(plant, drive, 0);
    // (ω²s + ω³/10)/(s³ + 2ωs² + ω²s + ω³/10) overshoots by 14.5%; a count more.
    CHECK(settled.overshoot < 15.5e-6);
    CHECK(settled.error < 3e-6);
    CHECK(settled.force < coulomb + 0.4);  // two counts of kp, kv·one count a sample of 5 ms
  }
}

TEST_CASE("the loop is stable with an axis of half or twice the inertia, and late cycles") {
  const motion::DriveData believed = test::gantry_drives()[0];
  for (const double factor : {0.5, 1.0, 2.0}) {
    CAPTURE(factor);
    motion::DriveData plant = believed;
    plant.inertia *= factor;
    const Settled settled = step_response(plant, believed, 0.002);
    CHECK(settled.overshoot < 50e-6);
    CHECK(settled.error < 3e-6);
  }
}

TEST_CASE("a step that asks for more than the drive has is taken without winding up") {
  SimGantry gantry(test::gantry_parameters());
  test::GantryBench bench(gantry, test::gantry_drives());
  double overshoot = 0;
  double most = 0;
  while (bench.now() < 3) {
    bench.cycle(x_at(0.020, bench.now()));  // 384 N are asked for, 60 are there
    most = std::max(most, std::abs(bench.command().drive[0]));
    overshoot = std::max(overshoot, gantry.true_position(0) - 0.020);
  }
  CHECK(most == 60);
  CHECK(bench.law().take_saturation() > 6);
  CHECK(overshoot < 0.15 * 0.020);
  while (bench.now() < 6) bench.cycle(x_at(0.020, bench.now()));
  CHECK(std::abs(gantry.true_position(0) - 0.020) < 2e-6);
}

TEST_CASE("a whole servo cycle takes no memory") {
  SimGantry gantry(test::gantry_parameters());
  test::GantryBench bench(gantry, test::gantry_drives());
  test::NoAllocation guard;
  for (int k = 0; k < 100; ++k) bench.cycle(test::shuttle(bench.now()));
  CHECK(guard.count() == 0);
  CHECK(gantry.true_position(0) > 0);
}

}  // namespace rob::drivers
