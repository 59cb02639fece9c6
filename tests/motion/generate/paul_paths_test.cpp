#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>

#include "motion/robots/time_scaling.h"
#include "tests/motion/generate/arm_run.h"
#include "tests/motion/kinematics/arms.h"
#include "tests/support/no_allocation.h"

using namespace rob::motion;
using namespace rob::test;
using Eigen::Vector3d;
using Kind = MotionEvent::Kind;

namespace {

/// Position, speed and acceleration belong together: the trapezium rule's error is T³/12 times the
/// third derivative of what is integrated. `jerk`: what the motion has at most of it.
void check_continuous(const GantryRun& run, double jerk) {
  const double t = run.robot().reference_period;
  double off_place = 0;
  double off_speed = 0;
  for (std::size_t k = 1; k < run.samples().size(); ++k) {
    const JointReference& a = run.samples()[k - 1].reference;
    const JointReference& b = run.samples()[k].reference;
    const JointVector way = b.q - a.q - (a.qd + b.qd) * (t / 2);
    const JointVector gain = b.qd - a.qd - (a.qdd + b.qdd) * (t / 2);
    off_place = std::max(off_place, way.cwiseAbs().maxCoeff());
    off_speed = std::max(off_speed, gain.cwiseAbs().maxCoeff());
  }
  CHECK(off_place < jerk * t * t * t / 12);
  CHECK(off_speed < jerk * t * t / 4);
}

void check_limits(const GantryRun& run) {
  for (const GeneratorSample& sample : run.samples()) {
    for (int i = 0; i < run.robot().axis_count(); ++i) {
      const Axis& axis = run.robot().axes[static_cast<std::size_t>(i)];
      REQUIRE(sample.reference.q[i] >= axis.min - 1e-9);
      REQUIRE(sample.reference.q[i] <= axis.max + 1e-9);
      REQUIRE(std::abs(sample.reference.qd[i]) <= axis.v_max * (1 + 1e-9));
      REQUIRE(std::abs(sample.reference.qdd[i]) <= axis.a_max * (1 + 1e-9));
    }
  }
}

double off_line(const Vector3d& p, const Vector3d& from, const Vector3d& to) {
  const Vector3d along = (to - from).normalized();
  return (p - from - along.dot(p - from) * along).norm();
}

/// Two lines at right angles, 120 mm each at 100 mm/s.
struct TwoLines {
  ArmRun run{"irb120"};
  Vector3d a, b, c;
  SegmentDescriptor first, second;

  TwoLines() {
    a = run.here().position;
    first = run.line(run.beside(0, 120, 0), at(100)).segment;
    b = run.here().position;
    second = run.line(run.beside(-120, 0, 0), at(100)).segment;
    c = run.here().position;
  }

  /// S1's curve on the tool's place, at t of the second segment.
  Vector3d law(double t) const {
    const double t_acc = run.robot().t_acc;
    const Vector3d dc = c - b;
    const Vector3d db = (a - b) * (t_acc / first.duration);
    if (t >= t_acc) return b + dc * (t / second.duration);
    const double h = (t + t_acc) / (2 * t_acc);
    return ((dc * (t_acc / second.duration) + db) * ((2 - h) * h * h) - 2 * db) * h + b + db;
  }
  double worst_in_second() const {
    double worst = 0;
    for (const GeneratorSample& sample : run.samples()) {
      if (sample.piece == 2 && sample.state != MotionState::Idle)
        worst = std::max(worst, (run.place(sample) - law(sample.sigma)).norm());
    }
    return worst;
  }
};

}  // namespace

