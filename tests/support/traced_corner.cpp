#include "tests/support/traced_corner.h"

#include <algorithm>
#include <limits>

namespace rob::test {

namespace {

/// Places looked at between two rows: 0.02 mm apart at 30 mm/s and 10 ms.
constexpr int kPlaces = 16;

/// The cubic through q0 and q1 with the slopes qd0 and qd1, at the share s of the period T.
double hermite(double q0, double qd0, double q1, double qd1, double T, double s) {
  const double r = 1 - s;
  return r * r * (1 + 2 * s) * q0 + s * r * r * T * qd0 + s * s * (3 - 2 * s) * q1 -
         s * s * r * T * qd1;
}

/// `between(p, n, s)`: the axes at the share s of the way from row p to row n.
template <typename Between>
double least_distance(const TraceFile& trace, const AxisValues& place, double from, double to,
                      std::size_t tool_axes, Between between) {
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t k = 1; k < trace.rows.size(); ++k) {
    const TraceRow& p = trace.rows[k - 1];
    const TraceRow& n = trace.rows[k];
    if (n.t < from || p.t > to) continue;
    for (int j = 0; j <= kPlaces; ++j) {
      const AxisValues here = between(p, n, static_cast<double>(j) / kPlaces);
      least = std::min(least, tool_distance(here, place, tool_axes));
    }
  }
  return least;
}

}  // namespace

double traced_corner_miss(const TraceFile& trace, const AxisValues& place, double from, double to,
                          std::size_t tool_axes) {
  return least_distance(trace, place, from, to, tool_axes,
                        [&](const TraceRow& p, const TraceRow& n, double s) {
                          AxisValues here(trace.axes);
                          for (std::size_t i = 0; i < here.size(); ++i) {
                            here[i] = hermite(p.q[i], p.qd[i], n.q[i], n.qd[i], n.t - p.t, s);
                          }
                          return here;
                        });
}

double measured_corner_miss(const TraceFile& trace, const AxisValues& place, double from, double to,
                            std::size_t tool_axes) {
  return least_distance(trace, place, from, to, tool_axes,
                        [&](const TraceRow& p, const TraceRow& n, double s) {
                          AxisValues here(trace.axes);
                          for (std::size_t i = 0; i < here.size(); ++i) {
                            here[i] = p.measured[i] + s * (n.measured[i] - p.measured[i]);
                          }
                          return here;
                        });
}

}  // namespace rob::test
