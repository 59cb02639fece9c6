#pragma once

#include <array>
#include <cmath>
#include <optional>
#include <vector>

#include "drivers/sim/sim_arm.h"
#include "motion/robots/robot_library.h"
#include "motion/servo/reference_interpolator.h"
#include "motion/servo/servo_law.h"
#include "tests/support/degrees.h"

namespace rob::test {

/// The UMS-7 under its servo: references every 40 ms as S2's kinematics gives them, the servo at a
/// period of its own, and an arm that may differ from what the servo believes.

inline constexpr double kKinematicPeriod = 0.040;
inline constexpr double kTourTime = 9;

/// From the start and back by way of two postures in 3 s each, at rest in each: quintics, at up to
/// 56 deg/s in axes 1 to 3 and 94 deg/s in the hand.
inline motion::JointReference tour(double t) {
  static constexpr double kPostures[4][6] = {{0, -45, 135, 0, 90, 0},
                                             {90, 0, 90, 60, 20, 150},
                                             {30, -80, 60, -90, -60, 0},
                                             {0, -45, 135, 0, 90, 0}};
  const double leg = std::fmin(std::fmax(std::floor(t / 3), 0), 2);
  const double s = std::fmin(std::fmax(t / 3 - leg, 0), 1);
  const auto from = static_cast<std::size_t>(leg);
  motion::JointReference r{t, motion::JointVector(6), motion::JointVector(6),
                           motion::JointVector(6)};
  for (int i = 0; i < 6; ++i) {
    const double begin = kPostures[from][i] * kDegree;
    const double way = kPostures[from + 1][i] * kDegree - begin;
    r.q[i] = begin + way * s * s * s * (10 + s * (6 * s - 15));
    r.qd[i] = way * 30 * s * s * (1 - s) * (1 - s) / 3;
    r.qdd[i] = way * 60 * s * (1 - s) * (1 - 2 * s) / 9;
  }
  return r;
}

struct TrackingCase {
  double servo_period = 0.020;  ///< s, whole milliseconds
  bool feed_forward = true;
  double payload = 0;     ///< kg that the servo does not know
  double masses = 1;      ///< factor of the table's coefficients
  double friction = 1;    ///< factor
  double bandwidth = 40;  ///< rad/s; 0.2/servo_period if that is less
};

inline motion::RobotModel ums7(double bandwidth) {
  motion::RobotModel robot = motion::embedded_robot("ums7");
  for (motion::Axis& axis : robot.axes) axis.drive.bandwidth = bandwidth;
  return robot;
}

inline std::vector<motion::DriveData> drives_of(const motion::RobotModel& robot) {
  std::vector<motion::DriveData> drives;
  for (const motion::Axis& axis : robot.axes) drives.push_back(axis.drive);
  return drives;
}

/// The arm as it really is.
inline drivers::SimArmParameters real_arm(const motion::RobotModel& robot, const TrackingCase& c) {
  motion::ArmMechanics mechanics = robot.mechanics.value();
  const motion::Ums7Parameters p = motion::scaled(mechanics.dynamics.parameters(), c.masses);
  mechanics.dynamics = motion::Ums7Dynamics(motion::with_payload(p, c.payload, 0.4, 0.4, 0.1));
  return {drives_of(robot), mechanics, robot.start, {}, c.friction};
}

/// A run of the tour, millisecond by millisecond.
class ArmBench {
 public:
  explicit ArmBench(const TrackingCase& c)
      : robot_(ums7(c.bandwidth)),
        arm_(real_arm(robot_, c)),
        law_(drives_of(robot_), c.servo_period, robot_.mechanics),
        interpolator_(kKinematicPeriod, limits(&motion::Axis::v_max), limits(&motion::Axis::a_max),
                      limits(&motion::Axis::j_max)),
        every_(static_cast<int>(std::lround(c.servo_period * 1000))) {
    if (!c.feed_forward) law_.leave_out_feed_forward();
    arm_.open();
    arm_.enable(0);
    law_.reset(0);
    interpolator_.reset(tour(0));
    command_.drive = motion::JointVector::Zero(6);
  }

  /// The next millisecond; true while the tour goes on.
  bool step() noexcept {
    const double t = now();
    if (millisecond_ % 40 == 0) interpolator_.push(tour(t + kKinematicPeriod));
    arm_.read(t, state_);
    for (int i = 0; i < 6; ++i) error_[i] = tour(t).q[i] - arm_.true_position(i);
    if (millisecond_ % every_ == 0) {
      command_.reference = interpolator_.at(t);
      command_.drive = law_.update(t, command_.reference, state_.measured);
      arm_.write(t, command_);
    }
    ++millisecond_;
    return now() < kTourTime;
  }

  double now() const noexcept { return millisecond_ * 1e-3; }
  /// Where the axes should have been less where they really were in the last step, rad.
  const motion::JointVector& error() const noexcept { return error_; }
  const motion::ServoCommand& command() const noexcept { return command_; }
  const motion::RobotModel& robot() const noexcept { return robot_; }
  motion::ServoLaw& law() noexcept { return law_; }

 private:
  motion::JointVector limits(double motion::Axis::*limit) const {
    motion::JointVector values(6);
    for (int i = 0; i < 6; ++i) values[i] = robot_.axes[static_cast<std::size_t>(i)].*limit;
    return values;
  }

  motion::RobotModel robot_;
  drivers::SimArm arm_;
  motion::ServoLaw law_;
  motion::ReferenceInterpolator interpolator_;
  int every_;
  int millisecond_ = 0;
  motion::ServoState state_;
  motion::ServoCommand command_;
  motion::JointVector error_ = motion::JointVector::Zero(6);
};

struct Tracking {
  motion::JointVector rms = motion::JointVector::Zero(6);  ///< rad
  motion::JointVector worst = motion::JointVector::Zero(6);
};

inline Tracking track(const TrackingCase& c) {
  ArmBench bench(c);
  Tracking tracking;
  int samples = 0;
  bool goes_on = true;
  while (goes_on) {
    goes_on = bench.step();
    tracking.rms += bench.error().cwiseAbs2();
    tracking.worst = tracking.worst.cwiseMax(bench.error().cwiseAbs());
    ++samples;
  }
  tracking.rms = (tracking.rms / samples).cwiseSqrt();
  return tracking;
}

}  // namespace rob::test