TEST_CASE("the tool of every arm keeps its line, from rest to rest, at the speed that AT says") {
  for (const std::string& name : arm_names()) {
    CAPTURE(name);
    ArmRun run(name);
    run.move(turned_from_start(run.robot(), 0.2));
    run.stop();
    const Vector3d from = run.here().position;
    const auto line = run.line(run.beside(30, 60, -40, Vector3d(0.1, 0.2, 0.1)), at(20));
    const Vector3d to = run.here().position;
    run.stop();
    run.close();
    run.finish();
    const double way = (to - from).norm();
    CHECK(line.segment.duration == doctest::Approx(way / 0.02));
    double worst = 0;
    for (const GeneratorSample& sample : run.samples()) {
      if (sample.piece < 3) continue;
      worst = std::max(worst, off_line(run.place(sample), from, to));
      const bool even = sample.piece == 3 && sample.sigma > run.robot().t_acc;
      if (even)
        CHECK((run.place(sample) - from).norm() ==
              doctest::Approx(0.02 * sample.sigma).epsilon(1e-5));
    }
    CHECK(worst < 1e-6);
    CHECK((run.place(run.samples().back()) - to).norm() < 1e-9);
    check_limits(run);
    check_continuous(run, 400);
  }
}

TEST_CASE("a corner between two lines is Paul's quartic on the tool") {
  TwoLines lines;
  lines.run.stop();
  lines.run.close();
  lines.run.finish();
  CHECK(lines.worst_in_second() < 1e-6);
  check_limits(lines.run);
  check_continuous(lines.run, 400);
  // It passes the point at 3/16·t_acc·|v₂ − v₁|.
  double least = 1;
  for (const GeneratorSample& sample : lines.run.samples())
    least = std::min(least, (lines.run.place(sample) - lines.b).norm());
  CHECK(least == doctest::Approx(3.0 / 16 * 0.3 * 0.1 * std::sqrt(2)).epsilon(1e-3));
}

TEST_CASE("in a corner that turns the tool, too, its turning has no jump") {
  ArmRun run("irb120");
  run.line(run.beside(0, 100, 0, Vector3d(0, 0, 0.6)), at(100));
  run.line(run.beside(-50, 0, 50, Vector3d(0.5, 0, 0)), at(100));
  run.stop();
  run.close();
  run.finish();
  check_limits(run);
  check_continuous(run, 600);
}

TEST_CASE("a hold in a corner and a slower override keep the tool on the curve") {
  TwoLines lines;
  lines.run.stop();
  lines.run.close();
  while (lines.run.samples().empty() || lines.run.samples().back().piece < 2) lines.run.step();
  lines.run.generator().hold();
  for (int i = 0; i < 300; ++i) lines.run.step();
  CHECK(lines.run.samples().back().state == MotionState::Held);
  CHECK(std::abs(lines.run.samples().back().sigma) < lines.run.robot().t_acc);
  lines.run.generator().set_override(0.4);
  lines.run.generator().resume();
  lines.run.finish();
  CHECK(lines.worst_in_second() < 1e-6);
  check_limits(lines.run);
}

TEST_CASE("a line whose successor comes too late ends exactly, and the next one begins there") {
  ArmRun run("irb120");
  run.line(run.beside(0, 100, 0), at(100));
  const Vector3d corner = run.here().position;
  const Pose next = run.beside(-100, 0, 0);
  const auto planned =
      std::get<PlannedSegment>(run.planner().plan(at(100), *ToolLine::between(run.here(), next)));
  REQUIRE(planned.segment.corner != nullptr);
  for (int i = 0; i < 500; ++i) run.step();
  CHECK(run.saw(Kind::LateDecision));
  CHECK((run.place(run.samples().back()) - corner).norm() < 1e-9);
  run.push(planned.segment);
  run.stop();
  run.close();
  run.finish();
  double worst = 0;
  for (const GeneratorSample& sample : run.samples())
    if (sample.piece == 2)
      worst = std::max(worst, off_line(run.place(sample), corner, next.position));
  CHECK(worst < 1e-6);
  check_continuous(run, 400);
}

