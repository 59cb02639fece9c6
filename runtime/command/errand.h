#pragma once

#include <cstdint>

#include "runtime/command/handler_turns.h"

namespace rob::runtime {

/// On the side of handlers: the handler that has the axes, from where it has found them until they
/// are back there, or the path is left.
class Errand {
 public:
  Errand(const RobotLinks& links, const CommandedProgress& progress, Loads& loads,
         MotionQueue& queue)
      : links_(links), progress_(progress), loads_(loads), queue_(queue) {}

  /// `program`: whose motion it has interrupted. `home`: where the axes stand, m, rad.
  void begin(HandlerTurns& program, const motion::JointVector& home);
  /// Whether any has begun: it is the one that commands.
  bool begun() const { return program_ != nullptr; }
  /// BRAKE: it is the interrupted motion that ends.
  void end_path() { returns_ = false; }
  /// It has said what the arm carries: the program carries that, too.
  void tell_load() { program_->doubt_load(); }
  /// It is over; Done when the program may go on.
  lang::Reply leave(int line);

  // An error in it ends it and all that it has interrupted.
  bool asked() const { return leaving_ == Leaving::Asked; }
  void leave_all() { ask(AfterHandler::LeaveAll); }

 private:
  enum class Leaving : std::uint8_t { No, Stopping, Moving, Asked };

  lang::Reply move_back(int line);
  void ask(AfterHandler what) {
    links_.channels.after_handler.store(what);
    leaving_ = Leaving::Asked;
  }

  const RobotLinks& links_;
  const CommandedProgress& progress_;
  Loads& loads_;
  MotionQueue& queue_;
  HandlerTurns* program_ = nullptr;
  motion::JointVector home_;
  bool returns_ = true;
  Leaving leaving_ = Leaving::No;
};

}  // namespace rob::runtime
