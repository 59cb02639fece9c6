#pragma once

#include <algorithm>
#include <cmath>
#include <initializer_list>
#include <numbers>
#include <utility>

#include <doctest/doctest.h>

#include "motion/generate/velocity_mode.h"
#include "motion/robots/robot_library.h"

namespace rob::test {

inline motion::JogRates jog_rates(motion::JogRates::Space space,
                                  std::initializer_list<double> rates) {
  motion::JogRates jog;
  jog.space = space;
  jog.rate.resize(static_cast<Eigen::Index>(rates.size()));
  std::ranges::copy(rates, jog.rate.begin());
  return jog;
}

inline motion::JointVector joints_deg(std::initializer_list<double> degrees) {
  motion::JointVector q(static_cast<Eigen::Index>(degrees.size()));
  std::ranges::copy(degrees, q.begin());
  return q * (std::numbers::pi / 180);
}

/// A robot in velocity mode, stepped by hand, and how near to its limits it came.
struct JogBench {
  motion::RobotModel robot;
  motion::VelocityMode mode{robot};
  double speed = 0;         ///< greatest share of v_max, of any axis so far
  double acceleration = 0;  ///< of a_max
  double jerk = 0;          ///< of j_max: of what the acceleration changes within a period
  double out = -1;          ///< m, rad beyond the limits of an axis
  /// What is left of a change of position where speed and acceleration of its ends are taken off,
  /// as a share of j_max·T³: 0 of a constant jerk, great of a leap.
  double leap = 0;

  explicit JogBench(motion::RobotModel model) : robot(std::move(model)) {
    mode.stand_at(robot.start);
  }
  explicit JogBench(const char* name) : JogBench(motion::embedded_robot(name)) {}
  JogBench(const char* name, const motion::JointVector& q) : JogBench(name) { mode.stand_at(q); }

  const motion::JointVector& q() const { return mode.reference().q; }
  motion::Pose tool() const { return robot.kinematics->forward(q()); }

  void step(double share = 1) {
    const motion::JointReference before = mode.reference();
    mode.step(share);
    const motion::JointReference& now = mode.reference();
    const double t = robot.reference_period;
    for (int i = 0; i < robot.axis_count(); ++i) {
      const motion::Axis& axis = robot.axes[static_cast<std::size_t>(i)];
      REQUIRE(std::isfinite(now.q[i]));
      const double bent = now.qdd[i] - before.qdd[i];
      speed = std::max(speed, std::abs(now.qd[i]) / axis.v_max);
      acceleration = std::max(acceleration, std::abs(now.qdd[i]) / axis.a_max);
      jerk = std::max(jerk, std::abs(bent) / t / axis.j_max);
      out = std::max({out, now.q[i] - axis.max, axis.min - now.q[i]});
      const double left = now.q[i] - before.q[i] - (before.qd[i] + now.qd[i]) * (t / 2);
      leap = std::max(leap, std::abs(left + bent * (t * t / 12)) / (axis.j_max * t * t * t));
    }
  }
  void run(const motion::JogRates& rates, double seconds, double share = 1) {
    REQUIRE(mode.takes(rates));
    mode.aim(rates);
    for (int i = 0; i * robot.reference_period < seconds; ++i) step(share);
  }
  /// Periods until it stands.
  int come_to_rest() {
    int periods = 0;
    for (; !mode.stands() && periods < 10'000; ++periods) step(0);
    REQUIRE(mode.stands());
    return periods;
  }
  void check_limits() const {
    constexpr double kRounding = 2e-6;
    CHECK(speed <= 1 + kRounding);
    CHECK(acceleration <= 1 + kRounding);
    CHECK(jerk <= 1 + kRounding);
    CHECK(out <= 2e-9);
    CHECK(leap <= 1.0 / 48 + 1e-3);
  }
};

}  // namespace rob::test
