#pragma once

#include <cmath>
#include <functional>

#include "tests/support/trace_file.h"

namespace rob::test {

/// A trace of axes whose state is known at any time.
inline TraceFile made_trace(double total, double period,
                            const std::function<AxisState(double)>& at) {
  TraceFile trace;
  const auto rows = static_cast<int>(std::lround(total / period));
  for (int k = 0; k <= rows; ++k) {
    TraceRow row;
    row.t = k * period;
    AxisState state = at(row.t);
    row.q = std::move(state.q);
    row.qd = std::move(state.qd);
    row.qdd = std::move(state.qdd);
    trace.axes = row.q.size();
    trace.rows.push_back(std::move(row));
  }
  return trace;
}

}  // namespace rob::test
