#pragma once

#include <Eigen/Core>

#include "motion/plan/segment_descriptor.h"
#include "motion/robots/robot_model.h"
#include "runtime/command/program_log.h"
#include "runtime/words/messages.h"

namespace rob::runtime {

/// On the program's side: which exact motions wait until the measured robot is in position, and
/// whether it is in position after all that was commanded. The generator does the waiting.
class Settling {
 public:
  Settling(const motion::RobotModel& robot, ProgramLog& log) : robots_(robot.settle), log_(log) {}

  /// While a program is foretold nothing waits: what is foretold is the reference's time.
  void leave_out() { left_out_ = true; }

  /// The window that FINE, STOP and WAIT wait for. `own`: the distance written after FINE, m, 0
  /// without one. `tip`: of the tool, seen from the flange.
  motion::SettleWindow window(double own, const Eigen::Vector3d& tip) const {
    motion::SettleWindow window = robots_;
    if (own > 0) window.distance = own;
    window.tip = tip;
    return window;
  }
  /// Lets a segment that ends at rest wait for it.
  void ask(motion::SegmentDescriptor& segment, const motion::SettleWindow& window) const {
    if (!left_out_) segment.settle = window;
    if (left_out_ && window.present()) log_.found(note_on_settling());
  }

  /// `segment` is commanded after all else.
  void follow(const motion::SegmentDescriptor& segment) {
    if (segment.settle.present()) {
      settled_ = segment.settle.distance <= robots_.distance;
    } else if (!segment.dwell) {
      settled_ = false;
    }
  }
  /// The axes have come to rest elsewhere.
  void lose() { settled_ = false; }
  /// Whether a STOP has nothing to wait for where the axes stand already.
  bool settled() const { return settled_ || left_out_ || !robots_.present(); }

 private:
  motion::SettleWindow robots_;
  ProgramLog& log_;
  bool left_out_ = false;
  bool settled_ = true;
};

}  // namespace rob::runtime
