// The report's peak beside the trace of the same run.
#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "tests/support/traced_run.h"

namespace {

/// The greatest n-th difference of an axis over the n-th power of the period: sums of binomials.
double greatest_difference(const rob::test::TraceFile& trace, std::size_t axis, int order) {
  const auto& rows = trace.rows;
  const double period = rows[1].t - rows[0].t;
  const double weights[][4] = {{1, -1, 0, 0}, {1, -2, 1, 0}, {1, -3, 3, -1}};
  double most = 0;
  for (std::size_t k = static_cast<std::size_t>(order); k < rows.size(); ++k) {
    double sum = 0;
    for (std::size_t i = 0; i <= static_cast<std::size_t>(order); ++i)
      sum += weights[order - 1][i] * rows[k - i].q[axis];
    most = std::max(most, std::abs(sum) / std::pow(period, order));
  }
  return most;
}

void check_peaks(const std::string& program, const std::string& robot,
                 const std::vector<std::string>& axes) {
  CAPTURE(program);
  CAPTURE(robot);
  const auto run = rob::test::run_traced(ROB_BINARY, program, robot);
  REQUIRE(run.done());
  REQUIRE(run.trace.rows.size() > 10);
  for (std::size_t axis = 0; axis < run.trace.axes; ++axis) {
    const auto& peak = run.report["peak"][axes[axis]];
    CAPTURE(axis);
    // Of digits that the trace does not have: 1e-13 deg or mm, over the period's third power.
    CHECK(peak["v"].get<double>() ==
          doctest::Approx(greatest_difference(run.trace, axis, 1)).epsilon(1e-6));
    CHECK(peak["a"].get<double>() ==
          doctest::Approx(greatest_difference(run.trace, axis, 2)).epsilon(1e-6));
    CHECK(peak["j"].get<double>() ==
          doctest::Approx(greatest_difference(run.trace, axis, 3)).epsilon(1e-4));
  }
}

}  // namespace

TEST_CASE("peak tells the greatest differences of the references in the trace") {
  const std::vector<std::string> gantry = {"x", "y", "theta"};
  const std::vector<std::string> arm = {"j1", "j2", "j3", "j4", "j5", "j6"};
  check_peaks("MOVE(100, 0, 0)\nMOVE(100, 80, 20)\nMOVE(0, 0, 0)\n", "gantry", gantry);
  check_peaks("LAW LOOKAHEAD\nMOVE(100, 0, 0)\nMOVE(100, 80, 20)\n", "gantry", gantry);
  check_peaks("LAW LOOKAHEAD\nMOVEL BY (30, 20, -10) AT 100mm/s\nMOVEL BY (0, -40, 0) AT 100mm/s\n",
              "irb120", arm);
  check_peaks("JOG WORLD (z: -50mm/s) FOR 0.5s\n", "lwa4p", arm);
}
