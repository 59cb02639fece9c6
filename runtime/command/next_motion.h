#pragma once

#include <cstddef>
#include <deque>
#include <optional>
#include <utility>
#include <vector>

#include "lang/machine/machine.h"
#include "runtime/command/commanded.h"
#include "runtime/command/program_watch.h"
#include "runtime/command/robot_links.h"

namespace rob::runtime {

/// All that a program says about a motion before it commands it: what is done on its way, points
/// that it goes through, AT LIVE. In a PATH what is done on the way counts along all of
/// it.
class NextMotion {
 public:
  explicit NextMotion(const RobotLinks& links) : links_(links) {}

  /// The next SET or PULSE is done at this place.
  void on_the_way(const lang::PathPlace& place) { place_ = place; }
  /// Takes an effect that belongs to such a place; whether there is one.
  bool takes(const motion::Effect& effect);
  void via(const lang::MoveCommand& point) { via_.push_back(point); }
  void live_pace(const lang::Watch& pace, lang::MoveCommand::Pace means);

  // Each hands over what there is, once.
  std::vector<OnTheWay> take_events() { return std::exchange(events_, {}); }
  std::vector<lang::MoveCommand> take_via() { return std::exchange(via_, {}); }
  std::optional<ProgramPace> take_live() { return std::exchange(live_, std::nullopt); }

  void drop_events() { events_.clear(); }
  void drop();

 private:
  const RobotLinks& links_;
  std::optional<lang::PathPlace> place_;
  std::vector<OnTheWay> events_;
  std::vector<lang::MoveCommand> via_;
  std::optional<ProgramPace> live_;
  std::deque<ProgramWatch> paces_;  ///< a ring: the ticks ask those of motions under way
  std::size_t next_pace_ = 0;
};

}  // namespace rob::runtime
