#include "motion/generate/look_ahead_generator.h"

#include <doctest/doctest.h>

#include "motion/path/tool_line.h"
#include "motion/path/tool_spiral.h"
#include "tests/motion/generate/look_ahead_run.h"
#include "tests/support/no_allocation.h"

using namespace rob::motion;
using namespace rob::test;
using Kind = MotionEvent::Kind;

namespace {

/// Rounding, and the guide's own.
constexpr double kMost = 1 + 1e-6;

void check_limits(const LookAheadRun& run) {
  const LookAheadRun::Peak peak = run.peak();
  CHECK(peak.speed <= kMost);
  CHECK(peak.acceleration <= kMost);
  CHECK(peak.jerk <= kMost);
}

/// m from the nearest of the references.
double distance_from(const LookAheadRun& run, const JointVector& q) {
  double least = 1;
  for (const GeneratorSample& sample : run.samples())
    least = std::min(least, (sample.reference.q - q).head<2>().norm());
  return least;
}

double x_mm(const JointVector& q) { return q[0] * 1000; }

WatchAnswer first_input(const void*, const CycleView& view) noexcept {
  return (view.inputs & 1) != 0 ? WatchAnswer::Yes : WatchAnswer::No;
}
constexpr Watch kFirstInput{first_input, nullptr};

}  // namespace

TEST_CASE(
    "the look-ahead generator arrives exactly, within limits, and starts each motion in turn") {
  LookAheadRun run;
  give_published_program(run);
  run.finish();
  REQUIRE(run.all(Kind::Finished).size() == 1);
  CHECK((run.last().q - gantry_q(40, 40, 0)).norm() < 1e-15);
  CHECK(run.last().qd.norm() == 0);
  const auto started = run.all(Kind::SegmentStarted);
  REQUIRE(started.size() == 5);
  for (std::size_t i = 0; i < started.size(); ++i) CHECK(started[i].number == i + 1);
  CHECK(run.generator().late_decisions() == 0);
  check_limits(run);
}

// v = 20 mm/s, a = 100 mm/s², j = 1000 mm/s³.
TEST_CASE("one line lasts as long as by a third-order profile, d/v + v/a + a/j") {
  LookAheadRun run;
  run.move(100, 0);
  run.close();
  run.finish();
  const double profile = 100.0 / 20 + 20.0 / 100 + 100.0 / 1000;
  // The mean is one of samples, and takes from its first to its last.
  const double time = profile - run.robot().reference_period;
  CHECK(run.all(Kind::Finished).at(0).time == doctest::Approx(time).epsilon(1e-9));
  check_limits(run);
}

TEST_CASE("a hold anywhere keeps the axes on their path and within their limits") {
  LookAheadRun whole;
  give_published_program(whole);
  whole.finish();
  for (int k = 5; k < 1600; k += 97) {
    LookAheadRun run;
    give_published_program(run);
    run.until(k * 0.01);
    run.generator().hold();
    run.until(k * 0.01 + 1.5);
    CAPTURE(k);
    REQUIRE(run.all(Kind::Held).size() == 1);
    CHECK(run.last().qd.norm() == 0);
    // References of the whole run lie 0.2 mm apart; the mean moves a corner by at most a·T²/24.
    CHECK(distance_from(whole, run.last().q) < 0.0003);
    run.generator().resume();
    run.finish();
    REQUIRE(run.all(Kind::Finished).size() == 1);
    CHECK((run.last().q - gantry_q(40, 40, 0)).norm() < 1e-15);
    check_limits(run);
  }
}

TEST_CASE("an override stretches a line, and changes within limits") {
  LookAheadRun run;
  run.move(100, 0);
  run.close();
  run.until(2);
  run.generator().set_override(0.5);
  run.until(3);
  CHECK(run.last().qd[0] == doctest::Approx(0.010));
  CHECK(run.samples().back().limit == 21);
  run.generator().set_override(1);
  run.until(4);
  CHECK(run.last().qd[0] == doctest::Approx(0.020));
  run.finish();
  check_limits(run);
}

