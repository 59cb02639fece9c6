#pragma once

#include "motion/ahead/piece.h"

namespace rob::motion {

/// Learns of the path as it is planned: each piece once, in its order, when it can no longer
/// change. Called by the planner's thread, not in the tick.
class PathListener {
 public:
  virtual ~PathListener() = default;
  virtual void planned(const Piece& piece) = 0;
};

}  // namespace rob::motion
