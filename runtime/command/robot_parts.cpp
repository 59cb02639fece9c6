#include "runtime/command/robot_parts.h"

namespace rob::runtime {

RobotParts::RobotParts(const RobotLinks& links, double override_share)
    : effects(links),
      progress(links, effects),
      next(links),
      guard(links),
      whens(links, effects, progress),
      outputs(links, effects, next, whens, override_share),
      assumptions(links),
      surroundings(links),
      loads(links, outputs, progress),
      press(links, surroundings),
      touching(links.robot),
      plans(links, assumptions, surroundings, press, touching),
      queue(links, progress, guard, next, loads),
      motions(links, surroundings, next, guard, press, progress, loads, plans, queue),
      waits(links, assumptions, progress, queue),
      desk(links, assumptions, progress, outputs, waits),
      files(links, effects, progress, outputs, waits),
      devices(links, assumptions, progress, outputs, waits),
      forces(links, surroundings, progress, outputs, queue, press),
      readings(links, progress, guard, queue),
      safe(links, outputs),
      reports(links, effects, progress),
      operator_stop(links, effects),
      turns(links, whens, progress, surroundings, guard, loads, queue, motions),
      errand(links, progress, loads, queue),
      task_side{links, readings, assumptions, turns, files, devices} {}

}  // namespace rob::runtime
