#pragma once

#include <string>
#include <vector>

#include "tests/support/random_motions.h"
#include "tests/support/traced_run.h"

namespace rob::test {

/// Runs a random program and tells what is wrong with what it did; empty if nothing is: it ended
/// well, no axis was beyond its limits (with JERK neither beyond that), nothing leapt, the tool
/// missed no target by more than its ZONE and was beside its path by no more, and ended at the
/// last.
std::vector<std::string> judge_motions(const std::string& rob, const MotionRobot& robot,
                                       const RandomMotions& motions,
                                       const std::vector<std::string>& options);

}  // namespace rob::test
