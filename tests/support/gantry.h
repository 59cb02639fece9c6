#pragma once

#include "tests/support/paul_model.h"
#include "tests/support/trace_judge.h"

namespace rob::test {

/// The figures of S1's gantry, written down a second time beside its robot file: x 0…400 mm,
/// y 0…300 mm, theta ±180°; 20 mm/s, 20 mm/s, 20 °/s; t_acc 1.375 s; references every 10 ms.
inline PaulRobot gantry_robot() { return {.v_max = {20, 20, 20}, .t_acc = 1.375, .tool_axes = 2}; }

inline RunLimits gantry_limits() {
  return {.period = 0.01, .min = {0, 0, -180}, .max = {400, 300, 180}};
}

/// Where the simulated gantry stands at power-up.
inline AxisValues gantry_start() { return {0, 0, 0}; }

}  // namespace rob::test
