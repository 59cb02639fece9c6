#include "motion/servo/pulse_servo.h"

#include <doctest/doctest.h>

#include <array>
#include <cmath>
#include <limits>

#include "tests/support/no_allocation.h"
#include "tests/support/relative.h"

namespace rob::motion {
namespace {

using test::relative;

constexpr double kPulsePeriod = 0.002;
constexpr double kPulse = 1e-5;

// The last axis of S3's arm: 0.1 kg·m², Dc = 0.5, D = 5 Nm/(rad/s), 20 Nm, 40 rad/s.
DriveData last_axis() {
  DriveData drive;
  drive.inertia = 0.1;
  drive.viscous_friction = 0.5;
  drive.force_max = 20;
  drive.bandwidth = 40;
  return drive;
}

PulseDriveData its_pulses() {
  PulseDriveData pulses;
  pulses.pulse = kPulse;
  pulses.speed_stiffness = 5;
  return pulses;
}

PulseServo servo_of(ServoStructure structure) {
  PulseServo servo(std::array{last_axis()}, std::array{its_pulses()}, structure, kPulsePeriod);
  servo.reset(0);
  return servo;
}

JointVector one(double x) { return JointVector::Constant(1, x); }
JointReference reference(double q, double qd) { return {0, one(q), one(qd), one(0)}; }
JointMeasurement measured(double q, double qd) { return {0, one(q), one(qd)}; }

}  // namespace

TEST_CASE("one loop around a pulse drive is critically damped") {
  // J·q'' = D·(−kp·q − q') − Dc·q' has both poles at −(D + Dc)/2J = −27.5/s.
  const PulseGains gains =
      pulse_gains(last_axis(), its_pulses(), ServoStructure::PositionLoop, kPulsePeriod);
  CHECK(0.1 * 27.5 * 27.5 == relative(5 * gains.kp));
  CHECK(gains.kv == 0);
  CHECK(gains.ki == 0);
}

TEST_CASE("the double loop has its velocity pole at four times the bandwidth") {
  // (D·(1 + kv) + Dc)/J = 160/s; kp a quarter of it, and the integral at half of that.
  const PulseGains gains =
      pulse_gains(last_axis(), its_pulses(), ServoStructure::DoubleLoop, kPulsePeriod);
  CHECK((5 * (1 + gains.kv) + 0.5) / 0.1 == relative(160));
  CHECK(gains.kp == relative(40));
  CHECK(gains.ki == relative(20 * (1 + gains.kv)));
}

TEST_CASE("a slow servo takes back the double loop, and never turns it round") {
  // At 10 ms ω_v = 40/s, less than the drive has by itself, 55/s.
  const PulseGains gains = pulse_gains(last_axis(), its_pulses(), ServoStructure::DoubleLoop, 0.01);
  CHECK(gains.kp == relative(10));
  CHECK(gains.kv == 0);
  CHECK(gains.ki == relative(5));
}

TEST_CASE("a pulse train adds up to the reference, one cycle ahead, without losing a pulse") {
  PulseServo servo = servo_of(ServoStructure::PulseTrain);
  double sum = 0;
  double worst = 0;
  for (int k = 0; k <= 1500; ++k) {
    const double t = k * kPulsePeriod;
    // There and back, at rest at both ends, in 3 s.
    const double phase = 2 * 3.14159265358979 / 3;
    const double q = 0.3 + 0.1 * (1 - std::cos(phase * t));
    const double qd = 0.1 * phase * std::sin(phase * t);
    // Wherever the axis is: nothing of it is looked at after the first cycle.
    const double pulses = servo.update(t, reference(q, qd), measured(k == 0 ? 0.3 : 99, 5))[0];
    CHECK(pulses == std::nearbyint(pulses));
    sum += pulses;
    worst = std::max(worst, std::abs(0.3 + sum * kPulse - (q + qd * kPulsePeriod)));
  }
  CHECK(worst <= 0.5 * kPulse + 1e-12);
}

TEST_CASE("loops send what their formulas say, the rest of a pulse in the next cycle") {
  PulseServo position = servo_of(ServoStructure::PositionLoop);
  // v = 0.02·1.1 + 15.125·0.001 = 0.037125 rad/s: 7.425 pulses a cycle.
  double sum = 0;
  for (int k = 0; k < 40; ++k)
    sum += position.update(k * kPulsePeriod, reference(1.001, 0.02), measured(1, 0))[0];
  CHECK(sum == 297);  // 40 · 7.425
  PulseServo both = servo_of(ServoStructure::DoubleLoop);
  // v* = 0.06; v = 0.06 + 2.1·(0.06 − 0.01) + 62·0: 33 pulses. Two ms later the integral is 1e-4.
  CHECK(both.update(0, reference(1.001, 0.02), measured(1, 0.01))[0] == 33);
  CHECK(both.update(kPulsePeriod, reference(1.001, 0.02), measured(1, 0.01))[0] == 34);  // 34.24
}

TEST_CASE("the loops ask for no more than the motor has, say so, and wind nothing up") {
  for (const auto structure : {ServoStructure::PositionLoop, ServoStructure::DoubleLoop}) {
    PulseServo servo = servo_of(structure);
    // 20 Nm / 5 Nm/(rad/s): 4 rad/s beside the 0.5 rad/s that it has.
    for (int k = 0; k < 100; ++k)
      CHECK(servo.update(k * kPulsePeriod, reference(2, 0), measured(1, 0.5))[0] == 900);
    CHECK(servo.take_saturation() > 3);
    CHECK(servo.take_saturation() == 0);
    // Standing where it should be there is nothing left of it.
    CHECK(servo.update(100 * kPulsePeriod, reference(1, 0), measured(1, 0))[0] == 0);
  }
}

TEST_CASE("an axis without a number gets no pulses") {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  for (const auto structure :
       {ServoStructure::PulseTrain, ServoStructure::PositionLoop, ServoStructure::DoubleLoop}) {
    PulseServo servo = servo_of(structure);
    CHECK(servo.update(0, reference(1, 0), measured(1, 0))[0] == 0);
    CHECK(servo.update(kPulsePeriod, reference(nan, 0), measured(1, 0))[0] == 0);
    // The next one counts again.
    CHECK(servo.update(2 * kPulsePeriod, reference(1.001, 0), measured(1, 0))[0] > 0);
  }
}

TEST_CASE("the pulse servo takes no memory") {
  PulseServo servo = servo_of(ServoStructure::DoubleLoop);
  const JointReference r = reference(1, 0.1);
  const JointMeasurement m = measured(1, 0.1);
  test::NoAllocation guard;
  servo.reset(0);
  CHECK(servo.update(kPulsePeriod, r, m)[0] != 0);
  CHECK(servo.take_saturation() < 1);
  CHECK(guard.count() == 0);
}

}  // namespace rob::motion