TEST_CASE("a corner into a curve that winds round the point stays within its zone") {
  LookAheadRun run;
  const auto add = [&](const ToolPath& path) {
    MotionRequest how;
    how.zone = MotionRequest::Zone::Length;
    how.zone_value = 0.001;
    run.push(std::get<PlannedSegment>(run.planner().plan(how, path)).segment);
  };
  const Pose from = run.planner().tool_pose();
  const Pose point{from.position + Eigen::Vector3d(0.1, 0.1, 0), from.orientation};
  add(*ToolLine::between(from, point));
  add(*ToolSpiral::inwards(point, point.orientation, 0.002, 20));
  run.close();
  run.finish();
  const Eigen::Vector3d along = (point.position - from.position).normalized();
  double worst = 0;
  for (const GeneratorSample& sample : run.samples()) {
    const Eigen::Vector3d p = run.robot().kinematics->forward(sample.reference.q).position;
    const Eigen::Vector3d off = p - from.position;
    const double beside = (off - off.dot(along) * along).norm();
    worst = std::max(worst, std::min(beside, (p - point.position).norm() - 2 * 0.002));
  }
  CHECK(worst <= 0.001);
}

TEST_CASE("an effect in a corner is due where the motion behind it begins") {
  LookAheadRun run;
  run.move(40, 0);
  run.effect(7);
  run.move(40, 40);
  run.effect(8);
  run.close();
  run.finish();
  const auto effects = run.all(Kind::EffectDue);
  REQUIRE(effects.size() == 2);
  CHECK(effects[0].time == run.all(Kind::SegmentStarted).at(1).time);
  CHECK(effects[1].time == run.all(Kind::Finished).at(0).time);
  // Symmetric: both axes are at 20 mm/s before and behind; in the middle they are alike.
  const double t = effects[0].time;
  const auto k = static_cast<std::size_t>(t / 0.01);
  const JointReference& before = run.samples()[k].reference;
  const JointVector q = before.q + before.qd * (t - before.time);
  CHECK(40 - q[0] * 1000 == doctest::Approx(q[1] * 1000).epsilon(0.02));
}

TEST_CASE("a target that is given twice is passed without a stop, and its effects with it") {
  LookAheadRun run;
  run.move(100, 50, 30);
  run.move(150, 80, 45);
  run.effect(7);
  run.move(150, 80, 45);
  run.effect(8);
  run.move(200, 80, 45);
  run.close();
  run.finish();
  const auto started = run.all(Kind::SegmentStarted);
  REQUIRE(started.size() == 4);
  const auto effects = run.all(Kind::EffectDue);
  REQUIRE(effects.size() == 2);
  CHECK(effects[0].time == started[2].time);
  CHECK(effects[1].time == started[3].time);
  CHECK((run.last().q - gantry_q(200, 80, 45)).norm() < 1e-15);
  check_limits(run);
}

TEST_CASE("a guarded motion brakes where its condition holds, and a new path begins there") {
  LookAheadRun run;
  run.move(100, 0, 0, kFirstInput);
  run.until(3);
  const double x = x_mm(run.last().q);
  run.inputs = 1;
  run.until(5);
  REQUIRE(run.rests().size() == 1);
  CHECK(run.rests()[0].outcome == Rest::Outcome::Hit);
  CHECK(run.rests()[0].q == run.last().q);
  // From 20 mm/s at 100 mm/s²: 2 mm of the guide, which is ahead of the reference by half the mean.
  CHECK(x_mm(run.last().q) - x == doctest::Approx(2 + 20 * 0.045).epsilon(0.11));
  run.inputs = 0;
  run.planner().retarget(run.rests()[0].q);
  run.move(0, 50);
  run.close();
  run.finish();
  REQUIRE(run.all(Kind::Finished).size() == 1);
  CHECK((run.last().q - gantry_q(0, 50, 0)).norm() < 1e-15);
  check_limits(run);
}

TEST_CASE("a guarded motion with its exact end rests once, whenever its condition comes") {
  for (int before = -3; before <= 3; ++before) {
    LookAheadRun whole;
    whole.move(20, 0, 0);
    whole.close();
    whole.finish();
    LookAheadRun run;
    run.move(20, 0, 0, kFirstInput);
    auto exact = run.planner().stop(0);
    REQUIRE(exact);
    exact->guard = kFirstInput;
    run.push(*exact);
    run.until(static_cast<double>(whole.period() + before) * run.robot().reference_period);
    run.inputs = 1;
    for (int i = 0; i < 200; ++i) run.step();
    CHECK(run.rests().size() == 1);
  }
}

