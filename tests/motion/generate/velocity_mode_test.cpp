#include <doctest/doctest.h>

#include <random>

#include "motion/robots/robot_library.h"
#include "tests/motion/generate/jog_bench.h"
#include "tests/support/no_allocation.h"

using namespace rob::motion;
using namespace rob::test;
using Space = JogRates::Space;

namespace {

constexpr double kDeg = std::numbers::pi / 180;

/// Random rates, one and a half times as fast as the axes, or up to 0.5 m/s and 1 rad/s.
JogRates random_rates(const RobotModel& robot, Space space, std::mt19937& random) {
  std::uniform_real_distribution<double> share(-1, 1);
  JogRates rates;
  rates.space = space;
  rates.rate.setZero(space == Space::Joint ? robot.axis_count() : 6);
  const bool plane = robot.axis_count() == 3;
  for (int i = 0; i < rates.rate.size(); ++i) {
    if (share(random) < 0) continue;
    if (space == Space::Joint) {
      rates.rate[i] = share(random) * 1.5 * robot.axes[static_cast<std::size_t>(i)].v_max;
    } else if (!plane || i < 2 || i == 5) {
      rates.rate[i] = share(random) * (i >= 3 ? 1 : plane ? 0.03 : 0.5);
    }
  }
  if (share(random) > 0.5) rates.tip.position = {0, 0.05, plane ? 0 : 0.1};
  return rates;
}

}  // namespace

TEST_CASE("whatever is asked for, way, speed, acceleration and jerk of every axis hold") {
  for (const char* name : {"gantry", "ums7", "pc104", "puma560", "lwa4p", "irb120"}) {
    for (const Space space : {Space::Joint, Space::World, Space::Tool}) {
      CAPTURE(name);
      CAPTURE(static_cast<int>(space));
      JogBench bench(name);
      std::mt19937 random(static_cast<unsigned>(space));
      std::uniform_real_distribution<double> share(0, 1);
      // Where references are dense a debug build is slow.
      const int changes = bench.robot.reference_period < 0.01 ? 3 : 30;
      for (int change = 0; change < changes; ++change) {
        const JogRates rates = random_rates(bench.robot, space, random);
        if (!bench.mode.takes(rates)) bench.come_to_rest();
        bench.run(rates, 1.2 * share(random) * share(random), share(random) < 0.1 ? 0.3 : 1);
      }
      bench.come_to_rest();
      bench.check_limits();
      CHECK(bench.speed > 0.1);  // it has been asked for something
    }
  }
}

TEST_CASE("a jog goes as far as its rate times its time, however it speeds up and slows down") {
  // It slows down as it has sped up, so what the one lacks the other makes good.
  JogBench gantry("gantry");
  gantry.run(jog_rates(Space::Joint, {0.01, -0.0, 0.1}), 1.0);
  gantry.come_to_rest();
  CHECK(gantry.q()[0] == doctest::Approx(0.01).epsilon(1e-12));
  CHECK(gantry.q()[1] == 0);
  CHECK(gantry.q()[2] == doctest::Approx(0.1).epsilon(1e-12));
  gantry.check_limits();
}

TEST_CASE("the tool keeps its line and its orientation in the world") {
  for (const char* name : {"ums7", "pc104", "puma560"}) {
    CAPTURE(name);
    JogBench bench(name);
    const Pose from = bench.tool();
    JogRates rates = jog_rates(Space::World, {0.03, 0.02, -0.04, 0, 0, 0});
    const Eigen::Vector3d line = rates.rate.head<3>().normalized();
    bench.mode.aim(rates);
    for (int i = 0; i * bench.robot.reference_period < 1; ++i) {
      bench.step();
      const Eigen::Vector3d way = bench.tool().position - from.position;
      REQUIRE((way - line * line.dot(way)).norm() < 1e-12);  // rounding of forward and inverse
      REQUIRE(bench.tool().orientation.angularDistance(from.orientation) < 1e-7);
    }
    const Eigen::Vector3d before = bench.tool().position;
    bench.step();
    const Eigen::Vector3d way = bench.tool().position - before;
    CHECK((way - rates.rate.head<3>() * bench.robot.reference_period).norm() < 1e-9);
    bench.come_to_rest();
    bench.check_limits();
  }
}

