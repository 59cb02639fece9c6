#pragma once

#include <optional>

#include "motion/path/follow.h"
#include "motion/path/tool_path.h"
#include "motion/plan/feasibility.h"
#include "motion/plan/last_target.h"
#include "motion/plan/leg_timing.h"
#include "motion/plan/motion_request.h"
#include "motion/plan/tool_tip.h"
#include "motion/robots/robot_model.h"

namespace rob::motion {

/// Looks at a motion along a path of the tool along its whole length, before it is taken: reach,
/// the axes' limits, places where they would have to turn too fast. m, rad, s.
class PathJudge {
 public:
  PathJudge(const RobotModel& robot, const ToolTip& tip, const LastTarget& last,
            const LegTiming& timing) noexcept
      : robot_(robot), tip_(tip), last_(last), timing_(timing) {}

  /// The first thing on the way that cannot be: an axis beyond its limits or too fast, or the end
  /// of what can be followed.
  std::optional<Refusal> judge(const MotionRequest& request, const ToolPath& path,
                               const Followed& followed) const;

 private:
  Refusal refusal_for(const PathTrouble& trouble, const ToolPath& path,
                      const JointPath& axes) const;
  std::optional<Refusal> too_slow(const MotionRequest& request, const ToolPath& path,
                                  const JointPath& axes) const;
  bool reachable_otherwise(const ToolPath& path) const;

  const RobotModel& robot_;
  const ToolTip& tip_;
  const LastTarget& last_;
  const LegTiming& timing_;
};

}  // namespace rob::motion
