#include "tests/support/trace_figures.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <limits>

#include "tests/support/made_trace.h"

using namespace rob::test;

namespace {

constexpr double kNone = std::numeric_limits<double>::infinity();

/// Rest to rest over 100 mm with 100 mm/s and 1000 mm/s²: 0.1 s up, 0.9 s on, 0.1 s down.
AxisState trapezoid(double t) {
  constexpr double v = 100, a = 1000, up = v / a, end = 1.1;
  t = std::clamp(t, 0.0, end);
  if (t < up) return {{a * t * t / 2}, {a * t}, {t > 0 ? a : 0}};
  if (t <= end - up) return {{v * up / 2 + v * (t - up)}, {v}, {0}};
  const double left = end - t;
  return {{100 - a * left * left / 2}, {a * left}, {left > 0 ? -a : 0}};
}

/// j·t³/6 for 0.1 s.
AxisState ramp(double t) {
  constexpr double j = 1e4;
  return {{j * t * t * t / 6}, {j * t * t / 2}, {j * t}};
}

bool tells(const std::vector<std::string>& findings, const std::string& what) {
  return std::any_of(findings.begin(), findings.end(),
                     [&](const std::string& f) { return f.find(what) != std::string::npos; });
}

const std::vector<AxisBounds> kBounds = {{-1, 100, 100, 1000, kNone}};

}  // namespace

TEST_CASE("speed, acceleration and duration of a trapezoid are those it is made of") {
  TraceFile trace = made_trace(1.3, 0.001, trapezoid);
  const TracePeaks peaks = peaks_of(trace);
  CHECK(peaks.v[0] == doctest::Approx(100));
  CHECK(peaks.a[0] == doctest::Approx(1000));
  // Its acceleration leaps by 1000 mm/s² within half a row at the ends, and by as much in the row
  // where the ramp ends: third differences of 1000/0.001 at most.
  CHECK(peaks.j[0] <= 1e6 * (1 + 1e-6));
  CHECK(peaks.j[0] >= 0.5e6);
  CHECK(motion_time(trace) == doctest::Approx(1.1).epsilon(1e-9));
  CHECK(judge_bounds(trace, kBounds).empty());
}

TEST_CASE("a wait before and behind a motion is none of its time") {
  const auto late = [](double t) { return trapezoid(t - 0.25); };
  CHECK(motion_time(made_trace(2, 0.001, late)) == doctest::Approx(1.1).epsilon(1e-9));
}

TEST_CASE("the third difference of a cubic is its jerk") {
  CHECK(peaks_of(made_trace(0.1, 0.001, ramp)).j[0] == doctest::Approx(1e4).epsilon(1e-6));
}

TEST_CASE("second differences find an acceleration that qdd does not own up to") {
  const auto liar = [](double t) {
    AxisState state = ramp(t);
    state.qdd = {0};
    return state;
  };
  CHECK(peaks_of(made_trace(0.1, 0.001, liar)).a[0] == doctest::Approx(990).epsilon(1e-6));
}

TEST_CASE("each bound that is broken is told by its name") {
  const TraceFile trace = made_trace(1.3, 0.001, trapezoid);
  const auto told = [&](AxisBounds bounds) { return judge_bounds(trace, {bounds}); };
  CHECK(tells(told({-1, 99, 100, 1000, kNone}), "position"));
  CHECK(tells(told({-1, 100, 99, 1000, kNone}), "speed"));
  CHECK(tells(told({-1, 100, 100, 950, kNone}), "acceleration"));
  CHECK(tells(told({-1, 100, 100, 950, kNone}), "second difference"));
  CHECK(tells(told({-1, 100, 100, 1000, 1e5}), "third difference"));
  CHECK(tells(judge_bounds(made_trace(0.5, 0.001, trapezoid), kBounds), "speed at the end"));
}

TEST_CASE("a leap of position or of speed is found whatever the other columns say") {
  TraceFile trace = made_trace(1.3, 0.001, trapezoid);
  for (std::size_t k = 500; k < trace.rows.size(); ++k) trace.rows[k].q[0] -= 0.01;
  CHECK(tells(judge_bounds(trace, kBounds), "leap of position"));
  trace = made_trace(1.3, 0.001, trapezoid);
  for (std::size_t k = 500; k < 900; ++k) trace.rows[k].qd[0] -= 2;
  CHECK(tells(judge_bounds(trace, kBounds), "leap of speed"));
}
