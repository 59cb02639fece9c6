#include <doctest/doctest.h>

#include <complex>
#include <numbers>

#include "tests/drivers/smoothness_bench.h"
#include "tests/support/no_allocation.h"

// S3's test of its arm, −10° … +10° at 5, 10 and 20 °/s, axis by axis.

namespace rob::test {
namespace {

using motion::ServoStructure;

constexpr ServoStructure kOthers[] = {ServoStructure::PulseTrain, ServoStructure::PositionLoop};

/// What a wave of force at the gear does to the speed, second way: by the impedance of the loop
/// that is closed around the motor, rms as a share of the speed. Encoders' counts are left out.
///
///     Z = D + Dc + J·s + D·(what the servo makes of q')/q'          s = jω
double expected_ripple(int axis, double speed, ServoStructure structure) {
  using namespace std::complex_literals;
  const motion::RobotModel robot = motion::embedded_robot("pc104");
  const auto& [drive, pulses] = std::pair{robot.axes[static_cast<std::size_t>(axis)].drive,
                                          robot.axes[static_cast<std::size_t>(axis)].pulses};
  const auto [kp, kv, ki] = motion::pulse_gains(drive, pulses, structure, robot.servo_period);
  const std::complex<double> s = 2i * std::numbers::pi * speed / pulses.ripple_period;
  std::complex<double> loop = kp / s;
  if (structure == ServoStructure::DoubleLoop) {
    const double omega = drivers::Encoder::kBandwidth;
    const std::complex<double> estimate = std::pow(omega / (omega + s), 2);
    loop = kp * (1 + kv) / s + kv * estimate + ki * (kp / (s * s) + 1.0 / s);
    loop *= std::exp(-s * robot.servo_period / 2.0);  // pulses are spread over the cycle
  }
  const double D = pulses.speed_stiffness;
  const std::complex<double> Z = D + drive.viscous_friction + drive.inertia * s + D * loop;
  return pulses.ripple / std::abs(Z) / std::numbers::sqrt2 / speed;
}

}  // namespace

TEST_CASE("S3: at 20 deg/s axis 6 runs smoother under the double loop than under the other two") {
  const double speed = 20 * kSmoothnessDegree;
  const Smoothness best = run_smoothness(5, speed, ServoStructure::DoubleLoop);
  CHECK(std::abs(best.mean_error) < 0.005);
  for (const ServoStructure structure : kOthers) {
    const Smoothness other = run_smoothness(5, speed, structure);
    CHECK(std::abs(other.mean_error) < 0.005);
    CHECK(best.ripple < 0.6 * other.ripple);
    CHECK(best.peak < 0.6 * other.peak);
    CHECK(best.spikes < other.spikes);
  }
}

TEST_CASE("under the double loop every axis runs the smoothest at every speed") {
  for (const int axis : {0, 2, 3, 5}) {
    for (const double speed : {5.0, 10.0, 20.0}) {
      CAPTURE(axis);
      CAPTURE(speed);
      const double v = speed * kSmoothnessDegree;
      const Smoothness best = run_smoothness(axis, v, ServoStructure::DoubleLoop);
      CHECK(best.spikes == 0);
      for (const ServoStructure structure : kOthers)
        CHECK(best.ripple < run_smoothness(axis, v, structure).ripple);
    }
  }
}

TEST_CASE("the ripple is what the loop's impedance leaves of the gear's wave") {
  // Of axes 4 and 6, where the encoder's counts are small beside the wave.
  for (const int axis : {3, 5}) {
    for (const double speed : {5.0, 10.0, 20.0}) {
      for (const auto structure :
           {ServoStructure::PulseTrain, ServoStructure::PositionLoop, ServoStructure::DoubleLoop}) {
        CAPTURE(axis);
        CAPTURE(speed);
        CAPTURE(static_cast<int>(structure));
        const double v = speed * kSmoothnessDegree;
        CHECK(run_smoothness(axis, v, structure).ripple ==
              doctest::Approx(expected_ripple(axis, v, structure)).epsilon(0.12).scale(0));
      }
    }
  }
}

TEST_CASE("every structure brings the axis to the end of its way") {
  for (const auto structure :
       {ServoStructure::PulseTrain, ServoStructure::PositionLoop, ServoStructure::DoubleLoop}) {
    const Smoothness run = run_smoothness(5, 20 * kSmoothnessDegree, structure);
    double way = 0;
    for (const SmoothnessSample& s : run.samples) way += s.velocity * 1e-3;
    // 0.2 s after the reference. Friction of 0.2 Nm holds one loop off by 0.2/(5·15.1) rad.
    CHECK(way == doctest::Approx(SmoothnessPath::kWay).epsilon(0.02));
  }
}

}  // namespace rob::test
