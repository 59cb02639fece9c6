#pragma once

#include <string>

#include "motion/robots/robot_model.h"
#include "runtime/pictures/tool_way.h"
#include "runtime/run/run_result.h"

namespace rob::runtime {

/// The picture of `rob check --svg` (docs/cli.md): the way of the flange from above, of an arm from
/// its side, too; numbers and times of the lines, and how far corners are missed. `result`: what
/// was foretold; `way`: where that went.
std::string path_svg(const RunResult& result, const motion::RobotModel& robot, const ToolWay& way);

/// The same for a terminal, out of braille characters: `columns` wide, `rows` high, with a line of
/// text under each view.
std::string path_plot(const motion::RobotModel& robot, const ToolWay& way, int columns, int rows);

}  // namespace rob::runtime
