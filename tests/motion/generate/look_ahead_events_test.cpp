#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <iterator>

#include "tests/motion/generate/jog_bench.h"
#include "tests/motion/generate/look_ahead_run.h"
#include "tests/support/relative.h"

using namespace rob::motion;
using namespace rob::test;
using Kind = MotionEvent::Kind;
using Space = JogRates::Space;

namespace {

constexpr double kEventPeriod = 0.01;  // s, of the gantry
constexpr double kLag = 0.045;         // s: half of its mean of 10 periods, from first to last
constexpr double kRunLag = 0.095;  // s: the same in a run of which more may follow, of 20 periods
constexpr double kRounding = 1e-9;

SegmentDescriptor line(LookAheadRun& run, double x_mm, double y_mm) {
  auto outcome = run.planner().plan(move_to(gantry_q(x_mm, y_mm, 0)));
  return std::get<PlannedSegment>(outcome).segment;
}

/// An output so far along the motion, s sooner or (below 0) later.
void on_the_way(SegmentDescriptor& segment, double share, double lead, std::uint32_t id) {
  PathEvent event{.share = share, .lead = lead};
  event.effect.id = id;
  event.effect.after = segment.number;
  segment.on_the_way.push_back(event);
}

/// When the mean of 10 samples of 100 mm/s² up to 20 mm/s passes so many mm: the least time that is
/// far enough, by halving.
double mean_passes(double mm) {
  const auto guide = [](double t) {
    return t <= 0 ? 0 : t < 0.2 ? 50 * t * t : 2 + 20 * (t - 0.2);
  };
  double low = 0;
  double high = 1;
  for (int k = 0; k < 50; ++k) {
    const double middle = (low + high) / 2;
    double mean = 0;
    for (int i = 0; i < 10; ++i) mean += guide(middle - i * kEventPeriod) / 10;
    (mean < mm ? low : high) = middle;
  }
  return high;
}

void check_within_limits(const LookAheadRun& run) {
  const LookAheadRun::Peak peak = run.peak();
  CHECK(peak.speed <= 1 + 1e-6);
  CHECK(peak.acceleration <= 1 + 1e-6);
  CHECK(peak.jerk <= 1 + 1e-6);
}

}  // namespace

// 20 mm/s after 0.2 s and 2 mm: s mm are passed at 0.2 + (s − 2)/20, told half of the mean later.
TEST_CASE("an output on the way comes at its place, before it with LEAD, behind it with LAG") {
  LookAheadRun run;
  SegmentDescriptor segment = line(run, 100, 0);
  on_the_way(segment, 0.5, 0, 1);
  on_the_way(segment, 0.6, 0.1, 2);
  on_the_way(segment, 0.7, -0.1, 3);
  run.push(segment);
  run.close();
  run.finish();
  const auto due = run.all(Kind::ActionDue);
  REQUIRE(due.size() == 3);
  CHECK(due[0].time == doctest::Approx(0.2 + 48.0 / 20 + kLag).epsilon(kRounding));
  CHECK(due[1].time == doctest::Approx(0.2 + 58.0 / 20 - 0.1 + kLag).epsilon(kRounding));
  CHECK(due[2].time == doctest::Approx(0.2 + 68.0 / 20 + 0.1 + kLag).epsilon(kRounding));
}

