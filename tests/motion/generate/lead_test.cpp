#include <doctest/doctest.h>

#include <cmath>
#include <optional>

#include "motion/path/tool_line.h"
#include "tests/motion/generate/look_ahead_run.h"
#include "tests/support/no_allocation.h"
#include "tests/support/some_of.h"

using namespace rob::motion;
using namespace rob::test;
using Kind = MotionEvent::Kind;

namespace {

/// A table of 1 m/s and 1 m/s², 1 kHz; `jerk`: of its axes, m/s³.
RobotModel quick_table(double jerk) {
  RobotModel table = gantry_looking_ahead();
  table.reference_period = table.servo_period = 0.001;
  for (Axis& axis : table.axes) {
    axis.v_max = axis.a_max = 1;
    axis.j_max = jerk;
  }
  return table;
}

RobotModel arm_ahead(const char* name) {
  RobotModel robot = embedded_robot(name);
  robot.law = Law::LookAhead;
  return robot;
}

MotionRequest paced(double mm_per_s, double zone_mm) {
  MotionRequest request;
  request.pace = MotionRequest::Pace::ToolSpeed;
  request.pace_value = mm_per_s / 1000;
  request.zone = MotionRequest::Zone::Length;
  request.zone_value = zone_mm / 1000;
  return request;
}

/// Output 1, so long before the tool passes that place of the motion, m from its beginning.
void lead_to(SegmentDescriptor& segment, double place, double length, double lead) {
  PathEvent event{.share = place / length, .lead = lead};
  event.effect.id = 1;
  event.effect.after = segment.number;
  segment.on_the_way.push_back(event);
}

/// The tool of a reference.
Eigen::Vector3d tool_at(const LookAheadRun& run, const JointReference& r) {
  if (run.robot().kinematics == nullptr) return {r.q[0], r.q[1], 0};
  return run.robot().kinematics->forward(r.q).position;
}

/// When the tool of the references handed out comes through the plane at `place` across
/// `direction`, on the straight line between two of them.
double passes(const LookAheadRun& run, const Eigen::Vector3d& place,
              const Eigen::Vector3d& direction) {
  std::optional<double> before;
  for (const GeneratorSample& sample : run.samples()) {
    const JointReference& r = sample.reference;
    const double beyond = (tool_at(run, r) - place).dot(direction);
    if (before && *before < 0 && beyond >= 0)
      return r.time - run.robot().reference_period * beyond / (beyond - *before);
    before = beyond;
  }
  return -1;
}

/// The output came so long before the references passed the place, to within `share` of a period.
void check_lead(const LookAheadRun& run, double passed, double lead, double share) {
  const auto due = run.all(Kind::ActionDue);
  REQUIRE(due.size() == 1);
  REQUIRE(passed > 0);
  if (!run.all(Kind::LeadCut).empty()) {  // the motion is shorter than the lead
    CHECK(passed - due[0].time < lead + run.robot().reference_period);
    return;
  }
  CHECK(std::abs(passed - lead - due[0].time) <= share * run.robot().reference_period);
  CHECK(run.all(Kind::LeadMissed).empty());
}

/// From (0, 0) to (40, 0), (40, 40) and (80, 60) mm, with a place on the second line.
void lead_beside_corner(double jerk, double zone_mm, double place_mm, double lead) {
  LookAheadRun run(quick_table(jerk));
  const MotionRequest how = paced(300, zone_mm);
  const auto line = [&](double x_mm, double y_mm) {
    MotionRequest request = move_to(gantry_q(x_mm, y_mm, 0));
    request.pace = how.pace;
    request.pace_value = how.pace_value;
    request.zone = how.zone;
    request.zone_value = how.zone_value;
    return std::get<PlannedSegment>(run.planner().plan(request)).segment;
  };
  run.push(line(40, 0));
  SegmentDescriptor second = line(40, 40);
  lead_to(second, place_mm / 1000, 0.04, lead);
  run.push(second);
  run.push(line(80, 60));
  run.close();
  run.finish();
  CAPTURE(jerk);
  CAPTURE(zone_mm);
  CAPTURE(place_mm);
  CAPTURE(lead);
  // Between two references the speed changes by a·T: a·T²/8 beside the line between them, and the
  // speed there is at least 10 mm/s, so 1.25e-5 s.
  const Eigen::Vector3d place(0.04, place_mm / 1000, 0);
  check_lead(run, passes(run, place, Eigen::Vector3d::UnitY()), lead, 0.05);
}

/// From the start by (-30, 0, 0), (0, 0, -30) and (30, 0, 0) mm, with a place on the second line.
void lead_of_arm(const char* name, double place_mm, double lead) {
  LookAheadRun run(arm_ahead(name));
  const Eigen::Vector3d ways[] = {{-0.03, 0, 0}, {0, 0, -0.03}, {0.03, 0, 0}};
  Eigen::Vector3d place;
  for (int i = 0; i < 3; ++i) {
    const Pose from = run.planner().tool_pose();
    const Pose to{from.position + ways[i], from.orientation};
    const auto path = ToolLine::between(from, to).value();
    auto planned = std::get<PlannedSegment>(run.planner().plan(paced(100, 2), path));
    if (i == 1) {
      lead_to(planned.segment, place_mm / 1000, 0.03, lead);
      place = from.position - Eigen::Vector3d(0, 0, place_mm / 1000);
    }
    run.push(planned.segment);
  }
  run.close();
  run.finish();
  CAPTURE(name);
  CAPTURE(place_mm);
  CAPTURE(lead);
  check_lead(run, passes(run, place, -Eigen::Vector3d::UnitZ()), lead, 0.2);
}

}  // namespace

