#include "tests/support/motions_judge.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <fstream>
#include <limits>
#include <numbers>

namespace rob::test {

namespace {

using Eigen::Vector3d;

/// mm: what an arm's tool may be beside its line, between two nodes of it.
constexpr double kArmLine = 0.05;

constexpr int kPartsOfRow = 4;

/// The trace has the flange: now the tip.
void lead_tip(TraceFile& trace, const Vector3d& tool) {
  const auto about = [](double degrees, const Vector3d& axis) {
    return Eigen::AngleAxisd(degrees * std::numbers::pi / 180, axis);
  };
  for (TraceRow& row : trace.rows) {
    const auto& [x, y, z, a, b, c] = row.pose;
    const Vector3d tip = about(c, Vector3d::UnitZ()) *
                         (about(b, Vector3d::UnitY()) * (about(a, Vector3d::UnitX()) * tool));
    for (std::size_t i = 0; i < 3; ++i) row.pose[i] += tip[static_cast<Eigen::Index>(i)];
  }
}

std::vector<Vector3d> curve_of(const TracedRun& run, const MotionRobot& robot,
                               const Vector3d& tool) {
  if (robot.kind != MotionRobot::Kind::Arm && tool.isZero())
    return tool_curve(run.trace, linear_axes(robot), kPartsOfRow);
  TraceFile trace = run.trace;
  lead_tip(trace, tool);
  return tool_curve_of_poses(trace, kPartsOfRow);
}

/// A curve, and where on the path the tool was there.
struct Followed {
  std::vector<Vector3d> curve;
  std::vector<PathStretch> where;
};

/// The points between which a motion of that line leads; those of a spline have one line.
PathStretch stretch_of(int line, const std::vector<int>& lines) {
  const auto first = std::lower_bound(lines.begin(), lines.end() - 1, line);
  const auto last = std::upper_bound(first, lines.end(), *first);
  const auto to = static_cast<std::size_t>(last - lines.begin()) - 1;
  const auto from = static_cast<std::size_t>(first - lines.begin());
  return {from > 0 ? from - 1 : 0, to};
}

/// From where the tool first stands at the path's beginning.
Followed from_the_beginning(const std::vector<Vector3d>& curve, const TraceFile& trace,
                            const RandomMotions& motions) {
  const Vector3d& beginning = motions.path.places.front();
  Followed followed;
  int line = 0;
  for (std::size_t k = 0; k < curve.size(); ++k) {
    if (followed.curve.empty() && (curve[k] - beginning).norm() >= 1e-4) continue;
    const std::size_t row = (k + kPartsOfRow - 1) / kPartsOfRow;
    followed.curve.push_back(curve[k]);
    line = std::max(line, trace.rows[row].line);  // a WHEN has its own, and it only holds
    followed.where.push_back(stretch_of(line, motions.lines));
  }
  return followed;
}

/// Bounds, none greater than the shorter way to a neighbour: there a corner ends at the latest.
/// What is named twice is one point.
std::vector<double> cut_to_legs(const ProgrammedPath& path, std::vector<double> bounds) {
  std::vector<double> length(path.places.size(), 0.0);
  for (std::size_t i = 1; i < length.size(); ++i)
    length[i] = length[i - 1] + (path.places[i] - path.places[i - 1]).norm();
  for (std::size_t i = 0; i < bounds.size(); ++i) {
    const double here = length[path.points[i]];
    std::size_t before = i, behind = i;
    while (before > 0 && length[path.points[before]] == here) --before;
    while (behind + 1 < bounds.size() && length[path.points[behind]] == here) ++behind;
    if (length[path.points[before]] < here)
      bounds[i] = std::min(bounds[i], here - length[path.points[before]]);
    if (length[path.points[behind]] > here)
      bounds[i] = std::min(bounds[i], length[path.points[behind]] - here);
    bounds[i] = std::max(bounds[i], 1e-3);
  }
  return bounds;
}

std::string text_of(const char* format, double a, double b) {
  char text[160];
  std::snprintf(text, sizeof text, format, a, b);
  return text;
}

std::string text_of(const Vector3d& place) {
  char text[80];
  std::snprintf(text, sizeof text, "(%g, %g, %g)", place.x(), place.y(), place.z());
  return text;
}

/// Under the look-ahead law short legs may become one curve within their ZONE, however short they
/// are (docs/motion.md, Dense paths); under Paul's law a corner ends with its legs.
void judge_way(const std::vector<Vector3d>& whole, const TraceFile& trace,
               const RandomMotions& motions, bool look_ahead, double room,
               std::vector<std::string>& findings) {
  const Followed followed = from_the_beginning(whole, trace, motions);
  if (followed.curve.empty())
    return findings.push_back("the tool never stood where its way begins");
  const bool cut = !motions.averaged && !look_ahead;
  PathBounds allowed{cut ? cut_to_legs(motions.path, motions.misses) : motions.misses,
                     motions.besides};
  std::vector<double>& bounds = allowed.misses;
  constexpr double more = 1.01;
  constexpr double kTraced = 1e-3;  // mm: between two rows the curve is a cubic
  for (double& bound : bounds) bound = more * bound + room + kTraced;
  for (double& bound : allowed.besides) bound = more * bound + room;
  // A way that is not known is looked at as a whole: each point must have been passed at some time.
  const double window = motions.known ? 60 : std::numeric_limits<double>::infinity();
  const PathExcess excess =
      path_excess(followed.curve, motions.path, allowed, window, followed.where);
  if (!(excess.miss <= 0)) {
    const Vector3d& point = motions.path.places[motions.path.points[excess.point]];
    findings.push_back(text_of(point) +
                       text_of(" is missed by %g mm more than the %g that it may be", excess.miss,
                               bounds[excess.point]));
  }
  if (motions.known && !(excess.from_path <= 0)) {
    findings.push_back(
        text_of(excess.place) +
        text_of(" is beside the path by %g mm more than it may be%.0s", excess.from_path, 0));
  }
}

/// s: the longest mean of the references.
double longest_mean(const MotionRobot& robot, const RandomMotions& motions) {
  double longest = 0;
  for (const AxisBounds& axis : robot.axes) longest = std::max(longest, 2 * axis.a / axis.j);
  if (motions.least_jerk > 0)
    longest = std::max(longest, 2 * robot.axes.front().a / motions.least_jerk);
  return std::min(longest, 2.0);
}

/// Whether the report says of a LEAD of that motion that it could not be kept.
bool said(const TracedRun& run, int line) {
  const auto speaks = [&](const char* key, const char* value, const nlohmann::json& one) {
    return one[key] == value && (one["line"] == line || one["line"] == line + 1);
  };
  const auto& events = run.report["events"];
  const auto& findings = run.report["findings"];
  return std::any_of(events.begin(), events.end(),
                     [&](const auto& one) { return speaks("kind", "lead", one); }) ||
         std::any_of(findings.begin(), findings.end(),
                     [&](const auto& one) { return speaks("code", "W646", one); });
}

/// Each change of DOUT[8] has to come where the sigma of its motion is what was asked for. Motions
/// begin and end by the guide, which the references are up to a·T²/24 away from, T the mean's time:
/// so near to its ends a place may be passed outside of them.
void judge_marks(const TracedRun& run, const RandomMotions& motions, double acceleration,
                 double mean, std::vector<std::string>& findings) {
  constexpr double kMm = 1000;  // sigma of a trace is in m
  std::vector<double> times;
  for (const auto& change : run.report["signals"])
    if (change["name"] == "DOUT[8]") times.push_back(change["t"].get<double>());
  if (times.size() != motions.marks.size())
    return findings.push_back(text_of("%g outputs on the way came, and not %g",
                                      static_cast<double>(times.size()),
                                      static_cast<double>(motions.marks.size())));
  const auto& rows = run.trace.rows;
  const double period = rows[1].t - rows[0].t;
  for (std::size_t i = 0; i < times.size(); ++i) {
    const PathMark& mark = motions.marks[i];
    const double blurred = acceleration * mean * mean / 24;
    const bool at_end = std::min(mark.place, mark.length - mark.place) <= blurred;
    const double most = acceleration * period * period + (at_end ? blurred : 0) + 1e-3;
    const auto near = [&](const TraceRow& row) {
      const double since = times[i] - mark.lag - row.t;
      const double before = at_end && row.line > mark.line ? mark.length : 0;
      // Events are told in order: one that is late may be told with another of its period. What a
      // LEAD foresaw is told where it was wrong by a period.
      const double told = mark.lag != 0 ? row.rate * period * kMm : 0;
      return (row.line == mark.line || before > 0) && std::abs(since) <= 1.001 * period &&
             std::abs((row.sigma + row.rate * since) * kMm + before - mark.place) <= most + told;
    };
    if (std::none_of(rows.begin(), rows.end(), near) && !(mark.lag < 0 && said(run, mark.line)))
      findings.push_back(
          text_of("the output on the way of line %g came at %g s, elsewhere", mark.line, times[i]));
  }
}

}  // namespace

Judgement judge_motions(const std::string& rob, const MotionRobot& robot,
                        const RandomMotions& motions, const std::vector<std::string>& options) {
  const ScratchFolder scratch;
  const std::string script = (scratch.path() / "cell.sig").string();
  std::ofstream(script) << motions.signals;
  std::vector<std::string> more = options;
  more.insert(more.end(), {"--signals", script, "--override", motions.override_share});
  const TracedRun run = run_traced(rob, motions.text, robot.robot, more);
  if (!run.done()) {
    // Random orientations may ask for it.
    const bool refused = robot.kind != MotionRobot::Kind::Linear && run.report.is_object() &&
                         run.report["error"]["code"] == "E561";
    return {{run.trouble()}, refused};
  }
  std::vector<AxisBounds> axes = robot.axes;
  for (std::size_t i = 0; motions.jerk > 0 && i < linear_axes(robot); ++i)
    axes[i].j = std::min(axes[i].j, motions.jerk);
  std::vector<std::string> findings = judge_bounds(run.trace, axes, motions.leaping);
  const auto curve = curve_of(run, robot, motions.tool);
  const bool bends = robot.kind == MotionRobot::Kind::Arm || !motions.tool.isZero();
  const double room = bends ? kArmLine : 0;
  if (motions.whole) judge_way(curve, run.trace, motions, robot.look_ahead, room, findings);
  if (motions.whole && !bends)
    judge_marks(run, motions, std::sqrt(3) * axes.front().a, longest_mean(robot, motions),
                findings);
  const double off = (curve.back() - motions.path.places.back()).norm();
  if (!(off < 1e-6)) findings.push_back(text_of("the end is off by %g mm%.0s", off, 0));
  return {findings, false};
}

}  // namespace rob::test