TEST_CASE("rates of the fixed angles go on through b = 90 degrees, and are theirs there") {
  // The UMS-7's hand level: b = 90 degrees and no heading; q5 turns it on from there.
  JogBench bench("ums7", joints_deg({0, -45, 135, 0, 0, 0}));
  FixedAngles level = fixed_angles(bench.tool().orientation);
  REQUIRE(std::abs(level.b) == doctest::Approx(90 * kDeg).epsilon(1e-12));
  // On and back again: R = Rz(c)·Ry(b)·Rx(a) with b alone changed, whatever it is told as.
  for (const double rate : {0.3, -0.3}) {
    const Pose from = bench.tool();
    bench.run(jog_rates(Space::World, {0, 0, 0, 0, rate, 0}), 0.4);
    bench.come_to_rest();
    const Pose to = bench.tool();
    const double turned = from.orientation.angularDistance(to.orientation);
    CHECK(turned == doctest::Approx(0.12).epsilon(0.01));
    level.b += std::copysign(turned, rate);
    CHECK(orientation_from(level).angularDistance(to.orientation) < 1e-7);
    CHECK((from.position - to.position).norm() < 1e-9);
  }
  // Across: b comes from 86 degrees, goes through 90 and ends at 98, where a and c are told anew.
  JogBench across("ums7", joints_deg({0, -45, 135, 0, 4, 0}));
  FixedAngles angles = fixed_angles(across.tool().orientation);
  REQUIRE(angles.b == doctest::Approx(86 * kDeg).epsilon(1e-9));
  const double turn = 12 * kDeg;
  across.run(jog_rates(Space::World, {0, 0, 0, 0, turn / 0.8, 0}), 0.8);
  across.come_to_rest();
  const double turned = orientation_from(angles).angularDistance(across.tool().orientation);
  CHECK(turned == doctest::Approx(turn).epsilon(0.01));
  angles.b += turned;  // b alone has changed, to 98 degrees and not back
  CHECK(orientation_from(angles).angularDistance(across.tool().orientation) < 1e-7);
  across.check_limits();
}

TEST_CASE("a twist of the tool is along its own axes") {
  JogBench bench("ums7");
  const Pose from = bench.tool();
  bench.run(jog_rates(Space::Tool, {0.01, 0, 0.02, 0, 0, 0.1}), 1);
  bench.come_to_rest();
  const Pose to = bench.tool();
  const Eigen::AngleAxisd turn(from.orientation.conjugate() * to.orientation);
  CHECK(turn.angle() == doctest::Approx(0.1).epsilon(1e-9));
  CHECK(turn.axis().z() == doctest::Approx(1).epsilon(1e-12));
  // A helix: the chord of the arc of 0.01 m turned by 0.1 rad, and the lead (by hand).
  const Eigen::Vector3d seen = from.orientation.conjugate() * (to.position - from.position);
  CHECK(seen.z() == doctest::Approx(0.02).epsilon(1e-9));
  CHECK(seen.x() == doctest::Approx(0.1 * std::sin(0.1)).epsilon(1e-9));
  CHECK(seen.y() == doctest::Approx(0.1 * (1 - std::cos(0.1))).epsilon(1e-9));
}

TEST_CASE("a jog into the end of an axis stands short of it, and can leave at once") {
  JogBench bench("gantry");
  bench.run(jog_rates(Space::Joint, {-0.02, 0.02, 0}), 0.5);
  CHECK(bench.mode.stands());  // at the start x is at its end, and the direction is kept
  CHECK(bench.mode.stopped());
  CHECK(bench.mode.limit().kind == JogLimit::Kind::End);
  CHECK(bench.mode.limit().axis == 0);
  bench.run(jog_rates(Space::Joint, {0.02, 0, 0}), 30);
  CHECK(bench.mode.stands());
  CHECK(bench.q()[0] <= 0.4);
  CHECK(bench.q()[0] > 0.4 - 1e-4);
  bench.run(jog_rates(Space::Joint, {-0.02, 0, 0}), 0.2);
  CHECK(bench.q()[0] < 0.4 - 1e-4);
  CHECK(!bench.mode.stopped());
  bench.check_limits();
}

