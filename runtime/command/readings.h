#pragma once

#include <span>

#include "lang/machine/reading.h"
#include "runtime/command/commanded_progress.h"
#include "runtime/command/guard.h"
#include "runtime/command/motion_queue.h"

namespace rob::runtime {

/// Where the robot is, and where it would be. `setting`: the tool and the frame that are meant.
/// `refuse`: of the machine that is asked.
class Readings {
 public:
  Readings(const RobotLinks& links, const CommandedProgress& progress, const Guard& guard,
           MotionQueue& queue)
      : links_(links), progress_(progress), guard_(guard), queue_(queue) {}

  /// At the instant that the program's motions have come to.
  lang::Reply read(lang::Reading what, const lang::Setting& setting, lang::Slot* value);
  /// In the current cycle.
  lang::Reply current(lang::Reading what, const lang::Setting& setting, lang::Slot* value,
                      const Refuse& refuse) const;
  lang::PoseValue forward(const lang::Setting& setting, std::span<const double> joints) const;
  /// `near` empty: the last target.
  lang::Reply inverse(const lang::Setting& setting, const lang::PoseValue& pose,
                      std::span<const double> near, std::span<double> joints, const Refuse& refuse);

 private:
  lang::Reply felt(lang::Reading what, lang::Slot* value, const Refuse& refuse) const;

  const RobotLinks& links_;
  const CommandedProgress& progress_;
  const Guard& guard_;
  MotionQueue& queue_;
};

}  // namespace rob::runtime