TEST_CASE("a program that falls silent slows the robot smoothly to a stop, and is counted") {
  LookAheadRun run;
  run.move(40, 0);
  run.until(4);
  CHECK(run.generator().late_decisions() == 1);
  CHECK((run.last().q - gantry_q(40, 0, 0)).norm() < 1e-12);
  run.move(40, 40);
  run.close();
  run.finish();
  CHECK((run.last().q - gantry_q(40, 40, 0)).norm() < 1e-15);
  check_limits(run);
}

TEST_CASE("the end of what is known is told where the guide brakes for it, and only there") {
  const auto told = [](const LookAheadRun& run) {
    std::vector<double> times;
    for (const GeneratorSample& sample : run.samples())
      if (sample.limit == 20) times.push_back(sample.reference.time);
    return times;
  };
  LookAheadRun known;
  known.move(40, 0);
  known.move(40, 40);
  known.close();
  known.finish();
  CHECK(told(known).empty());

  LookAheadRun silent;
  silent.move(40, 0);
  silent.until(4);
  const std::vector<double> times = told(silent);
  // 40 mm at 20 mm/s and 100 mm/s²: the guide speeds up for 0.2 s, and brakes from 2 s on, less
  // what a corner there could take.
  REQUIRE(times.size() > 3);
  CHECK(times.front() > 1.5);
  CHECK(times.front() < 2);
  CHECK(times.back() < 2.3);
}

TEST_CASE("a LEAD is kept while the override stays, and else tells by how much it was not") {
  constexpr double kLead = 0.4;
  for (const double later : {1.0, 0.5}) {
    CAPTURE(later);
    LookAheadRun run;
    SegmentDescriptor segment =
        std::get<PlannedSegment>(run.planner().plan(move_to(gantry_q(100, 0, 0)))).segment;
    segment.on_the_way.push_back({.share = 0.5, .lead = kLead});
    run.push(segment);
    run.close();
    while (run.all(Kind::ActionDue).empty()) run.step();
    const double came = run.all(Kind::ActionDue)[0].time;
    run.generator().set_override(later);
    run.finish();
    // The line's middle, at even speed: where the references are between two samples.
    double passed = 0;
    for (const GeneratorSample& sample : run.samples()) {
      const JointReference& r = sample.reference;
      if (r.q[0] < 0.05) passed = r.time + (0.05 - r.q[0]) / r.qd[0];
    }
    const auto missed = run.all(Kind::LeadMissed);
    if (later == 1) {
      CHECK(missed.empty());
      CHECK(passed - came == doctest::Approx(kLead).epsilon(1e-9));
      continue;
    }
    REQUIRE(missed.size() == 1);
    CHECK(missed[0].time == doctest::Approx(passed));
    CHECK(missed[0].value == doctest::Approx(passed - came - kLead));
    CHECK(missed[0].value > 0.1);
  }
}

TEST_CASE("a dwell takes its time, under any override") {
  LookAheadRun run;
  run.move(20, 0);
  run.stop();
  run.push(run.planner().dwell(0, 0.5));
  run.move(0, 0);
  run.close();
  run.generator().set_override(0.5);
  run.finish();
  const auto started = run.all(Kind::SegmentStarted);
  REQUIRE(started.size() >= 3);
  const double stood = started.back().time - started[started.size() - 2].time;
  CHECK(stood >= 0.5 - 1e-9);
  CHECK(stood <= 0.51 + 1e-9);  // what moves begins at a stamp
  CHECK((run.last().q - gantry_q(0, 0, 0)).norm() < 1e-15);
}

TEST_CASE("late ticks of the look-ahead generator have the bits of punctual ones") {
  LookAheadRun punctual;
  give_published_program(punctual);
  punctual.finish();
  LookAheadRun late;
  give_published_program(late);
  for (int k = 0; k < 10; ++k) late.path_planner().work();
  for (std::int64_t period = 6; period < 1500; period += 7) {
    const GeneratorSample& sample = late.advance(period);
    const GeneratorSample& other = punctual.samples()[static_cast<std::size_t>(period)];
    REQUIRE(sample.reference.q == other.reference.q);
    REQUIRE(sample.reference.qd == other.reference.qd);
  }
}

TEST_CASE("the look-ahead tick takes no memory") {
  LookAheadRun run;
  give_published_program(run);
  run.path_planner().work();
  std::int64_t taken = 0;
  MotionEvent event;
  for (std::int64_t period = 0; period < 1800; ++period) {
    run.path_planner().work();
    NoAllocation guard;
    run.look();
    run.generator().advance(period);
    while (run.generator().take_event(event)) {
    }
    taken += guard.count();
  }
  CHECK(taken == 0);
}