// Speed changes after a corner and before the next, so the mean is not half its time after the
// guide. Places are outside of the corners, which are no longer than 2·zone/tan(45°/2) here.
TEST_CASE("a LEAD is right within a period after a corner and before one, with and without jerk") {
  for (const double jerk : {1e9, 100.0, 13.0})
    for (const double zone_mm : {0.05, 0.5, 2.0})
      for (const double place_mm : {10.0, 12.0, 20.0, 28.0, 30.0})
        for (const double lead : {0.001, 0.005, 0.02, 0.05, 0.1})
          lead_beside_corner(jerk, zone_mm, place_mm, lead);
}

// A period is 8 ms or 4 ms: the line between two references is beside the tool's way by as much as
// a·T²/8, at 1 m/s² and 50 mm/s 0.16 ms.
TEST_CASE("a LEAD of an arm is right within a period beside its corners") {
  for (const char* name : rob::test::some_of("irb120", "lwa4p", "pc104", "ums7"))
    for (const double place_mm : {6.0, 10.0, 15.0, 24.0})
      for (const double lead : {0.001, 0.02, 0.05, 0.1}) lead_of_arm(name, place_mm, lead);
}

TEST_CASE("to foresee a place takes no memory") {
  LookAheadRun run(quick_table(13));
  run.move(40, 0);
  MotionRequest request = move_to(gantry_q(40, 40, 0));
  auto second = std::get<PlannedSegment>(run.planner().plan(request)).segment;
  lead_to(second, 0.03, 0.04, 0.05);
  run.push(second);
  run.close();
  for (int i = 0; i < 10; ++i) run.path_planner().work();
  std::int64_t taken = 0;
  int due = 0;
  MotionEvent event;
  for (std::int64_t period = 0; period < 1500; ++period) {
    run.path_planner().work();
    NoAllocation guard;
    run.look();
    run.generator().advance(period);
    while (run.generator().take_event(event)) due += event.kind == Kind::ActionDue ? 1 : 0;
    taken += guard.count();
  }
  CHECK(taken == 0);
  CHECK(due == 1);
}