// The references between two samples: by the last one's speed and acceleration, off by j·T³/6, and
// the cubic by which the instant is found by no more.
TEST_CASE("under low jerk an output comes where the references are, not where the guide would be") {
  RobotModel robot = gantry_looking_ahead();
  robot.axes[0].v_max = 0.5;
  robot.axes[0].a_max = 1;
  robot.axes[0].j_max = 5;  // a mean of 0.4 s: the references are up to 1·0.4²/24 m off the guide
  LookAheadRun run(robot);
  SegmentDescriptor segment = line(run, 300, 0);
  const double shares[] = {0.002, 0.02, 0.1, 0.3, 0.5, 0.8, 0.95, 0.999};
  for (const double share : shares)
    on_the_way(segment, share, 0, static_cast<std::uint32_t>(1000 * share));
  run.push(segment);
  run.close();
  run.finish();
  const auto due = run.all(Kind::ActionDue);
  REQUIRE(due.size() == std::size(shares));
  for (std::size_t i = 0; i < due.size(); ++i) {
    const auto after = std::ranges::find_if(run.samples(), [&](const GeneratorSample& sample) {
      return sample.reference.time + kEventPeriod > due[i].time;
    });
    const JointReference& r = after->reference;
    const double t = due[i].time - r.time;
    CAPTURE(shares[i]);
    CHECK(std::abs(r.q[0] + (r.qd[0] + r.qdd[0] * t / 2) * t - 0.3 * shares[i]) <
          2 * 5 * kEventPeriod * kEventPeriod * kEventPeriod / 6);
  }
}

TEST_CASE("an output at the end comes when the references rest there") {
  LookAheadRun run;
  SegmentDescriptor segment = line(run, 100, 0);
  on_the_way(segment, 1, 0, 1);
  run.push(segment);
  run.close();
  run.finish();
  // d/v + v/a and, of the mean of 10 periods, from its first to its last: 5 + 0.2 + 0.09 s.
  REQUIRE(run.all(Kind::ActionDue).size() == 1);
  CHECK(run.all(Kind::ActionDue)[0].time == doctest::Approx(5.29).epsilon(1e-6));
}

TEST_CASE("an output just before the middle of a corner comes before the next motion") {
  LookAheadRun run;
  SegmentDescriptor segment = line(run, 100, 0);
  on_the_way(segment, 1 - 1e-5, 0, 1);
  run.push(segment);
  run.effect(7);
  run.move(100, 100);
  run.close();
  run.finish();
  REQUIRE(run.all(Kind::ActionDue).size() == 1);
  REQUIRE(run.all(Kind::SegmentStarted).size() == 2);
  // 1 µm at 20 mm/s is much less than a period.
  const double before = run.all(Kind::SegmentStarted)[1].time - run.all(Kind::ActionDue)[0].time;
  CHECK(before > 0.5 * 1e-3 / 20);
  CHECK(before < 2 * 1e-3 / 20);
  CHECK(run.all(Kind::EffectDue).at(0).time == run.all(Kind::SegmentStarted)[1].time);
}

TEST_CASE(
    "an output at the end comes before one behind the motion, wherever in a period it rests") {
  for (int k = 0; k < 20; ++k) {
    LookAheadRun run;
    SegmentDescriptor segment = line(run, 100 + 0.013 * k, 0);
    on_the_way(segment, 1, 0, 1);
    run.push(segment);
    run.effect(2);
    run.close();
    run.finish();
    std::vector<std::uint32_t> order;
    for (const MotionEvent& event : run.events())
      if (event.kind == Kind::ActionDue || event.kind == Kind::EffectDue)
        order.push_back(event.effect.id);
    CAPTURE(k);
    CHECK(order == std::vector<std::uint32_t>{1, 2});
  }
}

TEST_CASE("a LAG that outlasts its motion comes at its time, while the robot stands") {
  for (const bool another : {false, true}) {
    CAPTURE(another);
    LookAheadRun run;
    SegmentDescriptor segment = line(run, 100, 0);
    on_the_way(segment, 1, -0.5, 1);
    run.push(segment);
    run.stop();
    if (!another) run.close();
    run.until(7);
    if (another) {  // the next motion comes when it is over
      run.push(line(run, 0, 0));
      run.close();
    }
    run.finish();
    REQUIRE(run.all(Kind::ActionDue).size() == 1);
    CHECK(run.all(Kind::ActionDue)[0].time == doctest::Approx(5.29 + 0.5).epsilon(1e-6));
    if (!another) CHECK(run.all(Kind::Finished)[0].time == doctest::Approx(5.79).epsilon(1e-6));
  }
}

