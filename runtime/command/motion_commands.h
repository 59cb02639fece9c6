#pragma once

#include "runtime/command/motion_plans.h"
#include "runtime/command/motion_queue.h"

namespace rob::runtime {

/// MOVE, JOG, PATH and UNTIL: has motions planned and queues them.
class MotionCommands {
 public:
  MotionCommands(const RobotLinks& links, Surroundings& surroundings, NextMotion& next,
                 Guard& guard, const PressLine& press, const CommandedProgress& progress,
                 Loads& loads, MotionPlans& plans, MotionQueue& queue)
      : links_(links),
        surroundings_(surroundings),
        next_(next),
        guard_(guard),
        press_(press),
        progress_(progress),
        loads_(loads),
        plans_(plans),
        queue_(queue) {}

  void work_in(const lang::Setting& setting);
  lang::Reply move(int line, const lang::MoveCommand& asked);
  /// A jog for as long as `held` says No, in the tick; ended() says when it has come to rest.
  lang::Reply jog_while(int line, const lang::MoveCommand& command, const motion::Watch& held);
  lang::Reply begin_path(int line);
  lang::Reply end_path(int line);
  /// LOAD.
  lang::Reply carry(int line, const lang::LoadCommand& load);
  lang::Reply ended(int line, bool& hit);

  /// Plans these commands and the open PATH again, from where the planner stands now, with the
  /// numbers that they had; or why that is not possible.
  std::optional<Words> plan_anew(std::deque<Commanded>& commanded);

 private:
  lang::Reply jog(int line, const lang::MoveCommand& asked);
  lang::Reply tell_load(int line);
  bool tip_jumps() const;
  bool stop_for_tool(int line);
  std::optional<Words> lay_places();
  std::optional<Words> plan_one_anew(Commanded& commanded);
  bool take_end(motion::Rest& rest);

  const RobotLinks& links_;
  Surroundings& surroundings_;
  NextMotion& next_;
  Guard& guard_;
  const PressLine& press_;
  const CommandedProgress& progress_;
  Loads& loads_;
  MotionPlans& plans_;
  MotionQueue& queue_;
};

}  // namespace rob::runtime
