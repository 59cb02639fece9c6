#pragma once

#include <cstdint>

#include "motion/force/press.h"
#include "motion/robots/robot_model.h"
#include "runtime/tick/channels.h"
#include "runtime/tick/tracks.h"

namespace rob::runtime {

/// Holds a force beside the path of the program (PressDesk), and backs off from a force that was
/// too great. Every call but the constructor may be used in the tick.
class Pressing {
 public:
  Pressing(const motion::RobotModel& robot, Channels& channels);

  /// Takes up what the program asks for, and shifts the reference of the track that has the axes.
  /// `felt`: along the world; `held`: the axes shall stand; `now`: of the current cycle, s.
  void follow(Tracks& tracks, const motion::Wrench& felt, bool held, double now) noexcept;

  bool active() const noexcept { return press_.active(); }
  /// See Press::way().
  Eigen::Vector3d way() const noexcept { return press_.way(); }
  /// Where the axes are on their path, without what the PRESS adds; `q`: with it.
  const motion::JointVector& on_path(const motion::JointVector& q) const noexcept {
    return press_.active() ? unpressed_ : q;
  }

  /// Away from the path, on which the axes brake, along the force that is too great, until it is
  /// harmless.
  void back_off() noexcept { backing_off_ = BackOff::Braking; }
  void leave_off() noexcept { backing_off_ = BackOff::None; }
  bool backing_off() const noexcept { return backing_off_ != BackOff::None; }

 private:
  void step(Tracks& tracks, const motion::Wrench& felt, bool braking) noexcept;
  void follow_back_off(Tracks& tracks, const motion::Wrench& felt, double now) noexcept;
  void begin_retreat(const motion::Wrench& felt, double now) noexcept;
  PressDesk::State state() const noexcept;
  void end(Track& program) noexcept;

  Channels& channels_;
  motion::Press press_;
  motion::JointVector unpressed_;
  /// From a force beyond the robot's limit.
  enum class BackOff : std::uint8_t { None, Braking, Retreating, Ending };
  BackOff backing_off_ = BackOff::None;
  double retreats_until_ = 0;  ///< s
};

}  // namespace rob::runtime
