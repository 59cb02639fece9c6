#include "runtime/command/tool_paths.h"

#include "motion/path/euler_line.h"
#include "motion/path/joint_spline.h"
#include "motion/path/tool_arc.h"
#include "motion/path/tool_line.h"
#include "motion/path/tool_spiral.h"
#include "motion/path/tool_spline.h"
#include "runtime/words/path_words.h"

namespace rob::runtime {

using lang::MotionKind;
using motion::Pose;

namespace {

/// The path, or the words where the geometry has none.
template <typename Path>
ToolPathOrWords made(std::optional<Path> path, const Words& otherwise) {
  if (!path) return otherwise;
  return std::unique_ptr<motion::ToolPath>(std::make_unique<Path>(std::move(*path)));
}

}  // namespace

ToolPathOrWords path_through(MotionKind kind, const std::vector<Pose>& points) {
  using motion::ToolArc;
  using motion::ToolLine;
  using motion::ToolSpline;
  if (kind == MotionKind::Spline) return made(ToolSpline::through(points), words_for_no_spline());
  const auto line = ToolLine::between(points.front(), points.back());
  if (kind == MotionKind::Line || !line) return made(line, words_for_half_turn());
  return made(ToolArc::through(points.front(), points[1].position, points.back()),
              words_for_no_arc());
}

ToolPathOrWords joints_through(const motion::RobotModel& robot, const Pose& tip,
                               const std::vector<motion::JointVector>& points) {
  return made(motion::JointSpline::through(robot, tip, points), words_for_no_joint_spline());
}

ToolPathOrWords euler_line(const Pose& from, const Pose& to) {
  using Trouble = motion::EulerLine::Trouble;
  auto line = motion::EulerLine::between(from, to);
  if (const auto* const trouble = std::get_if<Trouble>(&line)) {
    if (*trouble == Trouble::HalfTurn) return words_for_half_turn();
    const bool beginning = *trouble == Trouble::SteepBeginning;
    return words_for_steep_line(beginning,
                                motion::fixed_angles((beginning ? from : to).orientation).b);
  }
  return std::unique_ptr<motion::ToolPath>(
      std::make_unique<motion::EulerLine>(std::get<motion::EulerLine>(line)));
}

ToolPathOrWords spiral_from(const Pose& from, const Pose& frame, double radius, double turns) {
  return made(motion::ToolSpiral::inwards(from, frame.orientation, radius, turns),
              words_for_no_spiral());
}

}  // namespace rob::runtime
