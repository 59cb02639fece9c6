#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

#include "lang/machine/machine.h"
#include "lang/machine/move_command.h"
#include "lang/values/setting.h"
#include "motion/collision/clearance.h"
#include "motion/dynamics/arm_load.h"
#include "motion/path/tool_path.h"
#include "motion/plan/planned_leg.h"
#include "motion/plan/segment_descriptor.h"
#include "runtime/command/program_watch.h"

namespace rob::runtime {

/// An effect that a motion has on its way.
struct OnTheWay {
  lang::PathPlace place;
  motion::Effect effect;
};

/// A motion, a stop or a dwell as it was asked for. RobotMachine keeps it while the generator may
/// not have begun it.
struct Commanded {
  motion::SegmentDescriptor segment;
  bool stop = false;
  bool further = false;
  std::optional<lang::MoveCommand> move{};               ///< of a motion
  lang::Setting setting{};                               ///< in which it was commanded
  const motion::CarriedLoad* carried{};                  ///< then; null: nothing
  std::shared_ptr<const motion::Clearance> clearance{};  ///< what it must not hit
  std::vector<OnTheWay> events{};
  std::vector<lang::MoveCommand> via{};  ///< of MOVEC, MOVES
  std::optional<ProgramPace> live{};
  std::shared_ptr<const motion::PlannedLeg> leg{};
  std::uint64_t known_by = 0;                       ///< WayMarks
  double way = 0;                                   ///< of the tool, m
  std::shared_ptr<const motion::ToolPath> along{};  ///< null: straight in the axes
};

}  // namespace rob::runtime
