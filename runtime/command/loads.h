#pragma once

#include "runtime/command/commanded_progress.h"
#include "runtime/command/load_book.h"
#include "runtime/command/program_effects.h"
#include "runtime/command/robot_links.h"

namespace rob::runtime {

/// The load of the arm: the tool of WITH, and LOAD. Motion and planner learn of it before the next
/// motion.
class Loads {
 public:
  Loads(const RobotLinks& links, ProgramEffects& effects, const CommandedProgress& progress)
      : links_(links), effects_(effects), progress_(progress) {}

  /// Its mass counts from the next motion on.
  void mount(const lang::ToolValue& tool);
  /// An object beside the tool. known() must be true.
  void grasp(const lang::LoadCommand& load);
  /// Sends motion the load that is new from here on. `Later` while that is not known, or there is
  /// no room.
  lang::Reply tell(int line);
  /// Whether motion and this side agree on the load. After a doubt they do again once all that was
  /// commanded has acted.
  bool known();

  /// Another side has changed the load.
  void doubt() { book_.doubt(); }
  /// The last change may have been dropped.
  void doubt_where_told() {
    book_.doubt_where_told(links_.channels.carried.load(std::memory_order_acquire));
  }
  bool doubted() const { return book_.doubted(); }
  /// The tool is again the one that a handler has found.
  void put_tool_back() { book_.put_tool_back(); }

  /// The load that motion was given last; null for nothing. It keeps its address.
  const motion::CarriedLoad* last() const { return book_.last(); }
  /// The planner reckons with that again.
  void plan_with_last() { links_.planner.carry(book_.told().all()); }

 private:
  const RobotLinks& links_;
  ProgramEffects& effects_;
  const CommandedProgress& progress_;
  LoadBook book_;
};

}  // namespace rob::runtime
