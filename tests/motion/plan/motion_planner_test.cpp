#include "motion/plan/motion_planner.h"

#include <doctest/doctest.h>

#include <cmath>
#include <numbers>

#include "motion/robots/robot_library.h"
#include "tests/support/degrees.h"
#include "tests/support/no_allocation.h"

using namespace rob::motion;
using Pace = MotionRequest::Pace;
using rob::test::kDegree;

namespace {

/// mm and deg; an axis is left out where the value is NaN.
MotionRequest request(double x_mm, double y_mm, double theta_deg) {
  MotionRequest wish;
  const double values[] = {x_mm / 1000, y_mm / 1000, theta_deg * kDegree};
  for (std::size_t i = 0; i < 3; ++i) {
    if (std::isnan(values[i])) continue;
    wish.given = static_cast<std::uint8_t>(wish.given | 1u << i);
    wish.target[i] = values[i];
  }
  return wish;
}

MotionRequest at_pace(MotionRequest wish, Pace pace, double value) {
  wish.pace = pace;
  wish.pace_value = value;
  return wish;
}

MotionRequest lasting(MotionRequest wish, double at_least) {
  wish.at_least = at_least;
  return wish;
}

constexpr double kLeftOut = std::numeric_limits<double>::quiet_NaN();

/// A gantry's planner that stands at (0, 0, 0).
struct GantryPlanner {
  RobotModel robot = embedded_robot("gantry");
  MotionPlanner planner{robot, robot.start};

  PlannedSegment take(const MotionRequest& wish) {
    return std::get<PlannedSegment>(planner.plan(wish));
  }
  JogRates jog(const JogRates& rates) {
    return *std::get<PlannedSegment>(planner.jog(1, rates)).segment.jog;
  }
  Refusal refusal(const MotionRequest& wish) { return std::get<Refusal>(planner.plan(wish)); }
};

}  // namespace

TEST_CASE("the published program's segments take 2.75, 5.00, 4.30, 4.30 and 2.75 s") {
  GantryPlanner p;
  CHECK(p.take(request(40, 40, 0)).segment.duration == doctest::Approx(2.75));
  CHECK(p.take(request(140, 40, 0)).segment.duration == doctest::Approx(5.0));
  CHECK(p.take(request(90, 126, 0)).segment.duration == doctest::Approx(4.3));
  CHECK(p.take(request(40, 40, 0)).segment.duration == doctest::Approx(4.3));
  const auto stop = p.planner.stop(9);
  REQUIRE(stop);
  CHECK(stop->duration == doctest::Approx(2.75));
  CHECK(stop->no_length);
  CHECK(stop->tag == 9);
  CHECK(stop->number == 5);
}

TEST_CASE("the slowest axis sets the time and is named") {
  GantryPlanner p;
  const PlannedSegment planned = p.take(request(100, 60, 90));  // 5, 3, 4.5 s
  CHECK(planned.segment.duration == doctest::Approx(5));
  CHECK(planned.segment.limit == 2);
  CHECK(p.take(request(100, 0, -90)).segment.limit == 4);    // 180° in 9 s
  CHECK(p.take(request(100, 300, -90)).segment.limit == 3);  // 300 mm in 15 s
  CHECK(p.take(request(100, 299, -90)).segment.limit == 0);  // the corners' 2.75 s
}

TEST_CASE("left-out axes stay where they were last told to go") {
  GantryPlanner p;
  p.take(request(50, 60, 70));
  const SegmentDescriptor segment = p.take(request(kLeftOut, 80, kLeftOut)).segment;
  CHECK(segment.target[0] == 0.05);
  CHECK(segment.target[1] == 0.08);
  CHECK(segment.target[2] == 70 * kDegree);
}

TEST_CASE("OVER is a lower bound on the time") {
  GantryPlanner p;
  CHECK(p.take(lasting(request(100, 0, 0), 8)).segment.duration == 8);
  const PlannedSegment planned = p.take(lasting(request(0, 0, 0), 5));
  CHECK(planned.segment.duration == doctest::Approx(5));
  CHECK(planned.warnings == 0);
}

