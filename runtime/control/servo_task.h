#pragma once

#include <memory>

#include "motion/robots/robot_model.h"
#include "motion/servo/following_supervisor.h"
#include "motion/servo/reference_history.h"
#include "motion/servo/reference_interpolator.h"
#include "motion/servo/servo.h"
#include "motion/servo/servo_backend.h"
#include "runtime/control/channels.h"

namespace rob::runtime {

/// One servo cycle (S2's dynamic part): reads the machine, follows the references, supervises,
/// writes. cycle() is a tick: no memory, no lock, no text, bounded work. One thread calls it.
class ServoTask {
 public:
  ServoTask(const motion::RobotModel& robot, motion::ServoBackend& backend, Channels& channels);

  /// Takes the robot as it stands, its inputs too: call once, before the first cycle and before the
  /// program's first step. What the machine answers is judged by the cycles that follow.
  void enable(double now) noexcept;
  /// The drives stay without force, and a hand may move the axes: where they are is only read.
  void guide(double now) noexcept;
  /// `due` is when this cycle was to begin. A machine that follows references is told where to be
  /// at that instant, for which the reference has been there for a period; what is computed here is
  /// computed for `now`.
  void cycle(double now, double due) noexcept;
  void cycle(double now) noexcept { cycle(now, now); }
  /// The drives are without force from now on; further cycles only read.
  void disable() noexcept;

 private:
  void learn_stand(double now) noexcept;
  void take_as_it_stands(double now) noexcept;
  motion::JointReference found_at(double instant) const noexcept;
  bool references_are_coming(double now, double gap) const noexcept;
  void tell(const motion::FollowingFinding& finding) noexcept;
  motion::FollowingFinding judge(motion::DriverStatus status, double gap) noexcept;

  motion::ServoBackend& backend_;
  Channels& channels_;
  motion::ReferenceInterpolator interpolator_;
  std::unique_ptr<motion::Servo> servo_;
  motion::FollowingSupervisor supervisor_;
  motion::ReferenceHistory history_;
  double reference_period_;
  double bridged_gap_;  ///< s that the interpolator bridges by itself
  double longest_gap_;
  double newest_ = 0;    ///< stamp of the newest reference
  double followed_ = 0;  ///< when the references were followed last
  motion::ServoState state_;
  motion::ServoCommand command_;
  motion::DriverStatus written_ = motion::DriverStatus::Ok;
  double now_ = 0;  ///< of the last call
  bool enabled_ = false;
  bool guided_ = false;
};

}  // namespace rob::runtime
