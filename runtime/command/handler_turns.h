#pragma once

#include <cstdint>
#include <optional>

#include "runtime/command/motion_commands.h"
#include "runtime/command/whens.h"

namespace rob::runtime {

/// On the program's side: whose turn it is, the program's or that of a handler of its WHENs, and
/// what becomes of the motion that a handler has interrupted.
class HandlerTurns {
 public:
  HandlerTurns(const RobotLinks& links, const Whens& whens, CommandedProgress& progress,
               Surroundings& surroundings, Guard& guard, Loads& loads, MotionQueue& queue,
               MotionCommands& commands)
      : links_(links),
        whens_(whens),
        progress_(progress),
        surroundings_(surroundings),
        guard_(guard),
        loads_(loads),
        queue_(queue),
        commands_(commands) {}

  /// A WHEN whose handler must begin now.
  struct Begun {
    int id;                    ///< as Whens::begin() has said
    bool stops;                ///< the axes stand, and it has them; else they go on
    motion::JointVector home;  ///< where they stand, m, rad
  };
  std::optional<Begun> begin();
  /// A handler has the axes.
  bool has_axes() const { return turn_ == Turn::HasAxes; }
  /// A handler that did not stop the axes is over.
  void end_call();
  /// No handler may begin while an error of the program is settled, and after its end.
  void bar(bool barred);

  // A handler that has the axes is over
  /// The axes are back on the path.
  void go_on() { turn_ = Turn::None; }
  /// The interrupted motion has ended where the axes stand now: what was queued after it starts
  /// from there. `Later` until motion says where that is.
  lang::Reply leave_path(const Refuse& refuse);
  /// All that was commanded is dropped; false until motion says where the axes stand.
  bool leave_all();
  /// The handler has said what the arm carries.
  void doubt_load() { loads_.doubt(); }

 private:
  enum class Turn : std::uint8_t { None, HasAxes, LetsThemGoOn };

  void decline();

  const RobotLinks& links_;
  const Whens& whens_;
  CommandedProgress& progress_;
  Surroundings& surroundings_;
  Guard& guard_;
  Loads& loads_;
  MotionQueue& queue_;
  MotionCommands& commands_;
  Turn turn_ = Turn::None;
};

}  // namespace rob::runtime
