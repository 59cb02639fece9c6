#pragma once

#include <memory>

#include "motion/robots/robot_model.h"
#include "motion/servo/following_supervisor.h"
#include "motion/servo/reference_history.h"
#include "motion/servo/reference_interpolator.h"
#include "motion/servo/servo.h"
#include "motion/servo/servo_backend.h"
#include "motion/servo/still_watch.h"
#include "runtime/tick/channels.h"
#include "runtime/tick/lateness.h"
#include "runtime/tick/touch.h"
#include "runtime/time/clock.h"

namespace rob::runtime {

/// One servo cycle (S2's dynamic part): reads the machine, follows the references, supervises,
/// writes. cycle() is a tick: no memory, no lock, no text, bounded work. One thread calls it.
///
/// After a gap that cannot be made up nobody knows where the machine is: its drives may have
/// braked, or gone on. So nothing is written until the machine has reported a position again. From
/// there, with the velocity that it has there, the servo brakes it to rest by itself; references no
/// longer count. The gap is a finding in each of these cycles. Shorter gaps end in
/// the same way if they come so often that the axes fall too far behind their references.
class ServoTask {
 public:
  ServoTask(const motion::RobotModel& robot, motion::ServoBackend& backend, Channels& channels);

  /// Takes the robot as it stands, its inputs too: call once, before the first cycle and before the
  /// program's first step. The cycles that follow judge the machine's
  /// answer.
  void enable(double now) noexcept;
  /// The drives stay without force, and a hand may move the axes: where they are is only read.
  void guide(double now) noexcept;
  /// `due` is when this cycle was to begin. A machine that follows references gets its position
  /// at that instant, for which the reference has been there for a period; what is computed here is
  /// computed for `now`.
  void cycle(double now, double due) noexcept {
    take_references();
    run(now, due);
  }
  void cycle(double now) noexcept { cycle(now, now); }
  /// In real time: looks at the clock after it has taken the references. The other way round a
  /// thread that is kept waiting in between would find references for a time after its `now`, and
  /// the axes would be sent ahead.
  void cycle(const Clock& clock, double due) noexcept {
    take_references();
    run(clock.now(), due);
  }
  /// The drives are without force from now on; further cycles only read.
  void disable() noexcept;

 private:
  motion::DriverStatus read_machine(double now) noexcept;
  void learn_stand(double now) noexcept;
  void take_references() noexcept;
  void run(double now, double due) noexcept;
  bool find_machine(double instant, motion::DriverStatus read) noexcept;
  void follow(double now, motion::DriverStatus read) noexcept;
  motion::FollowingFinding overrun() const noexcept;
  void take_as_it_stands(double now) noexcept;
  motion::JointReference found_at(double instant) const noexcept;
  void tell(const motion::FollowingFinding& finding) noexcept;
  motion::FollowingFinding judge(motion::DriverStatus status) noexcept;

  motion::ServoBackend& backend_;
  Channels& channels_;
  motion::ReferenceInterpolator interpolator_;
  std::unique_ptr<motion::Servo> servo_;
  const motion::CarriedLoad* carried_ = nullptr;  ///< that the servo knows of
  motion::FollowingSupervisor supervisor_;
  motion::ReferenceHistory history_;
  Lateness lateness_;
  Touch touch_;
  double followed_ = 0;  ///< when the references were followed last
  motion::ServoState state_;
  motion::StillWatch still_;
  motion::ServoCommand command_;
  motion::DriverStatus written_ = motion::DriverStatus::Ok;
  double now_ = 0;  ///< of the last call
  bool enabled_ = false;
  bool guided_ = false;
  bool answers_ = true;  ///< the machine
};

}  // namespace rob::runtime
