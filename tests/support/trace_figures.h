#pragma once

#include "tests/support/paul_model.h"
#include "tests/support/trace_file.h"

namespace rob::test {

/// The greatest speed, acceleration and jerk of each axis in a trace: mm or deg and s.
struct TracePeaks {
  AxisValues v;  ///< of qd
  AxisValues a;  ///< of qdd and of the second differences of q
  AxisValues j;  ///< of the third differences of q
};

/// Rows must be a period apart. Differences of four rows at most, so a change of acceleration from
/// one row to the next counts as a jerk of that change over the period.
TracePeaks peaks_of(const TraceFile& trace);

/// s from the last row before anything moves to the first from which all axes keep their place.
double motion_time(const TraceFile& trace);

/// What one axis must keep, in mm or deg and s. `j` infinite: no bound.
struct AxisBounds {
  double min = 0, max = 0;
  double v = 0, a = 0, j = 0;
};

/// What is wrong with a trace by itself; empty if nothing is. Every rule tells its first breach.
/// Positions, speeds, accelerations and jerks within the bounds (accelerations and jerks with 2 and
/// 10 % of room, as differences of sampled curves need); no leap of position or speed that a
/// motion within the bounds cannot make; rest at the end. Of the lines of the program in `leaping`
/// the jerk is not looked at.
std::vector<std::string> judge_bounds(const TraceFile& trace, const std::vector<AxisBounds>& axes,
                                      const std::vector<int>& leaping = {});

}  // namespace rob::test