TEST_CASE("a LEAD that is longer than the way from rest comes at the beginning, and is told") {
  const double there = mean_passes(2);
  for (const double lead : {0.5, there + 2e-4}) {  // by much, and by less than a period
    LookAheadRun run;
    SegmentDescriptor segment = line(run, 100, 0);
    on_the_way(segment, 0.02, lead, 1);
    on_the_way(segment, 0.2, lead, 2);
    run.push(segment);
    run.close();
    run.finish();
    const auto due = run.all(Kind::ActionDue);
    REQUIRE(due.size() == 2);
    CHECK(due[0].time == doctest::Approx(0));
    CHECK(due[1].time == doctest::Approx(0.2 + kLag + 18.0 / 20 - lead).epsilon(kRounding));
    const auto cut = run.all(Kind::LeadCut);
    REQUIRE(cut.size() == 1);
    CHECK(cut[0].value == relative(lead - there, 1e-3));
  }
}

TEST_CASE("under an override of a half an output on the way comes at the same place") {
  LookAheadRun run;
  SegmentDescriptor segment = line(run, 100, 0);
  on_the_way(segment, 0.5, 0, 1);
  run.push(segment);
  run.close();
  run.generator().set_override(0.5);
  run.finish();
  // 10 mm/s after 0.1 s and 0.5 mm.
  REQUIRE(run.all(Kind::ActionDue).size() == 1);
  CHECK(run.all(Kind::ActionDue)[0].time ==
        doctest::Approx(0.1 + 49.5 / 10 + kLag).epsilon(kRounding));
}

TEST_CASE("a jog between two motions begins and ends at rest, and the path goes on from there") {
  LookAheadRun run;
  run.move(20, 0);
  JogRates rates = jog_rates(Space::Joint, {0, 0.01, 0});
  rates.lasts = 1;
  run.push(std::get<PlannedSegment>(run.planner().jog(0, rates)).segment);
  for (int i = 0; i < 600 && run.rests().empty(); ++i) run.step();
  REQUIRE(run.rests().size() == 1);
  // 10 mm/s for 1 s: as far as it would go without ramps.
  CHECK((run.rests()[0].q - gantry_q(20, 10, 0)).norm() < 1e-9);
  run.planner().retarget(run.rests()[0].q);
  run.move(0, 0);
  run.close();
  run.finish();
  CHECK((run.last().q - gantry_q(0, 0, 0)).norm() < 1e-15);
  check_within_limits(run);
}

// The planner says how long the profile lasts, and the generator takes so long.
TEST_CASE("a motion with a profile takes its time between two motions that it leaves at rest") {
  LookAheadRun run;
  run.move(20, 0);
  MotionRequest request = move_to(gantry_q(20, 60, 0));
  request.profile = Profile::Cosine;
  const SegmentDescriptor segment = std::get<PlannedSegment>(run.planner().plan(request)).segment;
  run.push(segment);
  run.move(0, 60);
  run.close();
  run.finish();
  const auto started = run.all(Kind::SegmentStarted);
  REQUIRE(started.size() == 3);
  const double lasted = started[2].time - started[1].time;
  CHECK(lasted >= segment.duration - kRounding);
  CHECK(lasted <= segment.duration + kEventPeriod + kRounding);  // a path begins at a stamp
  CHECK((run.last().q - gantry_q(0, 60, 0)).norm() < 1e-15);
  check_within_limits(run);
}

TEST_CASE("braked, a motion ends on its way, and what is behind it is dropped") {
  LookAheadRun run;
  run.move(100, 0);
  run.move(100, 100);
  run.until(2);
  const double x = run.last().q[0];
  run.generator().brake();
  run.until(3);
  REQUIRE(run.rests().size() == 1);
  CHECK(run.last().qd.norm() == 0);
  CHECK(run.last().q == run.rests()[0].q);
  // 2 mm of the guide, which is ahead by half the mean at 20 mm/s.
  CHECK(run.last().q[0] - x == doctest::Approx(0.002 + 0.02 * kRunLag).epsilon(0.11));
  CHECK(std::abs(run.last().q[1]) < 1e-15);
  run.planner().retarget(run.rests()[0].q);
  run.move(0, 0);
  run.close();
  run.finish();
  CHECK((run.last().q - gantry_q(0, 0, 0)).norm() < 1e-15);
  check_within_limits(run);
}

