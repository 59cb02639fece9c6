#pragma once

#include "tests/bench/outcome.h"

namespace rob::bench {

/// The published program in real time as `rob run` runs it: a thread each for motion and servo,
/// absolute deadlines, blocking waits, references for the time that has really elapsed, and the
/// program decoded ahead of the motion. Fixed priorities where they are permitted.
///
/// `work`: s of processor time added to each motion and servo cycle, before it.
Outcome run_robs_organisation(double work);

}  // namespace rob::bench
