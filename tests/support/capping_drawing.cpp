#include <algorithm>
#include <cmath>
#include <fstream>
#include <sstream>
#include <stdexcept>

#include "tests/support/motion_drawing.h"
#include "tests/support/plot.h"
#include "tests/support/process.h"
#include "tests/support/scratch_folder.h"
#include "tests/support/trace_file.h"

namespace rob::test {

namespace {

constexpr double kLeft = 70, kWidth = 770, kLane = 96, kGap = 40;
constexpr double kShown = 26;      // s, as S4 shows
constexpr std::size_t kEvery = 8;  // rows

TraceFile trace_of(const std::string& rob, const std::string& program) {
  const ScratchFolder scratch;
  const std::string file = (scratch.path() / "capping.csv").string();
  const ProcessResult run = run_process({rob, "run", program, "--fast", "--trace", file});
  if (run.exit_code != 0) throw std::runtime_error("rob run " + program + ": " + run.err);
  std::stringstream text;
  text << std::ifstream(file).rdbuf();
  return parse_trace(text.str());
}

std::string lane(const Plot& plot, double step, const std::string& words,
                 const std::vector<Point>& points, const char* colour) {
  return plot.ground() + plot.rules_y(step) + plot.curve(points, colour, 1.4) +
         svg_text({plot.corner.x, plot.corner.y - 8}, words, "font-weight=\"600\"");
}

}  // namespace

Drawing capping_drawing(const std::string& rob, const std::string& examples) {
  const TraceFile trace = trace_of(rob, examples + "/20_capping.rob");
  const double end = trace.rows.back().t;
  std::vector<Point> force, torque, axis;
  for (std::size_t k = 0; k < trace.rows.size(); k += kEvery) {
    const TraceRow& row = trace.rows[k];
    if (row.t < end - kShown) continue;
    const double t = row.t - end + kShown;
    force.push_back({t, row.wrench[2]});
    torque.push_back({t, row.wrench[5]});
    axis.push_back({t, row.measured[5]});
  }
  const auto plot = [](int number, double low, double high) {
    const double top = 30 + number * (kLane + kGap);
    return Plot{{kLeft, top}, kWidth, kLane, 0, kShown, low, high};
  };
  const Plot last = plot(2, -130, 130);
  Drawing drawing;
  drawing.height = 30 + 3 * (kLane + kGap);
  drawing.content = lane(plot(0, -2, 16), 5, "force along z, N", force, "#2563eb") +
                    lane(plot(1, -0.2, 1.2), 0.5, "torque about z, Nm", torque, "#ea580c") +
                    lane(last, 60, "axis 6, deg", axis, "#0f172a") + last.rules_x(2);
  return drawing;
}

}  // namespace rob::test
