#include <doctest/doctest.h>

#include <limits>
#include <memory>
#include <variant>
#include <vector>

#include "motion/path/tool_arc.h"
#include "motion/path/tool_line.h"
#include "motion/plan/motion_planner.h"
#include "motion/space/rotation.h"
#include "tests/motion/ahead/ahead_run.h"
#include "tests/support/topp.h"

// The guide's time against a second solver of time-optimal motion on the same path, which shares no
// code with it (tests/support/topp.h).

using namespace rob::motion;
using Eigen::Vector3d;
using rob::test::AheadRun;
using rob::test::AxisValues;
using rob::test::time_optimal;
using rob::test::ToppLimits;
using rob::test::ToppMotion;
using rob::test::ToppNode;

namespace {

RobotModel without_jerk(const char* name) {
  RobotModel robot = embedded_robot(name);
  robot.law = Law::LookAhead;
  for (Axis& axis : robot.axes) axis.j_max = std::numeric_limits<double>::infinity();
  return robot;
}

/// A robot that is commanded along paths of its tool, and the path that is planned for it.
class PathRun {
 public:
  explicit PathRun(const char* name, double speed)
      : run_(without_jerk(name), 256), planner_(run_.robot(), run_.robot().start), speed_(speed) {}

  Pose here() const { return planner_.tool_pose(); }
  Pose beside(double x_mm, double y_mm, double z_mm, const Vector3d& turned = Vector3d::Zero()) {
    return {here().position + Vector3d(x_mm, y_mm, z_mm) / 1000,
            rotation_by(turned) * here().orientation};
  }
  void line(const Pose& to) { along(ToolLine::between(here(), to).value()); }
  void arc(const Vector3d& via, const Pose& to) {
    along(ToolArc::through(here(), via, to).value());
  }
  void joints(const JointVector& by) {
    MotionRequest request = asked();
    request.relative = true;
    for (int i = 0; i < by.size(); ++i) {
      request.target[static_cast<std::size_t>(i)] = by[i];
      request.given |= static_cast<std::uint8_t>(1U << static_cast<unsigned>(i));
    }
    take(planner_.plan(request));
  }

  /// s from rest to rest, in whole periods.
  double run() {
    run_.close();
    for (PathRing::Index seen = 0; !run_.ended() || seen == 0;) {
      run_.step();
      for (; seen < run_.ring().end(); ++seen) keep(run_.ring().written(seen));
    }
    return static_cast<double>(run_.references().size()) * run_.robot().reference_period;
  }

  /// The same path by the second solver.
  ToppMotion best() const {
    ToppLimits limits;
    for (const Axis& axis : run_.robot().axes) {
      limits.v.push_back(axis.v_max);
      limits.a.push_back(axis.a_max);
    }
    return time_optimal(nodes_, limits, 20'000);
  }

  /// Of all axes, as a share of what they have.
  double greatest_acceleration() const {
    double greatest = 0;
    for (int i = 0; i < run_.robot().axis_count(); ++i) {
      const double most = run_.robot().axes[static_cast<std::size_t>(i)].a_max;
      greatest = std::max(greatest, run_.peak_acceleration(i) / most);
    }
    return greatest;
  }

 private:
  MotionRequest asked() const {
    MotionRequest request;
    request.pace = MotionRequest::Pace::ToolSpeed;
    request.pace_value = speed_;
    request.zone = MotionRequest::Zone::Length;
    request.zone_value = 2e-3;
    return request;
  }
  void along(const ToolPath& path) { take(planner_.plan(asked(), path)); }
  void take(const PlanOutcome& outcome) {
    REQUIRE(std::holds_alternative<PlannedSegment>(outcome));
    planned_.push_back(std::get<PlannedSegment>(outcome));
    run_.buffer().push(planned_.back().segment);
  }
  /// Its beginning and end are nodes: a quintic between them is the piece itself.
  void keep(const Piece& piece) {
    for (const double at : {0.0, piece.length}) {
      const PathPoint p = piece.point(at);
      const auto values = [](const JointVector& v) {
        return AxisValues(v.data(), v.data() + v.size());
      };
      nodes_.push_back({piece.begin + at, values(p.q), values(p.qd), values(p.qdd), piece.pace});
    }
  }

  AheadRun run_;
  MotionPlanner planner_;
  double speed_;
  std::vector<PlannedSegment> planned_;  ///< segments point into these
  std::vector<ToppNode> nodes_;
};

/// As fast as can be but for what is lost in pieces and periods, and no faster.
void check_time(PathRun& run) {
  const double time = run.run();
  const double best = run.best().time;
  CAPTURE(time);
  CAPTURE(best);
  CHECK(time <= 1.01 * best);
  CHECK(time >= 0.999 * best);
  CHECK(run.greatest_acceleration() <= 1.02);
}

}  // namespace

TEST_CASE("an arm's tool on lines with corners is within 1 % of the fastest there is") {
  for (const double speed : {0.15, 0.6}) {
    PathRun run("irb120", speed);
    run.line(run.beside(120, 0, 0));
    run.line(run.beside(0, 150, -60));
    run.line(run.beside(-180, -80, 90));
    run.line(run.beside(60, -140, -40));
    check_time(run);
  }
}

TEST_CASE("an arm on arcs, lines that turn the tool, and its own axes is within 1 %, too") {
  for (const char* name : {"irb120", "lwa4p", "pc104"}) {
    CAPTURE(name);
    PathRun run(name, 0.3);
    run.line(run.beside(-60, 40, -30, {0.2, 0, 0.3}));
    run.arc(run.beside(-40, 60, 0).position, run.beside(-80, 100, -20));
    run.joints((JointVector(6) << 0.2, 0.1, -0.15, 0.3, 0.2, -0.4).finished());
    run.line(run.beside(20, -90, 20));
    check_time(run);
  }
}
