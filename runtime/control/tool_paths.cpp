#include "runtime/control/tool_paths.h"

#include "motion/path/tool_line.h"
#include "runtime/control/path_words.h"

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
  (void)kind;
  return made(motion::ToolLine::between(points.front(), points.back()), words_for_half_turn());
}

ToolPathOrWords spiral_from(const Pose& from, const Pose& /*frame*/, double /*radius*/,
                            double /*turns*/) {
  return made(motion::ToolLine::between(from, from), words_for_half_turn());
}

}  // namespace rob::runtime