TEST_CASE("an axis that is beyond its limit goes back only") {
  JogBench bench("gantry");
  JointVector beyond = bench.robot.start;
  beyond[0] = 0.41;
  bench.mode.stand_at(beyond);
  bench.run(jog_rates(Space::World, {0.02, 0, 0, 0, 0, 0}), 0.5);
  CHECK(bench.q()[0] == doctest::Approx(0.41).epsilon(1e-9));
  bench.run(jog_rates(Space::World, {-0.02, 0, 0, 0, 0, 0}), 1);
  bench.come_to_rest();
  CHECK(bench.q()[0] == doctest::Approx(0.39).epsilon(1e-6));
}

TEST_CASE("a jog that stretches the arm stands short of it, and goes back") {
  JogBench bench("ums7");
  const Eigen::Vector3d from = bench.tool().position;
  bench.run(jog_rates(Space::World, {0.2, 0, 0, 0, 0, 0}), 2);
  CHECK(bench.mode.stands());
  CHECK(bench.mode.stopped());
  // Two links of 0.4 m, the hand 0.1 m down, axis 2 at 0.5 m: x = sqrt(0.8² − (z + 0.1 − 0.5)²)
  const double border = std::sqrt(0.64 - std::pow(from.z() - 0.4, 2));
  CHECK(bench.tool().position.x() < border);
  CHECK(bench.tool().position.x() > border - 0.001);
  bench.run(jog_rates(Space::World, {-0.2, 0, 0, 0, 0, 0}), 1);
  bench.come_to_rest();
  CHECK(bench.tool().position.x() < border - 0.02);
  bench.check_limits();
}

TEST_CASE(
    "beside the singular wrist and shoulder the axes keep their speed, and the tool its line") {
  // The UMS-7's wrist comes by at about 1 degree from in line: axis 4 has to swing round.
  JogBench wrist("ums7", joints_deg({0, -45, 135, 0, 8, 0}));
  const Pose from = wrist.tool();
  wrist.mode.aim(jog_rates(Space::Tool, {0, 0, 0, 0.07, -0.5, 0}));
  double slowest = 1;
  for (int i = 0; i < 200; ++i) {
    wrist.step();
    slowest = std::min(slowest, wrist.mode.granted());
    REQUIRE((wrist.tool().position - from.position).norm() < 1e-9);
  }
  CHECK(slowest < 0.2);
  CHECK(wrist.speed > 0.8);  // nearly as fast as the axis permits
  CHECK(std::abs(wrist.q()[3]) > 60 * kDeg);
  CHECK(from.orientation.angularDistance(wrist.tool().orientation) > 20 * kDeg);
  wrist.check_limits();

  // Straight through: axis 4 stays, and nothing is slowed.
  JogBench through("ums7", joints_deg({0, -45, 135, 0, 8, 0}));
  through.run(jog_rates(Space::Tool, {0, 0, 0, 0, -0.5, 0}), 1);
  CHECK(through.mode.granted() == 1);
  CHECK(through.q()[4] < -8 * kDeg);
  CHECK(std::abs(through.q()[3]) < 1e-9);
  through.check_limits();

  // The UMS-7's wrist passes 10 mm beside axis 1.
  JogBench shoulder("ums7", joints_deg({90, -100, 120, 0, 60, 0}));
  const Eigen::Vector3d start = shoulder.tool().position;
  const Eigen::Vector3d aim(0.01, 0, start.z());
  const Eigen::Vector3d line = (aim - start).normalized();
  JogRates pass = jog_rates(Space::World, {0, 0, 0, 0, 0, 0});
  pass.rate.head<3>() = line * 0.3;
  shoulder.mode.aim(pass);
  for (int i = 0; i < 200; ++i) {
    shoulder.step();
    const Eigen::Vector3d way = shoulder.tool().position - start;
    REQUIRE((way - line * line.dot(way)).norm() < 1e-9);
  }
  shoulder.check_limits();
}