TEST_CASE("more motions to one place than are looked ahead over end there, and the path goes on") {
  LookAheadRun run;
  run.move(10, 0);
  int given = 0;
  for (int i = 0; i < 20'000 && run.all(Kind::Finished).empty(); ++i) {
    while (given < 200 && run.buffer().room() > 1) {
      run.move(20, 0);
      ++given;
    }
    if (given == 200 && run.buffer().room() > 1) {
      run.move(20, 20);
      run.close();
      ++given;
    }
    run.step();
  }
  REQUIRE(run.all(Kind::Finished).size() == 1);
  CHECK((run.last().q - gantry_q(20, 20, 0)).norm() < 1e-15);
  check_within_limits(run);
}

TEST_CASE("a slow motion of next to no length arrives") {
  for (int k = 1; k <= 60; ++k) {
    LookAheadRun run;
    run.move(40.28, 92.72);
    run.stop();
    MotionRequest request = move_to(gantry_q(40.28 + 0.0007 * k, 92.72 - 0.0003 * k, 0));
    request.at_least = 0.1 * k;
    run.push(std::get<PlannedSegment>(run.planner().plan(request)).segment);
    run.close();
    run.finish(3000);
    CAPTURE(k);
    REQUIRE(run.all(Kind::Finished).size() == 1);
  }
}

// 13,000 mm/s³ on a table of 1000 mm/s² is a mean over T = 0.154 s: what it moves a corner inwards,
// and what braking and speeding up do, has to stay within the zone; without a bound it would be
// a·T²/24·√2/2 = 0.7 mm even of a corner that is passed at no speed.
TEST_CASE("a corner keeps its zone however long the mean of its references") {
  for (const double zone_mm : {0.02, 0.06, 0.2, 0.5, 1.0, 3.0}) {
    RobotModel table = gantry_looking_ahead();
    table.reference_period = table.servo_period = 0.001;
    for (int i = 0; i < 2; ++i) {
      Axis& axis = table.axes[static_cast<std::size_t>(i)];
      axis.v_max = axis.a_max = 1;
      axis.j_max = 13;
    }
    table.axes[2].a_max = table.axes[2].j_max * 0.05;
    LookAheadRun run(table);
    MotionRequest first = move_to(gantry_q(50, 0, 0));
    first.zone = MotionRequest::Zone::Length;
    first.zone_value = zone_mm / 1000;
    run.push(std::get<PlannedSegment>(run.planner().plan(first)).segment);
    run.move(50, 50);
    run.close();
    run.finish();
    double miss = 1;
    for (const GeneratorSample& sample : run.samples())
      miss = std::min(miss, (sample.reference.q - gantry_q(50, 0, 0)).norm());
    CAPTURE(zone_mm);
    CHECK(miss <= 1.01 * zone_mm / 1000);
    // Two third-order profiles of d = 50 mm take a/J + √((a/J)² + 4d/a) each, and overlap by
    // ∛(48·ZONE/(J·√2)), or a/J at most. With 3 mm a corner is faster.
    const double settles = 1.0 / 13;
    const double overlap = std::cbrt(48 * zone_mm / 1000 / (13 * std::sqrt(2.0)));
    const double stops = 2 * (settles + std::sqrt(settles * settles + 4 * 0.05));
    REQUIRE(run.all(Kind::Finished).size() == 1);
    CHECK(run.all(Kind::Finished)[0].time <= stops - std::min(settles, overlap) + 0.002);
    if (zone_mm > 1) CHECK(run.all(Kind::Finished)[0].time < stops - settles - 0.01);
    check_within_limits(run);
  }
}
