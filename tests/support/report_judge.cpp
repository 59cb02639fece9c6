#include "tests/support/report_judge.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <map>
#include <optional>

#include "tests/support/traced_corner.h"

namespace rob::test {

namespace {

using nlohmann::json;

constexpr double kInstant = 1e-6;  ///< s; a report may be rounded to microseconds
constexpr double kMiss = 0.05;     ///< mm
/// mm or deg: an encoder count and what the servo lags at rest. [choice]
constexpr double kMeasuredEnd = 0.5;

/// Between what bounds a corner miss may be reported, mm. They are one, but where the tool passes
/// nearer to the target elsewhere on the two segments that meet there: then either may be meant.
struct MissBounds {
  double nearest = 0;
  double corner = 0;

  void widen(double nearest_pass, double corner_miss) {
    nearest = std::max(nearest, nearest_pass);
    corner = std::max(corner, corner_miss);
  }
};

/// One line's share of a run, summed over all the times that it ran.
struct LineShare {
  int count = 0;
  double starts = 0;
  double planned = 0;
  std::optional<double> decides;
  bool corner = false;       ///< has a target of its own, which STOP and END have not
  MissBounds planned_miss;   ///< the greatest of all times
  MissBounds measured_miss;  ///< from the measured positions of the trace
};

std::map<int, LineShare> shares_of(const PaulModel& model, const TraceFile& trace) {
  std::map<int, LineShare> shares;
  const std::vector<PaulSegment>& segments = model.segments();
  for (std::size_t i = 0; i < segments.size(); ++i) {
    const PaulSegment& segment = segments[i];
    const double end = segment.start + segment.span();
    LineShare& share = shares[segment.line];
    if (share.count == 0) share.starts = segment.start;
    if (!segment.further) ++share.count;
    if (share.count == 1) {
      share.decides = i + 1 < segments.size() ? std::optional(end) : std::nullopt;
    }
    share.planned += segment.span();
    if (segment.stop) continue;
    const auto measured = [&](double from, double to) {
      return measured_corner_miss(trace, segment.c, from, to, model.robot().tool_axes);
    };
    const double next_end = i + 1 < segments.size() ? end + segments[i + 1].span() : end;
    share.corner = true;
    share.planned_miss.widen(model.nearest_pass(i), model.corner_miss(i));
    share.measured_miss.widen(measured(segment.start, next_end),
                              measured(end, end + 2 * segment.t_out));
  }
  return shares;
}

/// Compares single entries and collects what differs, with the entry's place in the document.
class Comparison {
 public:
  explicit Comparison(Findings& findings) : findings_(findings) {}

  void number(const json& where, const std::string& place, const char* key, double should,
              double tolerance) {
    const json is = where.value(key, json());
    if (!is.is_number() || !(std::abs(is.get<double>() - should) <= tolerance)) {
      differs(place + key, is, should);
    }
  }
  void exactly(const json& where, const std::string& place, const char* key, const json& should) {
    const json is = where.value(key, json());
    if (is != should) differs(place + key, is, should);
  }
  void between(const json& where, const std::string& place, const char* key, MissBounds bounds) {
    const json is = where.value(key, json());
    if (!is.is_number() || !(is.get<double>() >= bounds.nearest - kMiss) ||
        !(is.get<double>() <= bounds.corner + kMiss)) {
      differs(place + key, is, bounds.corner);
    }
  }
  void number_or_null(const json& where, const std::string& place, const char* key,
                      std::optional<double> should, double tolerance) {
    if (should) return number(where, place, key, *should, tolerance);
    exactly(where, place, key, nullptr);
  }
  void differs(const std::string& what, const json& is, const json& should) {
    findings_.push_back(what + " is " + is.dump() + " instead of " + should.dump());
  }

 private:
  Findings& findings_;
};

void judge_line(const json& line, const LineShare& share, Comparison compare) {
  const std::string place = "line " + std::to_string(line.value("line", 0)) + ": ";
  compare.number(line, place, "starts_s", share.starts, kInstant);
  compare.number(line, place, "planned_s", share.planned, kInstant);
  compare.number(line, place, "measured_s", share.planned, kInstant);
  compare.number_or_null(line, place, "decides_s", share.decides, kInstant);
  if (share.count > 1) compare.number(line, place, "count", share.count, 0);
  if (!share.corner) return;
  const json miss = line.value("corner_miss_mm", json());
  if (!miss.is_object()) return compare.differs(place + "corner_miss_mm", miss, "an object");
  compare.between(miss, place + "corner_miss_mm.", "planned", share.planned_miss);
  compare.between(miss, place + "corner_miss_mm.", "measured", share.measured_miss);
}

void judge_lines(const json& lines, const std::map<int, LineShare>& shares, Comparison compare) {
  if (!lines.is_array()) return compare.differs("lines", lines, json::array());
  std::map<int, int> seen;
  for (const json& line : lines) {
    const int number = line.value("line", 0);
    ++seen[number];
    const auto share = shares.find(number);
    if (share == shares.end()) {
      compare.differs("line " + std::to_string(number), "listed", "no line that moves");
    } else {
      judge_line(line, share->second, compare);
    }
  }
  for (const auto& [number, share] : shares) {
    if (seen[number] != 1) compare.differs("line " + std::to_string(number), seen[number], 1);
  }
}

void judge_final(const json& report, const PaulModel& model, Comparison compare) {
  const AxisValues end = model.at(model.total()).q;
  const json final = report.value("final", json::object());
  const json joints = final.value("joints", json::array());
  if (joints.size() != end.size()) return compare.differs("final.joints", joints, end);
  for (std::size_t i = 0; i < end.size(); ++i) {
    if (!joints[i].is_number() || !(std::abs(joints[i].get<double>() - end[i]) <= kMeasuredEnd)) {
      compare.differs("final.joints[" + std::to_string(i) + "]", joints[i], end[i]);
    }
  }
  const json pose = final.value("pose", json::object());
  compare.number(pose, "final.pose.", "x", end[0], kMeasuredEnd);
  compare.number(pose, "final.pose.", "y", end[1], kMeasuredEnd);
}

}  // namespace

Findings judge_report(const json& report, const PaulModel& model, const TraceFile& trace,
                      const RunLimits& limits, const std::vector<std::string>& output) {
  Findings findings;
  Comparison compare(findings);
  if (!report.is_object()) return {"the report is no JSON object"};
  compare.exactly(report, "", "status", "done");
  compare.exactly(report, "", "robot", "gantry");
  compare.exactly(report, "", "law", "paul");
  compare.exactly(report, "", "clock", "virtual");
  compare.exactly(report, "", "error", nullptr);
  compare.exactly(report, "", "output", output);
  compare.exactly(report, "", "late_cycles", 0);
  compare.exactly(report, "", "cycles", periods_in(model.total(), limits.period));
  compare.number(report, "", "planned_s", model.total(), kInstant);
  compare.number(report, "", "measured_s", model.total(), kInstant);
  judge_lines(report.value("lines", json()), shares_of(model, trace), compare);
  judge_final(report, model, compare);
  return findings;
}

}  // namespace rob::test
