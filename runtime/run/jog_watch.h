#pragma once

#include <memory>
#include <vector>

#include "motion/collision/clearance.h"
#include "motion/collision/jog_room.h"
#include "motion/robots/robot_model.h"
#include "runtime/tick/channels.h"

namespace rob::runtime {

/// Measures the distances around the robot for its jogs, and hands them over to the tick
/// (motion::JogRoom). look() is called every reference period: in real time by a thread of its own,
/// on the virtual clock by the one that there is.
class JogWatch {
 public:
  JogWatch(const motion::RobotModel& robot, Channels& channels);

  /// Whether the robot's file names anything that could be hit.
  bool used() const { return channels_.jog_room.used(); }
  /// Measures, once a jog has been commanded.
  void look();

 private:
  /// A pair, and when it was measured.
  struct Measured {
    double distance = 0;       // m, then
    motion::JointVector gone;  // how far each axis had gone in all
    double now = 0;            // m that it is apart at least
  };

  using Shared = std::shared_ptr<const motion::Clearance>;

  void watch(const Shared& clearance);
  void go_on_to(const motion::JointVector& q);
  void measure(const motion::JointVector& q);
  motion::JogRoom::Near near_at(std::size_t pair, const motion::JointVector& q) const;
  double distance(std::size_t pair, const motion::JointVector& q) const;

  const double period_;
  Channels& channels_;
  Shared clearance_;
  std::vector<Measured> pairs_;
  std::vector<std::size_t> order_;  ///< the nearest first, as far as they are looked at
  std::size_t turn_ = 0;
  motion::JointVector last_;
  motion::JointVector gone_;
  motion::JogRoom::View view_;
};

}  // namespace rob::runtime
