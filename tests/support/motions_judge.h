#pragma once

#include <string>
#include <vector>

#include "tests/support/random_motions.h"
#include "tests/support/traced_run.h"

namespace rob::test {

/// What a random program was worth.
struct Judgement {
  std::vector<std::string> findings;
  bool refused = false;  ///< a line led an axis past its limit, and was not begun
};

/// Runs a random program and tells what is wrong with what it did; nothing if it ended
/// well, no axis was beyond its limits (with JERK neither beyond that), nothing leapt, the tool
/// missed no target by more than its ZONE and was beside its path by no more, and ended at the
/// last.
Judgement judge_motions(const std::string& rob, const MotionRobot& robot,
                        const RandomMotions& motions, const std::vector<std::string>& options);

}  // namespace rob::test
