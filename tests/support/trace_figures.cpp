#include "tests/support/trace_figures.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <functional>
#include <optional>

namespace rob::test {

namespace {

using Rows = std::vector<TraceRow>;

double period_of(const Rows& rows) {
  return (rows.back().t - rows.front().t) / static_cast<double>(rows.size() - 1);
}

double second_difference(const Rows& rows, std::size_t k, std::size_t i) {
  return rows[k + 1].q[i] - 2 * rows[k].q[i] + rows[k - 1].q[i];
}

bool same_place(const AxisValues& p, const AxisValues& q) {
  constexpr double kSame = 1e-9;  // mm, deg: rounding of what is 1 m away stays below
  for (std::size_t i = 0; i < p.size(); ++i)
    if (std::abs(p[i] - q[i]) > kSame) return false;
  return true;
}

/// "t = 1.234, axis 2: speed 3 beyond 2"
std::string breach(const TraceRow& row, std::size_t axis, const char* what, double is,
                   double most) {
  char text[120];
  std::snprintf(text, sizeof text, "t = %.4f, axis %zu: %s %.9g beyond %.9g", row.t, axis + 1, what,
                is, most);
  return text;
}

/// What one rule says of row k (from 1 on) and one axis: the value and what it may be at most.
struct Claim {
  double is = 0;
  double most = 0;
};
using Rule = std::function<Claim(std::size_t k, std::size_t i)>;

std::optional<std::string> first_breach(const TraceFile& trace, std::size_t first, std::size_t last,
                                        const char* what, const Rule& rule) {
  for (std::size_t k = first; k < last; ++k) {
    for (std::size_t i = 0; i < trace.axes; ++i) {
      const Claim claim = rule(k, i);
      // Written so that a NaN is a breach.
      if (!(claim.is <= claim.most)) return breach(trace.rows[k], i, what, claim.is, claim.most);
    }
  }
  return std::nullopt;
}

}  // namespace

TracePeaks peaks_of(const TraceFile& trace) {
  const Rows& rows = trace.rows;
  const AxisValues none(trace.axes, 0.0);
  TracePeaks peaks{none, none, none};
  if (rows.size() < 2) return peaks;
  const double T = period_of(rows);
  for (std::size_t i = 0; i < trace.axes; ++i) {
    for (const TraceRow& row : rows) {
      peaks.v[i] = std::max(peaks.v[i], std::abs(row.qd[i]));
      peaks.a[i] = std::max(peaks.a[i], std::abs(row.qdd[i]));
    }
    double before = 0;
    for (std::size_t k = 1; k + 1 < rows.size(); ++k) {
      const double second = second_difference(rows, k, i);
      peaks.a[i] = std::max(peaks.a[i], std::abs(second) / (T * T));
      if (k > 1) peaks.j[i] = std::max(peaks.j[i], std::abs(second - before) / (T * T * T));
      before = second;
    }
  }
  return peaks;
}

double motion_time(const TraceFile& trace) {
  const Rows& rows = trace.rows;
  std::size_t begin = 0;
  while (begin + 1 < rows.size() && same_place(rows[begin + 1].q, rows.front().q)) ++begin;
  std::size_t end = rows.size() - 1;
  while (end > begin && same_place(rows[end - 1].q, rows.back().q)) --end;
  return rows[end].t - rows[begin].t;
}

std::vector<std::string> judge_bounds(const TraceFile& trace, const std::vector<AxisBounds>& axes,
                                      const std::vector<int>& leaping) {
  constexpr double kRounding = 1e-6;  // mm, deg and their rates
  constexpr double kRoomA = 1.02, kRoomJ = 1.1;
  const Rows& rows = trace.rows;
  if (rows.size() < 2 || axes.size() != trace.axes) return {"no trace of these axes"};
  const double T = period_of(rows);
  std::vector<std::string> findings;
  const auto hold = [&](std::size_t first, std::size_t last, const char* what, const Rule& rule) {
    if (auto found = first_breach(trace, first, last, what, rule)) findings.push_back(*found);
  };
  const std::size_t count = rows.size();
  hold(0, count, "position", [&](std::size_t k, std::size_t i) {
    const double middle = (axes[i].min + axes[i].max) / 2;
    return Claim{std::abs(rows[k].q[i] - middle), axes[i].max - middle + kRounding};
  });
  hold(0, count, "speed", [&](std::size_t k, std::size_t i) {
    return Claim{std::abs(rows[k].qd[i]), axes[i].v + kRounding};
  });
  hold(0, count, "acceleration", [&](std::size_t k, std::size_t i) {
    return Claim{std::abs(rows[k].qdd[i]), kRoomA * axes[i].a + kRounding};
  });
  hold(1, count - 1, "second difference", [&](std::size_t k, std::size_t i) {
    return Claim{std::abs(second_difference(rows, k, i)) / (T * T), kRoomA * axes[i].a + 1e-3};
  });
  hold(1, count, "leap of speed", [&](std::size_t k, std::size_t i) {
    return Claim{std::abs(rows[k].qd[i] - rows[k - 1].qd[i]), kRoomA * axes[i].a * T + kRounding};
  });
  // With |q''| <= a the trapezoidal rule is off by a·T²/4 at most: a speed that goes up at a for
  // half the period and down again.
  hold(1, count, "leap of position", [&](std::size_t k, std::size_t i) {
    const double step =
        rows[k].q[i] - rows[k - 1].q[i] - T * (rows[k].qd[i] + rows[k - 1].qd[i]) / 2;
    return Claim{std::abs(step), kRoomA * axes[i].a * T * T / 4 + 1e-9};
  });
  const auto leaps = [&](std::size_t k) {
    return std::find(leaping.begin(), leaping.end(), rows[k].line) != leaping.end();
  };
  hold(2, count - 1, "third difference", [&](std::size_t k, std::size_t i) {
    // A row behind the motion that leaps still has its acceleration within its differences.
    if (leaps(k - 2) || leaps(k - 1) || leaps(k) || leaps(k + 1)) return Claim{};
    const double third = second_difference(rows, k, i) - second_difference(rows, k - 1, i);
    return Claim{std::abs(third) / (T * T * T), kRoomJ * axes[i].j + 1};
  });
  hold(count - 1, count, "speed at the end", [&](std::size_t k, std::size_t i) {
    return Claim{std::abs(rows[k].qd[i]), kRounding};
  });
  return findings;
}

}  // namespace rob::test
