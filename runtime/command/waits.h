#pragma once

#include "runtime/command/assumptions.h"
#include "runtime/command/commanded_progress.h"
#include "runtime/command/motion_queue.h"

namespace rob::runtime {

/// WAIT, for a time and for a condition, which is looked at in every cycle while the axes stand.
class Waits {
 public:
  Waits(const RobotLinks& links, Assumptions& assumptions, const CommandedProgress& progress,
        MotionQueue& queue)
      : links_(links), assumptions_(assumptions), progress_(progress), queue_(queue) {}

  lang::Reply wait(int line, double seconds);
  /// `now`: s, once the condition is due.
  lang::Reply stand(int line, double& now);
  lang::Reply waited(int line);
  /// The program has read this signal, in the condition of a WAIT or elsewhere.
  void note_read(int line, int signal);
  /// The current statement waits for a condition, and all that was commanded has acted.
  bool at_rest() const { return standing_ && progress_.has_acted(); }
  /// The current statement is given up.
  void drop() {
    queue_.end_wait();
    standing_ = false;
  }

 private:
  const RobotLinks& links_;
  Assumptions& assumptions_;
  const CommandedProgress& progress_;
  MotionQueue& queue_;
  bool standing_ = false;  ///< it has queued all that it needs
};

}  // namespace rob::runtime