TEST_CASE("an OVER that cannot be kept is stretched to the true time, with a warning") {
  GantryPlanner p;
  const PlannedSegment axes = p.take(lasting(request(100, 0, 0), 2));
  CHECK(axes.segment.duration == doctest::Approx(5));
  CHECK(axes.warnings == PlannedSegment::kStretched);
  const PlannedSegment corners = p.take(lasting(request(90, 0, 0), 1));
  CHECK(corners.segment.duration == doctest::Approx(2.75));
  CHECK(corners.warnings == PlannedSegment::kStretched);
}

TEST_CASE("AT a tool speed divides the tool's distance") {
  GantryPlanner p;
  // 3-4-5: 50 mm at 5 mm/s; theta does not count.
  const PlannedSegment planned = p.take(at_pace(request(30, 40, 90), Pace::ToolSpeed, 0.005));
  CHECK(planned.segment.duration == doctest::Approx(10));
  CHECK(planned.segment.limit == 1);
  CHECK(planned.warnings == 0);
}

TEST_CASE("AT an angular speed divides the turn of the rotary axis") {
  GantryPlanner p;
  const PlannedSegment planned =
      p.take(at_pace(request(100, 0, 90), Pace::AngularSpeed, 10 * kDegree));
  CHECK(planned.segment.duration == doctest::Approx(9));
  CHECK(planned.segment.limit == 1);
}

TEST_CASE("AT a share divides every axis' maximum") {
  GantryPlanner p;
  CHECK(p.take(at_pace(request(100, 0, 0), Pace::Share, 0.5)).segment.duration ==
        doctest::Approx(10));
  const PlannedSegment full = p.take(at_pace(request(0, 0, 0), Pace::Share, 1));
  CHECK(full.segment.duration == doctest::Approx(5));
  CHECK(full.segment.limit == 2);
  CHECK(full.warnings == 0);
}

TEST_CASE("AT above what the axes can do is cut, with a warning") {
  GantryPlanner p;
  const PlannedSegment tool = p.take(at_pace(request(100, 0, 0), Pace::ToolSpeed, 0.050));
  CHECK(tool.segment.duration == doctest::Approx(5));
  CHECK(tool.segment.limit == 2);
  CHECK(tool.warnings == PlannedSegment::kPaceCut);
  CHECK(p.take(at_pace(request(0, 0, 0), Pace::Share, 1.5)).warnings == PlannedSegment::kPaceCut);
  CHECK(p.take(at_pace(request(0, 0, 90), Pace::AngularSpeed, 1)).warnings ==
        PlannedSegment::kPaceCut);
}

TEST_CASE("an axis that AT does not name may be slower without a warning") {
  GantryPlanner p;
  const PlannedSegment planned = p.take(at_pace(request(60, 0, 90), Pace::ToolSpeed, 0.020));
  CHECK(planned.segment.duration == doctest::Approx(4.5));
  CHECK(planned.segment.limit == 4);
  CHECK(planned.warnings == 0);
}

TEST_CASE("a written motion of no length always takes its two half transitions") {
  GantryPlanner p;
  p.take(request(40, 40, 0));
  for (int i = 0; i < 2; ++i) {
    const SegmentDescriptor again = p.take(request(40, 40, 0)).segment;
    CHECK(again.no_length);
    CHECK(again.duration == doctest::Approx(2.75));
  }
}

TEST_CASE("a stop takes no time where the target is exact already") {
  GantryPlanner p;
  CHECK_FALSE(p.planner.stop(1));  // nothing has moved
  p.take(request(40, 40, 0));
  CHECK(p.planner.stop(2));
  CHECK_FALSE(p.planner.stop(3));
  p.take(request(80, 40, 0));
  p.take(request(80, 40, 0));
  CHECK_FALSE(p.planner.stop(4));
}

