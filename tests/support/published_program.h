#pragma once

#include <utility>

#include "tests/support/gantry.h"
#include "tests/support/paul_model.h"
#include "tests/support/trace_file.h"

namespace rob::test {

/// The model of the program that S1 measures: four MOVEs, STOP in line 5, END in line 6.
inline PaulModel published_program() {
  const auto move = [](int line, AxisValues target) {
    return PaulStep{.line = line, .stop = false, .target = std::move(target), .t_user = 0};
  };
  const auto stop = [](int line) {
    return PaulStep{.line = line, .stop = true, .target = {}, .t_user = 0};
  };
  return PaulModel(gantry_robot(), gantry_start(),
                   {move(1, {40, 40, 0}), move(2, {140, 40, 0}), move(3, {90, 126, 0}),
                    move(4, {40, 40, 0}), stop(5), stop(6)});
}

/// The trace that a faultless controller would write of it: 1911 rows, with the axes exactly on
/// their references.
inline TraceFile published_trace() {
  const PaulModel model = published_program();
  const int lines_from[] = {0, 275, 775, 1205, 1635};  // S1's segment times in periods
  TraceFile trace{.axes = 3, .rows = {}};
  for (int k = 0; k <= 1910; ++k) {
    TraceRow row;
    row.t = k * gantry_limits().period;
    for (int from : lines_from) row.line += k >= from ? 1 : 0;
    row.state = 1;
    row.rate = 1;
    const AxisState state = model.at(row.t);
    row.q = state.q;
    row.qd = state.qd;
    row.qdd = state.qdd;
    row.measured = state.q;
    row.pose = {state.q[0], state.q[1], 0, 0, 0, state.q[2]};
    row.drive = {0, 0, 0};
    trace.rows.push_back(row);
  }
  return trace;
}

}  // namespace rob::test
