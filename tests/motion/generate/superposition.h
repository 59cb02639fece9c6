#pragma once

#include <algorithm>
#include <cstddef>
#include <vector>

#include "motion/space/joint_vector.h"

namespace rob::test {

/// S1's law a second time, by another way. Its acceleration in a transition is the change of
/// velocity Δv spread over the pulse 6·h·(1 − h)/(2·t_acc). Integrated twice from rest, a whole
/// motion is the sum, over all via points, of
///
///     velocity Δv·(3h² − 2h³)          position Δv·2·t_acc·(h³ − h⁴/2), then Δv·(time since)
///
/// with h = (t − t_via + t_acc)/(2·t_acc), t_via the instant at which the point would be reached.
class Superposition {
 public:
  Superposition(motion::JointVector start, double t_acc)
      : t_acc_(t_acc), start_(start), last_(start), velocity_(0 * start), next_via_(t_acc) {}

  /// The next target and the segment's time T1.
  void add(const motion::JointVector& target, double t1) {
    const motion::JointVector velocity = (target - last_) / t1;
    changes_.push_back({next_via_, velocity - velocity_});
    last_ = target;
    velocity_ = velocity;
    next_via_ += t1;
  }

  /// After all targets, of which the last must have been given twice: the end.
  double total() const { return next_via_ - t_acc_; }
  /// When segment i (from 1) has t = 0, and when it begins.
  double via(std::size_t i) const { return changes_[i - 1].time; }
  double begin(std::size_t i) const { return via(i) - t_acc_; }

  motion::JointVector q(double t) const {
    motion::JointVector sum = start_;
    for (const Change& change : changes_) {
      const double h = share(t, change);
      const double beyond = std::max(0.0, t - change.time - t_acc_);
      sum += change.velocity * (2 * t_acc_ * (h * h * h - h * h * h * h / 2) + beyond);
    }
    return sum;
  }
  motion::JointVector qd(double t) const {
    motion::JointVector sum = 0 * start_;
    for (const Change& change : changes_) {
      const double h = share(t, change);
      sum += change.velocity * (3 * h * h - 2 * h * h * h);
    }
    return sum;
  }
  motion::JointVector qdd(double t) const {
    motion::JointVector sum = 0 * start_;
    for (const Change& change : changes_) {
      const double h = share(t, change);
      sum += change.velocity * (6 * h * (1 - h) / (2 * t_acc_));
    }
    return sum;
  }

 private:
  struct Change {
    double time;
    motion::JointVector velocity;
  };

  double share(double t, const Change& change) const {
    return std::clamp((t - change.time + t_acc_) / (2 * t_acc_), 0.0, 1.0);
  }

  double t_acc_;
  motion::JointVector start_;
  motion::JointVector last_;
  motion::JointVector velocity_;
  double next_via_;
  std::vector<Change> changes_;
};

}  // namespace rob::test