TEST_CASE("a target that differs by rounding is the last one") {
  GantryPlanner p;
  p.take(request(30, 0, 0));
  MotionRequest rounded = request(30, 0, 0);
  rounded.target[0] = 0.1 * 0.1 + 0.02 + 1e-17;
  CHECK(p.take(rounded).segment.no_length);
  CHECK(p.planner.commanded()[0] == 0.03);
  rounded.target[0] = 0.03 + 1e-8;  // ten nanometres are a motion
  CHECK_FALSE(p.take(rounded).segment.no_length);
}

TEST_CASE("a refused target changes nothing") {
  GantryPlanner p;
  p.take(request(40, 40, 0));
  const Refusal refusal = p.refusal(request(9000, 40, 0));
  CHECK(refusal.kind == Refusal::Kind::AboveMaximum);
  CHECK(refusal.axis == 0);
  CHECK(refusal.value == 9);
  CHECK(refusal.limit == 0.4);
  CHECK(p.planner.last_number() == 1);
  CHECK(p.planner.commanded()[0] == 0.04);
  CHECK(p.take(request(50, 40, 0)).segment.number == 2);
}

TEST_CASE("a target that rounding has put beyond a limit is put back onto it") {
  GantryPlanner p;
  MotionRequest wish = request(0, 0, 0);
  wish.target[0] = 0.4 + 1e-10;
  CHECK(p.take(wish).segment.target[0] == 0.4);
}

TEST_CASE("paces and times that are no positive numbers are refused") {
  GantryPlanner p;
  for (const double value : {0.0, -1.0, kLeftOut, HUGE_VAL}) {
    CAPTURE(value);
    CHECK(p.refusal(at_pace(request(40, 0, 0), Pace::ToolSpeed, value)).kind ==
          Refusal::Kind::BadPace);
  }
  for (const double value : {-1.0, kLeftOut, HUGE_VAL}) {
    CAPTURE(value);
    CHECK(p.refusal(lasting(request(40, 0, 0), value)).kind == Refusal::Kind::BadDuration);
  }
  const Refusal slow = p.refusal(at_pace(request(40, 0, 0), Pace::ToolSpeed, 1e-12));
  CHECK(slow.kind == Refusal::Kind::TooLong);  // 40 mm at 1e-12 m/s: 4e10 s
  CHECK(slow.value == doctest::Approx(4e10));
  CHECK(p.refusal(at_pace(request(40, 0, 0), Pace::Share, 1e-320)).kind == Refusal::Kind::TooLong);
}

TEST_CASE("an override above 1 raises AT and OVER, never an axis' maximum") {
  GantryPlanner p;
  p.planner.set_override(2);
  CHECK(p.take(at_pace(request(100, 0, 0), Pace::ToolSpeed, 0.005)).segment.duration ==
        doctest::Approx(10));
  CHECK(p.take(lasting(request(0, 0, 0), 16)).segment.duration == doctest::Approx(8));
  CHECK(p.take(lasting(request(100, 0, 0), 6)).segment.duration == doctest::Approx(5));
  CHECK(p.take(request(0, 0, 0)).segment.duration == doctest::Approx(5));
  p.planner.set_override(0.5);  // the generator's affair
  CHECK(p.take(request(100, 0, 0)).segment.duration == doctest::Approx(5));
}

