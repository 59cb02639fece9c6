#include <algorithm>
#include <cmath>
#include <fstream>
#include <stdexcept>
#include <utility>

#include "motion/robots/robot_library.h"
#include "tests/support/motion_drawing.h"
#include "tests/support/plot.h"
#include "tests/support/traced_run.h"

namespace rob::test {

namespace {

/// S1's program.
constexpr const char* kTriangle =
    "MOVE(40, 40, 0)\nMOVE(140, 40, 0)\nMOVE(90, 126, 0)\nMOVE(40, 40, 0)\nSTOP\nEND\n";

constexpr double kLeft = 70, kWidth = 770, kLane = 74;

/// How the triangle is run, and how that is called.
struct Way {
  const char* words;
  const char* law;
  bool jerk;  ///< the gantry's bound of the jerk counts
};

constexpr Way kWays[] = {{"Paul's law", "paul", true},
                         {"look-ahead, jerk unlimited", "lookahead", false},
                         {"look-ahead, jerk at most 1000 mm/s³", "lookahead", true}};

/// The gantry's file, if need be without its bounds of the jerk.
std::string gantry_file(bool jerk) {
  const auto robots = motion::embedded_robots();
  const auto gantry =
      std::ranges::find_if(robots, [](const auto& r) { return r.name == "gantry"; });
  std::string text(gantry->text);
  for (std::size_t at = 0; !jerk && (at = text.find("\nj_max", at)) != std::string::npos;)
    text.erase(at, text.find('\n', at + 1) - at);
  return text;
}

TraceFile trace_of(const std::string& rob, const Way& way) {
  const ScratchFolder scratch;
  const std::string file = (scratch.path() / "gantry.toml").string();
  std::ofstream(file) << gantry_file(way.jerk);
  TracedRun run = run_traced(rob, kTriangle, file, {"--law", way.law});
  if (!run.done()) throw std::runtime_error(run.trouble());
  return std::move(run.trace);
}

double speed_of(const TraceRow& row) { return std::hypot(row.qd[0], row.qd[1]); }

/// Both axes' accelerations, and above them the tool's speed.
std::string lanes(const TraceFile& trace, const Way& way, double top, double longest) {
  const Plot speed{{kLeft, top + 24}, kWidth, kLane, 0, longest, 0, 32};
  const Plot rate{{kLeft, top + 24 + kLane + 10}, kWidth, kLane, 0, longest, -110, 110};
  std::vector<Point> v, x, y;
  for (std::size_t k = 0; k < trace.rows.size(); k += 2) {
    const TraceRow& row = trace.rows[k];
    v.push_back({row.t, speed_of(row)});
    x.push_back({row.t, row.qdd[0]});
    y.push_back({row.t, row.qdd[1]});
  }
  std::string text = speed.ground() + speed.rules_y(10) + rate.ground() + rate.rules_y(100);
  text += speed.curve(v, "#0f172a") + rate.curve(x, "#2563eb", 1.5) + rate.curve(y, "#ea580c", 1.5);
  text += svg_text({kLeft, top + 16}, fmt::format("{}: {:.2f} s", way.words, trace.rows.back().t),
                   "font-weight=\"600\"");
  return text;
}

}  // namespace

Drawing triangle_drawing(const std::string& rob) {
  constexpr double kTop = 46, kHeight = 2 * kLane + 52;
  std::vector<TraceFile> traces;
  double longest = 0;
  for (const Way& way : kWays) {
    traces.push_back(trace_of(rob, way));
    longest = std::max(longest, traces.back().rows.back().t);
  }
  std::string text = svg_text({40, 28}, "The triangle on the gantry", "font-size=\"15\"");
  text += svg_text({300, 28}, "tool's speed, mm/s", "fill=\"#0f172a\"") +
          svg_text({470, 28}, "acceleration of x", "fill=\"#2563eb\"") +
          svg_text({610, 28}, "and of y, mm/s²", "fill=\"#ea580c\"");
  double top = kTop;
  for (std::size_t k = 0; k < traces.size(); ++k, top += kHeight)
    text += lanes(traces[k], kWays[k], top, longest);
  const Plot scale{{kLeft, top - 20}, kWidth, 0, 0, longest, 0, 1};
  for (int t = 0; t <= longest; t += 5)
    text += svg_text({scale(t, 0).x, top + 2}, fmt::format("{} s", t), "text-anchor=\"middle\"");
  return {880, top + 20, text};
}

}  // namespace rob::test
