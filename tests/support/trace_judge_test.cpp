#include "tests/support/trace_judge.h"

#include <doctest/doctest.h>

#include <cmath>
#include <functional>
#include <limits>

#include "tests/support/published_program.h"
#include "tests/support/traced_corner.h"

using namespace rob::test;

namespace {

Findings judged(const TraceFile& trace) {
  return judge_against_model(trace, published_program(), gantry_limits());
}

Findings judged_smooth(const TraceFile& trace) {
  return judge_smoothness(trace, gantry_limits().period, greatest_jerk(published_program()));
}

}  // namespace

TEST_CASE("19.10 s are 1910 periods of 10 ms, whatever the sum rounds to") {
  CHECK(periods_in(19.10, 0.01) == 1910);
  CHECK(periods_in(2.75 + 5.0 + 4.3 + 4.3 + 2.75, 0.01) == 1910);
  CHECK(periods_in(19.101, 0.01) == 1911);
  CHECK(periods_in(0, 0.01) == 0);
}

TEST_CASE("a faultless trace is found faultless") {
  const TraceFile trace = published_trace();
  CHECK(judged(trace).empty());
  CHECK(judged_smooth(trace).empty());
}

TEST_CASE("a row too few, a late row and a wrong line are found") {
  TraceFile trace = published_trace();
  trace.rows.pop_back();
  CHECK_FALSE(judged(trace).empty());
  trace = published_trace();
  trace.rows[700].t += 1e-6;
  CHECK_FALSE(judged(trace).empty());
  trace = published_trace();
  trace.rows[776].line = 2;  // line 3 owns 7.76 s
  CHECK_FALSE(judged(trace).empty());
}

TEST_CASE("at a decision point either line may own the instant") {
  TraceFile trace = published_trace();
  trace.rows[775].line = 2;
  CHECK(judged(trace).empty());
}

TEST_CASE("a micrometre, a hundredth of that in a rate, and a NaN are found") {
  const auto found = [](const std::function<void(TraceRow&)>& spoil) {
    TraceFile trace = published_trace();
    spoil(trace.rows[900]);
    return !judged(trace).empty();
  };
  CHECK(found([](TraceRow& row) { row.q[1] += 1e-3; }));
  CHECK(found([](TraceRow& row) { row.qd[0] += 1e-5; }));
  CHECK(found([](TraceRow& row) { row.qdd[2] -= 1e-5; }));
  CHECK(found([](TraceRow& row) { row.q[0] = std::numeric_limits<double>::quiet_NaN(); }));
  CHECK(found([](TraceRow& row) { row.measured[1] += 0.6; }));
  CHECK(found([](TraceRow& row) { row.pose[0] += 1e-3; }));
}

TEST_CASE("a limit that the run crosses is found") {
  RunLimits narrow = gantry_limits();
  narrow.max[0] = 130;  // the triangle reaches about x = 132 mm
  CHECK_FALSE(judge_against_model(published_trace(), published_program(), narrow).empty());
}

TEST_CASE("the smoothness rules find a jump of each derivative without knowing the law") {
  const auto found = [](const std::function<void(TraceRow&)>& spoil) {
    TraceFile trace = published_trace();
    for (std::size_t k = 900; k < trace.rows.size(); ++k) spoil(trace.rows[k]);
    return !judged_smooth(trace).empty();
  };
  CHECK(found([](TraceRow& row) { row.q[0] += 1e-5; }));
  CHECK(found([](TraceRow& row) { row.qd[0] += 2e-3; }));
  CHECK(found([](TraceRow& row) { row.qdd[0] += 0.4; }));
}

TEST_CASE("the fastest change of acceleration is 1.5 (v2 - v1) / t_acc^2") {
  CHECK(greatest_jerk(published_program()) == doctest::Approx(1.5 * 40 / (1.375 * 1.375)));
}

TEST_CASE("the corners found in a trace are those of the published program") {
  const TraceFile trace = published_trace();
  CHECK(std::abs(traced_corner_miss(trace, {40, 40, 0}, 2.75, 5.5, 2) - 4.0) < 0.05);
  CHECK(std::abs(traced_corner_miss(trace, {140, 40, 0}, 7.75, 10.5, 2) - 9.6) < 0.05);
  CHECK(std::abs(measured_corner_miss(trace, {90, 126, 0}, 12.05, 14.8, 2) - 10.3) < 0.05);
  CHECK(traced_corner_miss(trace, {40, 40, 0}, 16.35, 19.1, 2) < 1e-6);
}

TEST_CASE("between two rows the references bend as their velocities say") {
  // Half a turn of a hairpin: from (0, 0) to (0, 1), out and back with 4 mm/s in x. The cubic
  // reaches x = 4·(s(1−s)² + s²(1−s)) = 1 at s = 1/2, where y = 1/2.
  TraceFile trace{.axes = 2, .rows = std::vector<TraceRow>(2)};
  trace.rows[0].q = {0, 0};
  trace.rows[0].qd = {4, 0};
  trace.rows[1].t = 1;
  trace.rows[1].q = {0, 1};
  trace.rows[1].qd = {-4, 0};
  CHECK(traced_corner_miss(trace, {1, 0.5}, 0, 1, 2) == doctest::Approx(0));
  CHECK(traced_corner_miss(trace, {2, 0.5}, 0, 1, 2) == doctest::Approx(1));
}