TEST_CASE("the tip of a tool off the axis that turns counts for AT, for ZONE and for its way") {
  GantryPlanner p;
  p.planner.set_tool({Eigen::Vector3d(0.03, 0, 0.12), Eigen::Quaterniond::Identity()});
  // A quarter turn: 30·√2 mm on a straight line, 30 mm · π/2 at most beside it.
  CHECK(p.planner.way(request(0, 0, 90)) == doctest::Approx(0.03 * std::numbers::sqrt2));
  CHECK(p.planner.swing(request(50, 0, 90)) == doctest::Approx(0.03 * std::numbers::pi / 2));
  CHECK(p.planner.swing(request(50, 40, 0)) == 0);
  // t_C = 16·z / 3(v_in + v_max): the axes make 20·√2 mm/s, the turn 30 mm · 20 deg/s more.
  MotionRequest wish = request(100, 0, 0);
  wish.zone = MotionRequest::Zone::Length;
  wish.zone_value = 0.005;
  const double fastest = 0.02 * std::numbers::sqrt2 + 0.03 * 20 * kDegree;
  CHECK(p.take(wish).segment.t_acc == doctest::Approx(16 * 0.005 / (3 * (0.02 + fastest))));
  p.planner.set_tool({});
  CHECK(p.planner.way(request(100, 0, 90)) == 0);
}

TEST_CASE("after an early end left-out axes stay where the axes stand") {
  GantryPlanner p;
  p.take(request(100, 100, 0));
  JointVector q(3);
  q << 0.03, 0.04, 0;
  p.planner.retarget(q);
  CHECK_FALSE(p.planner.stop(1));
  const SegmentDescriptor segment = p.take(request(kLeftOut, 100, kLeftOut)).segment;
  CHECK(segment.target[0] == 0.03);
  CHECK(segment.duration == doctest::Approx(3));
}

TEST_CASE("a jog of whole periods lasts as many, whatever rounding the quotient has") {
  GantryPlanner p;  // its period is 0.01 s
  JogRates rates;
  rates.space = JogRates::Space::World;
  rates.rate = JointVector::Zero(6);
  for (int periods = 1; periods <= 1000; ++periods) {
    CAPTURE(periods);
    for (const double seconds : {periods / 100.0, periods * 0.01, (0.5 + periods) / 100 - 0.005}) {
      rates.lasts = seconds;
      CHECK(std::lround(100 * p.jog(rates).lasts) == periods);
    }
    rates.lasts = (periods + 1e-6) / 100;  // more than that is a period more
    CHECK(std::lround(100 * p.jog(rates).lasts) == periods + 1);
  }
}

TEST_CASE("an override above 1 makes a jog faster and shorter: its way stays") {
  GantryPlanner p;
  JogRates rates;
  rates.space = JogRates::Space::World;
  rates.rate = JointVector::Zero(6);
  rates.rate[0] = 0.004;
  rates.lasts = 3;
  p.planner.set_override(1.5);
  CHECK(p.jog(rates).rate[0] == doctest::Approx(0.006));
  CHECK(p.jog(rates).lasts == doctest::Approx(2));
}

TEST_CASE("rates beyond any axis are reduced to 1000 m/s or rad/s, all in the same ratio") {
  GantryPlanner p;
  JogRates rates;
  rates.space = JogRates::Space::World;
  rates.rate = JointVector::Zero(6);
  rates.rate[0] = -4e3;
  rates.rate[1] = 1e3;
  const auto planned = [&] { return p.jog(rates).rate; };
  CHECK(planned()[0] == doctest::Approx(-1e3));
  CHECK(planned()[1] == doctest::Approx(250));
  rates.rate[0] = 1e300;  // a product with the time would overflow
  CHECK(planned()[0] == doctest::Approx(1e3));
  rates.rate[0] = 600;  // below: as they are
  rates.rate[1] = 300;
  CHECK(planned()[0] == 600);
  p.planner.set_override(2);  // makes 1200 of 600
  CHECK(planned()[0] == doctest::Approx(1e3));
  CHECK(planned()[1] == doctest::Approx(500));
}

TEST_CASE("planning takes no memory") {
  GantryPlanner p;
  rob::test::NoAllocation guard;
  const PlanOutcome done = p.planner.plan(request(40, 40, 0));
  const PlanOutcome refused = p.planner.plan(request(4000, 40, 0));
  const auto stop = p.planner.stop(1);
  CHECK(guard.count() == 0);
  CHECK(std::holds_alternative<PlannedSegment>(done));
  CHECK(std::holds_alternative<Refusal>(refused));
  CHECK(stop);
}
