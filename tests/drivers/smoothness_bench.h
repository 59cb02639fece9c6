#pragma once

#include <algorithm>
#include <cmath>
#include <vector>

#include "drivers/sim/sim_gantry.h"
#include "motion/robots/robot_library.h"
#include "motion/servo/pulse_servo.h"

namespace rob::test {

/// S3's test: one axis of its arm by itself, from −10° to +10° at a constant speed, and the
/// velocity that the axis really has.

inline constexpr double kSmoothnessDegree = 3.14159265358979323846 / 180;

/// Where the axis should be: −10° … +10°, with the ramps of 100 °/s² [choice: 0.2 s to 20 °/s].
class SmoothnessPath {
 public:
  explicit SmoothnessPath(double speed) : v_(speed) {}

  double ramp() const { return v_ / kA; }
  double end() const { return kWay / v_ + ramp(); }
  motion::JointReference at(double t) const {
    const double up = std::clamp(t, 0.0, ramp());
    const double down = std::clamp(t - (end() - ramp()), 0.0, ramp());
    const double flat = std::clamp(t - ramp(), 0.0, end() - 2 * ramp());
    const double q = -kWay / 2 + 0.5 * kA * up * up + v_ * flat + (v_ - 0.5 * kA * down) * down;
    const bool speeds_up = t > 0 && t < ramp();
    const bool brakes = t > end() - ramp() && t < end();
    const auto vector = [](double x) { return motion::JointVector::Constant(1, x); };
    return {t, vector(q), vector(kA * (up - down)), vector(speeds_up ? kA : brakes ? -kA : 0)};
  }

  static constexpr double kWay = 20 * kSmoothnessDegree;
  static constexpr double kA = 100 * kSmoothnessDegree;  // rad/s²

 private:
  double v_;
};

struct SmoothnessSample {
  double t = 0;         ///< s
  double wanted = 0;    ///< rad/s
  double velocity = 0;  ///< rad/s, the true one over the millisecond
};

struct Smoothness {
  std::vector<SmoothnessSample> samples;
  double mean_error = 0;  ///< of the mean velocity, share of the speed
  double ripple = 0;      ///< rms about the mean, share of the speed
  double peak = 0;        ///< greatest distance from the mean, share of the speed
  int spikes = 0;         ///< times it leaves mean ± kSpike, to come back to half of that
};

/// Of the speed. [choice] Well above what a count of the encoder makes of it.
inline constexpr double kSpike = 0.03;

/// What is measured of a run: where the speed is constant, from 0.2 s after its ramp on [choice:
/// the loops have settled by then], to where it brakes.
inline void judge_smoothness(const SmoothnessPath& path, double speed, Smoothness& found) {
  std::vector<double> steady;
  for (const SmoothnessSample& s : found.samples)
    if (s.t > path.ramp() + 0.2 && s.t < path.end() - path.ramp()) steady.push_back(s.velocity);
  double sum = 0;
  for (const double v : steady) sum += v;
  const double mean = sum / static_cast<double>(steady.size());
  double squares = 0;
  bool outside = false;
  for (const double v : steady) {
    const double off = std::abs(v - mean) / speed;
    squares += off * off;
    found.peak = std::max(found.peak, off);
    if (off > kSpike && !outside) ++found.spikes;
    outside = off > (outside ? kSpike / 2 : kSpike);
  }
  found.mean_error = mean / speed - 1;
  found.ripple = std::sqrt(squares / static_cast<double>(steady.size()));
}

/// `axis` from 0; `speed` in rad/s.
inline Smoothness run_smoothness(int axis, double speed, motion::ServoStructure structure) {
  const motion::RobotModel robot = motion::embedded_robot("pc104");
  const motion::Axis& data = robot.axes[static_cast<std::size_t>(axis)];
  const bool counts = structure == motion::ServoStructure::PulseTrain;
  const double gain =
      motion::pulse_gains(data.drive, data.pulses, structure, robot.servo_period).kp;
  const SmoothnessPath path(speed);
  drivers::SimGantry machine(
      {{data.drive}, path.at(0).q, {}, {{data.pulses, robot.servo_period, counts ? gain : 0}}});
  motion::PulseServo servo({&data.drive, 1}, {&data.pulses, 1}, structure, robot.servo_period);
  machine.enable(0);
  servo.reset(0);
  motion::ServoState state;
  motion::ServoCommand command;
  Smoothness found;
  const int every = static_cast<int>(std::lround(robot.servo_period * 1000));
  double before = machine.true_position(0);
  for (int k = 0; k * 1e-3 < path.end() + 0.2; ++k) {
    const double t = k * 1e-3;
    machine.read(t, state);
    if (k > 0) {
      const double q = machine.true_position(0);
      found.samples.push_back({t, path.at(t - 0.5e-3).qd[0], (q - before) * 1000});
      before = q;
    }
    if (k % every != 0) continue;
    command.reference = path.at(t);
    command.drive = servo.update(t, command.reference, state.measured);
    machine.write(t, command);
  }
  judge_smoothness(path, speed, found);
  return found;
}

}  // namespace rob::test