TEST_CASE("wherever random jogs have led an arm, it can leave") {
  for (const char* name : {"gantry", "ums7"}) {
    CAPTURE(name);
    JogBench bench(name);
    std::mt19937 random(11);
    for (int n = 0; n < 40; ++n) {
      const JogRates away = random_rates(bench.robot, Space::World, random);
      if (!bench.mode.takes(away)) bench.come_to_rest();
      bench.run(away, 0.6);
      bench.come_to_rest();
      const JointVector stuck = bench.q();
      // Back the way it came, at once.
      JogRates back = away;
      back.rate = -away.rate;
      if (away.rate.isZero(0) || (bench.robot.start - stuck).norm() < 1e-3) continue;
      bench.run(back, 0.4);
      CHECK((bench.q() - stuck).norm() > 1e-5);
    }
    bench.check_limits();
  }
}

TEST_CASE("rates that are renewed as they are go on, and other ones join without a stop") {
  JogBench bench("ums7");
  const JogRates rates = jog_rates(Space::World, {-0.05, 0, 0, 0, 0, 0});
  bench.run(rates, 0.5);
  for (int i = 0; i < 20; ++i) {
    const double x = bench.tool().position.x();
    bench.run(rates, 0.04);
    CHECK(bench.tool().position.x() - x == doctest::Approx(-0.05 * 0.04).epsilon(1e-9));
  }
  bench.mode.aim(jog_rates(Space::World, {-0.05, 0.02, 0, 0, 0, 0}));
  for (int i = 0; i < 20; ++i) {
    const double x = bench.tool().position.x();
    bench.step();
    CHECK(bench.tool().position.x() - x == doctest::Approx(-0.05 * 0.04).epsilon(1e-6));
  }
  CHECK(!bench.mode.takes(jog_rates(Space::Tool, {0.05, 0, 0, 0, 0, 0})));
  bench.check_limits();
}

TEST_CASE("what AT bounds is not passed") {
  JogBench bench("ums7");
  JogRates rates = jog_rates(Space::Joint, {1, 0, 0, 0, 0, 0});
  rates.share = 0.25;
  bench.run(rates, 1);
  CHECK(bench.speed == doctest::Approx(0.25).epsilon(1e-9));
  CHECK(bench.mode.limit().kind == JogLimit::Kind::Share);
  bench.come_to_rest();
  rates.share = 1;
  rates.tool_speed = 0.02;
  bench.run(rates, 1);
  const double radius = bench.tool().position.head<2>().norm();
  CHECK(bench.mode.reference().qd[0] * radius == doctest::Approx(0.02).epsilon(1e-6));
}

TEST_CASE("what a change of rates has left beside the next one does not lead the tool aside") {
  // S4's capping at 50 Hz: z slowly down, ever less, and the hand begins to turn meanwhile. Turning
  // takes 0.15 s to come to speed; if z went on slowing down so long, it would go up.
  JogBench arm("lwa4p");
  arm.run(jog_rates(Space::World, {0, 0, -5e-3, 0, 0, 0}), 0.1);
  arm.run(jog_rates(Space::World, {0, 0, -0.8e-3, 0, 0, 0}), 0.008);
  const double before = arm.tool().position.z();
  double highest = -1;
  for (int k = 0; k < 50; ++k) {
    const double z = arm.tool().position.z();
    arm.run(jog_rates(Space::World, {0, 0, -0.8e-3, 0, 0, -0.8}), arm.robot.reference_period);
    highest = std::max(highest, arm.tool().position.z() - z);
  }
  CHECK(highest < 0);
  // 0.2 s of 0.8 mm/s, and what is left of the 5 mm/s: it is taken back within 50 ms.
  const double down = before - arm.tool().position.z();
  CHECK(down > 0.2 * 0.8e-3);
  CHECK(down < 0.2 * 0.8e-3 + 0.05 * 4.2e-3);
  arm.check_limits();
}

TEST_CASE("velocity mode takes no memory") {
  for (const char* name : {"gantry", "ums7"}) {
    JogBench bench(name);
    const JogRates rates = jog_rates(Space::World, {0.05, 0, 0, 0, 0, 0.3});
    const NoAllocation guard;
    bench.mode.aim(rates);
    for (int i = 0; i < 100; ++i) bench.mode.step(1);
    for (int i = 0; i < 50; ++i) bench.mode.step(0);
    CHECK(guard.count() == 0);
  }
}
