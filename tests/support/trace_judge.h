#pragma once

#include <string>
#include <vector>

#include "tests/support/paul_model.h"
#include "tests/support/trace_file.h"

namespace rob::test {

/// What a run is held to beside the law: the robot's figures, in mm, deg and s.
struct RunLimits {
  double period = 0.01;        ///< between two references
  AxisValues min, max;         ///< of each axis
  double measured_near = 0.5;  ///< [choice] how far the simulated axes may be from the references:
                               ///< far more than a healthy servo needs, far less than a corner
};

/// What is wrong with a trace; empty if nothing is. Each rule reports its first breach.
using Findings = std::vector<std::string>;

/// Judges the trace of a run on the virtual clock from first to last row: their number and times,
/// every reference against the model (1e-6 mm or deg, and as much per s and s²), the owner of each
/// instant, the limits, the last point, and the measured axes near the references.
Findings judge_against_model(const TraceFile& trace, const PaulModel& model,
                             const RunLimits& limits);

/// Judges the trace by itself, whatever made it: position is the integral of velocity, velocity of
/// acceleration, and acceleration has no jump. `jerk`: the greatest that the law knows.
Findings judge_smoothness(const TraceFile& trace, double period, double jerk);

/// The greatest third derivative of S1's quartic in this program: 1.5·|v2 − v1|/t_acc² at the ends
/// of its tightest corner, if an axis turned back there at full speed.
double greatest_jerk(const PaulModel& model);

/// How many references a run of `total` s hands out after the first: the least k with k·period >=
/// total. A total that is a whole number of periods but for rounding is that number.
long long periods_in(double total, double period);

}  // namespace rob::test
