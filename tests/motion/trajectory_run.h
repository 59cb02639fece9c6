#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <functional>
#include <random>
#include <vector>

#include "motion/motion.h"

namespace rob::test {

/// To these axis values, m, rad.
inline motion::MotionRequest move_axes(const motion::JointVector& target) {
  motion::MotionRequest request;
  request.given = static_cast<std::uint8_t>((1 << target.size()) - 1);
  for (int i = 0; i < target.size(); ++i) request.target[static_cast<std::size_t>(i)] = target[i];
  return request;
}

/// Somewhere within this share of the axes' ranges around the start.
inline motion::JointVector somewhere(const motion::RobotModel& robot, std::mt19937& random,
                                     double share = 1) {
  motion::JointVector q = robot.start;
  for (int i = 0; i < q.size(); ++i) {
    const motion::Axis& axis = robot.axes[static_cast<std::size_t>(i)];
    std::uniform_real_distribution<double> place(axis.min, axis.max);
    q[i] += share * (place(random) - q[i]);
  }
  return q;
}

/// Asks for references, each after a turn of planning, until there are no more; `each` is called
/// before each, with its number from 0 on.
struct TrajectoryRun {
  explicit TrajectoryRun(motion::Trajectory& trajectory,
                         const std::function<void(std::size_t)>& each = {},
                         std::size_t most = 1'000'000) {
    motion::JointReference reference;
    while (result == motion::Result::Working && references.size() < most) {
      if (each) each(references.size());
      trajectory.plan();
      result = trajectory.update(reference);
      references.push_back(reference);
    }
  }

  const motion::JointReference& last() const { return references.back(); }

  std::vector<motion::JointReference> references;
  motion::Result result = motion::Result::Working;
};

/// What the steps between references ask of an axis at most, as shares of what it can do.
struct AskedOfAxis {
  double speed = 0;
  double acceleration = 0;
};

/// By differences of the positions alone. Those of second order are a mean of the acceleration, so
/// they cannot exceed its bound.
inline AskedOfAxis asked_of(const motion::RobotModel& robot, int axis,
                            const std::vector<motion::JointReference>& references) {
  const motion::Axis& data = robot.axes[static_cast<std::size_t>(axis)];
  const double period = robot.reference_period;
  AskedOfAxis most;
  for (std::size_t k = 1; k < references.size(); ++k) {
    const double step = references[k].q[axis] - references[k - 1].q[axis];
    most.speed = std::max(most.speed, std::abs(step) / period / data.v_max);
    if (k < 2) continue;
    const double before = references[k - 1].q[axis] - references[k - 2].q[axis];
    most.acceleration =
        std::max(most.acceleration, std::abs(step - before) / (period * period) / data.a_max);
  }
  return most;
}

inline bool same_bits(const motion::JointVector& a, const motion::JointVector& b) {
  return a.size() == b.size() &&
         std::memcmp(a.data(), b.data(), sizeof(double) * static_cast<std::size_t>(a.size())) == 0;
}

inline bool same_bits(const motion::JointReference& a, const motion::JointReference& b) {
  return a.time == b.time && same_bits(a.q, b.q) && same_bits(a.qd, b.qd) &&
         same_bits(a.qdd, b.qdd);
}

}  // namespace rob::test
