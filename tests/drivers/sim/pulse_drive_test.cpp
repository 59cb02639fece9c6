#include "drivers/sim/pulse_drive.h"

#include <doctest/doctest.h>

#include <cmath>

#include "drivers/sim/sim_axis.h"
#include "tests/support/no_allocation.h"
#include "tests/support/relative.h"

namespace rob::drivers {
namespace {

constexpr double kDriveStep = 250e-6;
constexpr double kDrivePeriod = 0.002;

// τ = 0.1/5 = 20 ms, no friction.
motion::DriveData free_axis() {
  motion::DriveData drive;
  drive.inertia = 0.1;
  drive.force_max = 20;
  drive.encoder_resolution = 1e-6;
  return drive;
}

motion::PulseDriveData pulses() {
  motion::PulseDriveData data;
  data.pulse = 1e-4;
  data.speed_stiffness = 5;
  return data;
}

struct Bench {
  SimAxis axis{free_axis()};
  PulseDrive drive;

  explicit Bench(const motion::PulseDriveData& data, double gain = 0)
      : drive(data, kDrivePeriod, gain) {}
  void run(int steps) noexcept {
    for (int k = 0; k < steps; ++k) {
      axis.push(drive.force(kDriveStep, axis.q(), axis.measured_q(), axis.v()));
      axis.advance(kDriveStep);
    }
  }
};

}  // namespace

TEST_CASE("a motor comes up to the rate of its pulses with its time constant") {
  Bench bench(pulses());
  // 8 pulses in 2 ms: 0.4 rad/s. The force is renewed every 250 us: 1/80 of τ, half of it late.
  for (int k = 0; k < 10; ++k) {
    bench.drive.take(8);
    bench.run(8);
  }
  CHECK(bench.axis.v() == test::relative(0.4 * (1 - std::exp(-1.0)), 0.01));
}

TEST_CASE("without friction the axis goes exactly as far as the pulses say") {
  // The force's impulse is 0 from rest to rest: so D·∫(pulses − v)dt is, whatever came when.
  Bench bench(pulses());
  bench.drive.take(30);
  bench.run(3);
  bench.drive.take(-7);  // early: the others wait in line
  bench.run(2000);
  CHECK(std::abs(bench.axis.v()) < 1e-9);
  CHECK(bench.axis.q() == test::relative(23e-4, 1e-9));
}

TEST_CASE("a drive that counts its pulses stands where they say, whatever its gear does") {
  motion::PulseDriveData data = pulses();
  data.ripple = 0.1;
  data.ripple_period = 0.04;
  Bench bench(data, 12.5);
  for (int k = 0; k < 50; ++k) {
    bench.drive.take(8);
    bench.run(8);
  }
  bench.run(4000);
  // At 400 pulses, 0.04 rad, the wave is at 0 and would push away no farther than its slope.
  CHECK(bench.axis.q() == doctest::Approx(0.04).epsilon(1e-4));
}

TEST_CASE("the gear's wave pushes at equal places of every turn") {
  motion::PulseDriveData data = pulses();
  data.ripple = 0.3;
  data.ripple_period = 0.04;
  PulseDrive drive(data, kDrivePeriod, 0);
  CHECK(drive.force(kDriveStep, 0.01, 0, 0) == test::relative(0.3));
  CHECK(drive.force(kDriveStep, 0.05, 0, 0) == test::relative(0.3));
  CHECK(drive.force(kDriveStep, 0.03, 0, 0) == test::relative(-0.3));
  CHECK(std::abs(drive.force(kDriveStep, 0.04, 0, 0)) < 1e-12);
}

TEST_CASE("pulses that are no number count as none") {
  Bench bench(pulses());
  bench.drive.take(std::nan(""));
  bench.run(100);
  CHECK(bench.axis.q() == 0);
}

TEST_CASE("a pulse drive takes no memory") {
  Bench bench(pulses(), 12.5);
  test::NoAllocation guard;
  bench.drive.take(8);
  bench.run(8);
  bench.drive.clear(0);
  CHECK(guard.count() == 0);
}

}  // namespace rob::drivers