TEST_CASE("corners between axes, lines, arcs and splines keep the limits and have no jump") {
  for (const std::string name : {"irb120", "lwa4p", "ums7"}) {
    CAPTURE(name);
    ArmRun run(name);
    const JointVector start = run.robot().start;
    run.line(run.beside(0, 60, 30), at(40));
    run.move(turned_from_start(run.robot(), 0.3));
    Pose from = run.here();
    Pose to = run.beside(0, -80, 0);
    run.along(ToolArc::through(from, run.beside(30, -40, 10).position, to).value(), at(40));
    run.line(run.beside(20, 0, 40), at(40));
    from = run.here();
    to = run.beside(-40, -40, 0);
    run.along(
        ToolSpline::through({from, run.beside(0, -30, 20), run.beside(-30, -20, 10), to}).value(),
        at(40));
    run.move(move_to(start));
    run.stop();
    run.close();
    run.finish();
    CHECK_FALSE(run.saw(Kind::LateDecision));
    CHECK((run.samples().back().reference.q - start).norm() < 1e-12);
    check_limits(run);
    check_continuous(run, 500);
  }
}

TEST_CASE("a guarded line that is hit brakes on the line") {
  ArmRun run("irb120");
  const Vector3d from = run.here().position;
  struct Touched {
    static WatchAnswer test(const void* /*self*/, const CycleView& view) noexcept {
      return view.time > 0.6 ? WatchAnswer::Yes : WatchAnswer::No;
    }
  };
  auto planned = std::get<PlannedSegment>(
      run.planner().plan(at(100), *ToolLine::between(run.here(), run.beside(0, 150, 0))));
  planned.segment.guard = {&Touched::test, nullptr};
  run.push(planned.segment);
  const Vector3d to = run.here().position;
  for (int i = 0; i < 400; ++i) run.step();
  REQUIRE(run.rests().size() == 1);
  CHECK(run.rests().front().outcome == Rest::Outcome::Hit);
  for (const GeneratorSample& sample : run.samples())
    CHECK(off_line(run.place(sample), from, to) < 1e-6);
  const double way = (run.place(run.samples().back()) - from).norm();
  CHECK(way > 0.1 * (0.6 - 0.3));
  CHECK(way < 0.1 * 1.2);
  check_limits(run);
}

TEST_CASE("a profile begins and ends at rest, in the axes and along a line") {
  for (const bool led : {false, true}) {
    CAPTURE(led);
    ArmRun run("irb120");
    run.line(run.beside(0, 100, 0), at(100));
    const Vector3d before = run.here().position;
    MotionRequest how = profiled(at(100), Profile::Cosine);
    PlannedSegment profile;
    if (led) {
      profile = run.line(run.beside(-100, 0, 0), how);
    } else {
      const MotionRequest target = turned_from_start(run.robot(), 0.2);
      how.given = target.given;
      how.target = target.target;
      run.move(how);
      profile.segment.duration = 0;
    }
    const Vector3d behind = run.here().position;
    run.line(run.beside(0, 0, 50), at(100));
    run.stop();
    run.close();
    run.finish();
    int stands = 0;
    for (const GeneratorSample& sample : run.samples()) {
      const Vector3d p = run.place(sample);
      if (sample.reference.qd.isZero(1e-12) &&
          ((p - before).norm() < 1e-9 || (p - behind).norm() < 1e-9))
        ++stands;
    }
    CHECK(stands >= 1);
    const auto started = run.all(Kind::SegmentStarted);
    REQUIRE(started.size() >= 4);
    // The line before has been made exact, which takes its 2·t_acc.
    CHECK(started[1].time == doctest::Approx(1.0 + 2 * 0.3));
    if (led) CHECK(started[2].time - started[1].time == doctest::Approx(profile.segment.duration));
    check_limits(run);
  }
}

TEST_CASE("a line's references take no memory") {
  TwoLines lines;
  lines.run.move(turned_from_start(lines.run.robot(), 0.2));
  lines.run.stop();
  lines.run.close();
  CycleView view;
  view.reference = view.measured = lines.run.robot().start;
  const NoAllocation guard;
  for (int period = 0; period < 1500; ++period) {
    lines.run.generator().look(view);
    lines.run.generator().advance(period);
  }
  CHECK(guard.count() == 0);
}
