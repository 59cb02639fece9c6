#pragma once

#include <cstdint>
#include <string_view>

#include "lang/vm/vm.h"
#include "runtime/command/commanded_progress.h"
#include "runtime/command/effect_queue.h"
#include "runtime/command/robot_links.h"
#include "runtime/command/when_pool.h"

namespace rob::runtime {

/// The WHENs of a program: set up, armed and disarmed in motion order. Between begin() and its
/// action a WHEN is in the making.
class Whens {
 public:
  Whens(const RobotLinks& links, EffectQueue& effects, const CommandedProgress& progress)
      : links_(links),
        effects_(effects),
        progress_(progress),
        pool_(links.signature.signals, links.robot) {}

  /// `Later` while all places are in use; `id`: its number.
  lang::Reply begin(int line, const lang::Watch& condition, int& id);
  /// Whether what is set or pulsed next is the action of one in the making.
  bool in_the_making() const { return making_ != nullptr; }
  // Its action, with which it is armed.
  lang::Reply act(const motion::Effect& effect);
  lang::Reply raise(const lang::Place& place, std::string_view text);
  lang::Reply handle(bool stops);
  /// The one in the making is given up.
  void drop() { making_ = nullptr; }

  lang::Reply disarm(int line, int id);
  /// Every one; false while there is no room for that.
  bool disarm_all(int line);
  /// Whether every one that is armed has been looked at, and what came of it is known here.
  bool watched();

  int id_of(const motion::WatchedAction& action) const { return pool_.id_of(action); }
  lang::RuntimeError error_of(const motion::Rest& rest) { return pool_.error_of(rest); }

 private:
  lang::Reply arm();
  lang::Reply disarm(int line, motion::WatchedAction& action);

  const RobotLinks& links_;
  EffectQueue& effects_;
  const CommandedProgress& progress_;
  WhenPool pool_;
  motion::WatchedAction* making_ = nullptr;
  int armed_ = 0;                    ///< those that are not disarmed yet
  std::int64_t last_arming_ = 0;     ///< the effect that armed the last one, as pushed() counts
  std::int64_t watched_since_ = -1;  ///< the cycle in which it was first seen armed; -1: not yet
};

}  // namespace rob::runtime
