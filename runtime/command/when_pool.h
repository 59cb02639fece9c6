#pragma once

#include <deque>
#include <string>
#include <vector>

#include "lang/vm/vm.h"
#include "motion/generate/rest.h"
#include "motion/plan/watched_action.h"
#include "runtime/command/program_watch.h"

namespace rob::runtime {

/// The WHENs of a program, between the program's thread, which sets them up, and the tick, which
/// asks them. A place is used again when the tick has done with it. All calls come from the
/// program's thread; only set_up() takes memory.
class WhenPool {
 public:
  /// Both must outlive it.
  WhenPool(const std::vector<lang::RobotSignature::Signal>& signals,
           const motion::RobotModel& robot)
      : signals_(signals), robot_(robot) {}

  /// A place for a WHEN in this line, and its number; null while all are in use.
  motion::WatchedAction* set_up(int line, const lang::Watch& condition, int& id);
  /// One that is armed, and that nobody has asked to disarm yet; null: none.
  motion::WatchedAction* first_in_use();
  int id_of(const motion::WatchedAction& action) const;
  motion::WatchedAction& at(int id) { return places_.at(static_cast<std::size_t>(id)).action; }
  /// The error that `action` raises.
  void set_error(motion::WatchedAction& action, const lang::Place& written, std::string text);
  /// The error that a Rest which a WHEN has caused means.
  lang::RuntimeError error_of(const motion::Rest& rest);

 private:
  struct Place {
    Place(const std::vector<lang::RobotSignature::Signal>& signals, const motion::RobotModel& robot)
        : watch(signals, robot) {}

    motion::WatchedAction action;
    ProgramWatch watch;
    std::string text;     ///< of its RAISE
    lang::Place written;  ///< the same
  };

  Place& place_of(const motion::WatchedAction& action);

  const std::vector<lang::RobotSignature::Signal>& signals_;
  const motion::RobotModel& robot_;
  std::deque<Place> places_;
};

}  // namespace rob::runtime
