#include "tests/support/trace_judge.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <functional>
#include <limits>
#include <optional>

namespace rob::test {

namespace {

/// 1e-9 m, and as much in deg and in the derivatives: rounding of 100 s of motion stays below.
constexpr double kExact = 1e-6;
/// s; an instant so near to a decision point belongs to both its segments.
constexpr double kInstant = 1e-9;

std::string text(double value) {
  char buffer[32];
  std::snprintf(buffer, sizeof buffer, "%.12g", value);
  return buffer;
}

/// "t = 1.23, axis 2: velocity 3 instead of 4"
std::string differs(double t, std::size_t axis, const char* what, double is, double should) {
  return "t = " + text(t) + ", axis " + std::to_string(axis + 1) + ": " + what + " " + text(is) +
         " instead of " + text(should);
}

using RowRule = std::function<std::optional<std::string>(const TraceRow&)>;

/// Applies a rule row by row and keeps its first breach.
void hold_rows_to(const TraceFile& trace, Findings& findings, const RowRule& rule) {
  for (const TraceRow& row : trace.rows) {
    if (std::optional<std::string> finding = rule(row)) {
      findings.push_back(std::move(*finding));
      return;
    }
  }
}

std::optional<std::string> away_from(const AxisValues& is, const AxisValues& should, double t,
                                     const char* what, double tolerance) {
  for (std::size_t i = 0; i < is.size(); ++i) {
    // Written so that a NaN is a breach.
    if (!(std::abs(is[i] - should[i]) <= tolerance)) return differs(t, i, what, is[i], should[i]);
  }
  return std::nullopt;
}

void judge_times(const TraceFile& trace, double total, double period, Findings& findings) {
  const long long expected = periods_in(total, period) + 1;
  if (static_cast<long long>(trace.rows.size()) != expected) {
    findings.push_back(std::to_string(trace.rows.size()) + " rows instead of " +
                       std::to_string(expected));
  }
  for (std::size_t k = 0; k < trace.rows.size(); ++k) {
    const double should = static_cast<double>(k) * period;
    if (!(std::abs(trace.rows[k].t - should) <= kInstant)) {
      findings.push_back("row " + std::to_string(k + 1) + " has t = " + text(trace.rows[k].t) +
                         " instead of " + text(should));
      return;
    }
  }
}

std::optional<std::string> wrong_owner(const TraceRow& row, const PaulModel& model) {
  const std::vector<PaulSegment>& segments = model.segments();
  for (const PaulSegment& segment : segments) {
    const bool last = &segment == &segments.back();
    const double end =
        last ? std::numeric_limits<double>::infinity() : segment.start + segment.span();
    if (row.t < segment.start - kInstant || row.t > end + kInstant) continue;
    if (row.line == segment.line) return std::nullopt;
  }
  if (row.line == 0 && (row.t <= kInstant || row.t >= model.total() - kInstant)) {
    return std::nullopt;  // before the first segment and after the last nobody owns the instant
  }
  return "t = " + text(row.t) + ": line " + std::to_string(row.line) + " does not own this instant";
}

std::optional<std::string> beyond_limits(const TraceRow& row, const PaulModel& model,
                                         const RunLimits& limits) {
  const PaulRobot& robot = model.robot();
  for (std::size_t i = 0; i < row.q.size(); ++i) {
    if (row.q[i] < limits.min[i] - kExact || row.q[i] > limits.max[i] + kExact) {
      return differs(row.t, i, "position beyond its limit:", row.q[i],
                     std::clamp(row.q[i], limits.min[i], limits.max[i]));
    }
    if (std::abs(row.qd[i]) > robot.v_max[i] + kExact) {
      return differs(row.t, i, "speed beyond its limit:", row.qd[i], robot.v_max[i]);
    }
    // Of a corner in which the axis turns back at full speed: 0.75·2·v/t_acc.
    const double a_max = 1.5 * robot.v_max[i] / model.least_t_acc();
    if (std::abs(row.qdd[i]) > a_max + kExact) {
      return differs(row.t, i, "acceleration beyond the law's:", row.qdd[i], a_max);
    }
  }
  return std::nullopt;
}

void judge_end(const TraceFile& trace, const PaulModel& model, Findings& findings) {
  if (trace.rows.empty() || model.segments().empty()) return;
  const TraceRow& last = trace.rows.back();
  const AxisValues rest(last.q.size(), 0.0);
  for (auto finding : {away_from(last.q, model.segments().back().c, last.t, "last position", 1e-9),
                       away_from(last.qd, rest, last.t, "last velocity", 1e-9),
                       away_from(last.qdd, rest, last.t, "last acceleration", 1e-9)}) {
    if (finding) findings.push_back(*finding);
  }
}

}  // namespace

long long periods_in(double total, double period) {
  constexpr double kRounding = 1e-7;  // periods; 1 ns at 10 ms
  return static_cast<long long>(std::ceil(total / period - kRounding));
}

double greatest_jerk(const PaulModel& model) {
  const std::vector<double>& speeds = model.robot().v_max;
  const double v_max = *std::max_element(speeds.begin(), speeds.end());
  return 1.5 * 2 * v_max / (model.least_t_acc() * model.least_t_acc());
}

Findings judge_against_model(const TraceFile& trace, const PaulModel& model,
                             const RunLimits& limits) {
  Findings findings;
  if (trace.axes != model.robot().v_max.size()) return {"the trace has another number of axes"};
  judge_times(trace, model.total(), limits.period, findings);
  hold_rows_to(trace, findings, [&](const TraceRow& row) -> std::optional<std::string> {
    const AxisState should = model.at(row.t);
    if (auto f = away_from(row.q, should.q, row.t, "position", kExact)) return f;
    if (auto f = away_from(row.qd, should.qd, row.t, "velocity", kExact)) return f;
    return away_from(row.qdd, should.qdd, row.t, "acceleration", kExact);
  });
  hold_rows_to(trace, findings, [&](const TraceRow& row) { return wrong_owner(row, model); });
  hold_rows_to(trace, findings,
               [&](const TraceRow& row) { return beyond_limits(row, model, limits); });
  hold_rows_to(trace, findings, [&](const TraceRow& row) {
    return away_from(row.measured, row.q, row.t, "measured position", limits.measured_near);
  });
  hold_rows_to(trace, findings, [&](const TraceRow& row) -> std::optional<std::string> {
    const AxisValues tool{row.pose[0], row.pose[1]};
    const AxisValues axes(row.q.begin(), row.q.begin() + 2);
    return away_from(tool, axes, row.t, "tool position", kExact);
  });
  judge_end(trace, model, findings);
  return findings;
}

// Each bound is the error of the quadrature rule for a third derivative that jumps by 2·jerk
// anywhere inside the period (Peano): T²·2j/8 for the trapezoidal rule, 0.0081·T³·2j for the one
// that also uses the slopes at both ends. Both are given a little room.
Findings judge_smoothness(const TraceFile& trace, double period, double jerk) {
  const double T = period;
  Findings findings;
  for (std::size_t k = 1; k < trace.rows.size() && findings.empty(); ++k) {
    const TraceRow& p = trace.rows[k - 1];
    const TraceRow& n = trace.rows[k];
    for (std::size_t i = 0; i < trace.axes; ++i) {
      const double q = T * (p.qd[i] + n.qd[i]) / 2 - T * T * (n.qdd[i] - p.qdd[i]) / 12;
      const double qd = T * (p.qdd[i] + n.qdd[i]) / 2;
      if (!(std::abs(n.q[i] - p.q[i] - q) <= 0.02 * T * T * T * jerk + 1e-9)) {
        findings.push_back(differs(n.t, i, "step of position", n.q[i] - p.q[i], q));
      }
      if (!(std::abs(n.qd[i] - p.qd[i] - qd) <= 0.3 * T * T * jerk + 1e-9)) {
        findings.push_back(differs(n.t, i, "step of velocity", n.qd[i] - p.qd[i], qd));
      }
      if (!(std::abs(n.qdd[i] - p.qdd[i]) <= 1.001 * T * jerk + 1e-9)) {
        findings.push_back(differs(n.t, i, "jump of acceleration", n.qdd[i] - p.qdd[i], 0));
      }
    }
  }
  return findings;
}

}  // namespace rob::test
