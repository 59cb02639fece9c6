// How fast a jog moves the tool. Judged by the references alone, through homogeneous matrices that
// share nothing with Rob's kinematics.
#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <string>

#include <Eigen/Geometry>

#include "tests/motion/generate/jog_bench.h"
#include "tests/motion/kinematics/arms.h"
#include "tests/support/some_of.h"

namespace rob::test {

using namespace rob::motion;
using Space = JogRates::Space;

namespace {

using Eigen::Affine3d;
using Eigen::AngleAxisd;
using Eigen::Translation3d;
using Eigen::Vector3d;

/// S2: shoulder 0.5 m high, two links of 0.4 m, a hand of 0.1 m. At zero the first link is level,
/// the second upright; positive turns of axis 2 are downwards.
Affine3d ums7_flange(const JointVector& q) {
  const auto about_y = [](double angle) { return AngleAxisd(angle, Vector3d::UnitY()); };
  const auto about_z = [](double angle) { return AngleAxisd(angle, Vector3d::UnitZ()); };
  const auto up = [](double length) { return Translation3d(0, 0, length); };
  return up(0.5) * about_z(q[0]) * about_y(q[1]) * Translation3d(0.4, 0, 0) * about_y(q[2]) *
         up(0.4) * about_z(q[3]) * about_y(q[4]) * about_z(q[5]) * up(0.1);
}

Affine3d gantry_flange(const JointVector& q) {
  return Translation3d(q[0], q[1], 0) * AngleAxisd(q[2], Vector3d::UnitZ());
}

/// A frame as the published model of the SO-101 gives it: mm, and degrees about fixed axes x, y, z.
Affine3d frame(double x, double y, double z, double a, double b, double c) {
  return Translation3d(x / 1000, y / 1000, z / 1000) * AngleAxisd(c * kDegree, Vector3d::UnitZ()) *
         AngleAxisd(b * kDegree, Vector3d::UnitY()) * AngleAxisd(a * kDegree, Vector3d::UnitX());
}

Affine3d so101_flange(const JointVector& q) {
  const auto turned = [](double angle) { return AngleAxisd(angle, Vector3d::UnitZ()); };
  return frame(0, 0, 94.882, 180, 0, 180) * turned(q[0]) *
         frame(-30.399, -18.278, -54.2, -90, -90, 0) * turned(q[1]) *
         frame(-112.57, -28, 0, 0, 0, 90) * turned(q[2]) * frame(-134.9, 5.2, 0, 0, 0, -90) *
         turned(q[3]) * frame(0, -61.1, 18.1, 90, 0, 180) * turned(q[4]) *
         frame(-7.9, -0.218, -98.127, 180, 0, 0);
}

Affine3d flange(const std::string& robot, const JointVector& q) {
  if (robot == "gantry") return gantry_flange(q);
  if (robot == "ums7") return ums7_flange(q);
  if (robot == "so101") return so101_flange(q);
  for (const PublishedArm& arm : published_arms()) {
    if (arm.name == robot) return Affine3d(dh_forward(arm, q));
  }
  FAIL("no frames of " << robot);
  return Affine3d::Identity();
}

/// A jog, and how fast its tool has been in any period: m/s and rad/s between references.
class SpeedRun {
 public:
  SpeedRun(const std::string& name, const RobotModel& robot, const JogRates& rates)
      : name_(name), bench_(robot), rates_(rates) {
    REQUIRE((flange(name, robot.start).matrix() - matrix_of(bench_.tool())).norm() < 1e-9);
  }

  void stand_at(const JointVector& q) { bench_.mode.stand_at(q); }
  void ask(const JogRates& rates) { rates_ = rates; }
  void run(double seconds, double share = 1) {
    bench_.mode.aim(rates_);
    for (int i = 0; i * bench_.robot.reference_period < seconds; ++i) step(share);
  }
  void come_to_rest() {
    for (int i = 0; !bench_.mode.stands() && i < 10'000; ++i) step(0);
    REQUIRE(bench_.mode.stands());
  }
  void forget() { fastest = turning = 0, way_ = time_ = 0; }
  double mean() const { return way_ / time_; }
  JogBench& bench() { return bench_; }

  double fastest = 0;  ///< m/s
  double turning = 0;  ///< rad/s

 private:
  Affine3d tip() const {
    return flange(name_, bench_.q()) * Translation3d(rates_.tip.position) * rates_.tip.orientation;
  }
  void step(double share) {
    const double t = bench_.robot.reference_period;
    const Affine3d from = tip();
    bench_.step(share);
    const Affine3d to = tip();
    const double way = (to.translation() - from.translation()).norm();
    fastest = std::max(fastest, way / t);
    turning = std::max(turning, AngleAxisd(from.linear().transpose() * to.linear()).angle() / t);
    way_ += way;
    time_ += t;
  }

  std::string name_;
  JogBench bench_;
  JogRates rates_;
  double way_ = 0;
  double time_ = 0;
};

/// What differences of poses leave of a tool that does not move or turn, m/s or rad/s.
constexpr double kRest = 1e-5;
constexpr double kMost = 1.005;

JogRates along(Space space, int coordinate, double rate) {
  JogRates rates = jog_rates(space, {0, 0, 0, 0, 0, 0});
  rates.rate[coordinate] = rate;
  return rates;
}

RobotModel with_period(const std::string& name, double period) {
  RobotModel robot = embedded_robot(name);
  if (period > 0) robot.reference_period = period;
  return robot;
}

/// One in three in or beside a singular place.
JointVector random_posture(const RobotModel& robot, std::mt19937& random) {
  std::uniform_real_distribution<double> share(0, 1);
  JointVector q(robot.axis_count());
  for (int i = 0; i < q.size(); ++i) {
    const Axis& axis = robot.axes[static_cast<std::size_t>(i)];
    q[i] = axis.min + (0.1 + 0.8 * share(random)) * (axis.max - axis.min);
  }
  if (q.size() == 6 && share(random) < 0.3) q[4] = 0.05 * (share(random) - 0.5);
  return q;
}

/// The greatest |angular velocity| that rates of the fixed angles a, b, c can mean: where sin b
/// = 1.
double most_turning(const JogRates& rates) {
  const Vector3d turning = rates.rate.tail<3>();
  if (rates.space == Space::Tool) return turning.norm();
  const Vector3d apart = turning.cwiseAbs();
  return std::hypot(apart.x() + apart.z(), apart.y());
}

/// Without what rounding leaves of a leap, 1e-9 rad, which is more of j_max·T³ the shorter T is.
void check_forces(const JogBench& bench) {
  CHECK(bench.speed <= 1 + 2e-6);
  CHECK(bench.acceleration <= 1 + 2e-6);
  CHECK(bench.jerk <= 1 + 2e-6);
  CHECK(bench.out <= 2e-9);
}

}  // namespace

TEST_CASE("a jog of the LWA 4P upwards at 250 mm/s reaches 250 mm/s, and no more") {
  SpeedRun run("lwa4p", embedded_robot("lwa4p"), along(Space::World, 2, 0.25));
  run.run(0.6);
  CHECK(run.fastest <= kMost * 0.25);
  CHECK(run.fastest >= 0.99 * 0.25);
  run.come_to_rest();
  CHECK(run.fastest <= kMost * 0.25);
  run.bench().check_limits();
}

TEST_CASE("from its start every arm jogs as fast as it is asked to, and no faster") {
  for (const char* name : {"gantry", "ums7", "pc104", "puma560", "lwa4p", "irb120"}) {
    const bool plane = std::string(name) == "gantry";
    for (const Space space : {Space::World, Space::Tool}) {
      for (const int coordinate : {0, 1, 2, 5}) {
        if (plane && coordinate == 2) continue;
        for (const double sense : {-1.0, 1.0}) {
          const bool turns = coordinate == 5;
          const double speed = turns ? 0.3 : plane ? 0.015 : 0.1;
          CAPTURE(name);
          CAPTURE(static_cast<int>(space));
          CAPTURE(coordinate);
          CAPTURE(sense);
          RobotModel robot = embedded_robot(name);
          if (plane) robot.start << 0.2, 0.1, 0;
          SpeedRun run(name, robot, along(space, coordinate, sense * speed));
          run.run(0.7);
          const bool free = run.bench().mode.granted() == 1;
          run.forget();
          run.run(0.2);
          CHECK(run.fastest <= kMost * (turns ? 0 : speed) + kRest);
          CHECK(run.turning <= kMost * (turns ? speed : 0) + kRest);
          if (free && !turns) CHECK(run.mean() >= 0.97 * speed);
          run.bench().check_limits();
        }
      }
    }
  }
}

TEST_CASE("a jog that starts, turns back and stops keeps its tool's speed on every arm") {
  for (const char* name : some_of("ums7", "pc104", "puma560", "lwa4p", "irb120")) {
    for (const Space space : {Space::World, Space::Tool}) {
      for (const int coordinate : {0, 1, 2, 3, 5}) {
        for (const double speed : {-0.25, -0.1, -0.02, 0.02, 0.1, 0.25}) {
          CAPTURE(name);
          CAPTURE(static_cast<int>(space));
          CAPTURE(coordinate);
          CAPTURE(speed);
          const bool turns = coordinate >= 3;
          const double asked = std::abs(speed);
          SpeedRun run(name, embedded_robot(name), along(space, coordinate, speed));
          run.run(0.4);
          run.ask(along(space, coordinate, -speed));
          run.run(0.4);
          run.come_to_rest();
          CHECK(run.fastest <= kMost * (turns ? 0 : asked) + kRest);
          CHECK(run.turning <= kMost * (turns ? asked : 0) + kRest);
          CHECK(run.fastest + run.turning >= 0.2 * asked);
          check_forces(run.bench());
        }
      }
    }
  }
}

TEST_CASE("a jog of each axis that turns back keeps AT at the tool of every arm") {
  for (const char* name : some_of("ums7", "pc104", "puma560", "lwa4p", "irb120")) {
    for (int axis = 0; axis < 6; ++axis) {
      for (const double speed : {0.02, 0.1, 0.25}) {
        CAPTURE(name);
        CAPTURE(axis);
        CAPTURE(speed);
        JogRates rates = along(Space::Joint, axis, 1.0);
        rates.tool_speed = speed;
        SpeedRun run(name, embedded_robot(name), rates);
        run.run(0.4);
        rates.rate[axis] = -1;
        run.ask(rates);
        run.run(0.4);
        run.come_to_rest();
        CHECK(run.fastest <= kMost * speed + kRest);
        check_forces(run.bench());
      }
    }
  }
}

TEST_CASE("wherever an arm begins, in whatever direction and period, its tool keeps the speed") {
  std::mt19937 random(7);
  std::uniform_real_distribution<double> share(-1, 1);
  for (const char* name : some_of("ums7", "pc104", "puma560", "lwa4p", "irb120")) {
    for (const double period : {0.0, 0.001, 0.002, 0.008, 0.02}) {
      const RobotModel robot = with_period(name, period);
      for (int trial = 0; trial < (robot.reference_period < 0.004 ? 4 : 12); ++trial) {
        JogRates rates = along(trial % 2 == 0 ? Space::World : Space::Tool, 0, 0);
        const double size = std::pow(10, 1.5 * share(random) - 1.5);  // 1 mm/s … 1 m/s
        for (int i = 0; i < 6; ++i) rates.rate[i] = share(random) * size * (i < 3 ? 1 : 2);
        if (trial % 3 == 0) rates.rate.tail<3>().setZero();
        if (trial % 3 == 1) rates.tip.position = {0, 0.05, 0.1};
        CAPTURE(name);
        CAPTURE(period);
        CAPTURE(trial);
        SpeedRun run(name, robot, rates);
        run.stand_at(random_posture(robot, random));
        run.run(0.6);
        run.come_to_rest();
        CHECK(run.fastest <= kMost * rates.rate.head<3>().norm() + kRest);
        CHECK(run.turning <= kMost * most_turning(rates) + kRest);
        check_forces(run.bench());
      }
    }
  }
}

TEST_CASE("AT and an override bound the tool of a jog at every instant, that of the axes, too") {
  std::mt19937 random(9);
  std::uniform_real_distribution<double> share(-1, 1);
  for (const char* name : {"ums7", "puma560", "lwa4p", "irb120", "so101"}) {
    for (int trial = 0; trial < 12; ++trial) {
      const RobotModel robot = embedded_robot(name);
      JogRates rates = jog_rates(Space::Joint, {0, 0, 0, 0, 0, 0});
      for (double& rate : rates.rate) rate = share(random);
      rates.tool_speed = 0.05 + 0.1 * trial / 12;
      const double override = trial % 3 == 0 ? 0.5 : 1;
      CAPTURE(name);
      CAPTURE(trial);
      SpeedRun run(name, robot, rates);
      run.run(1.0, override);
      CHECK(run.fastest <= kMost * override * rates.tool_speed);
      const bool free = run.bench().mode.limit().kind == JogLimit::Kind::Share;
      run.forget();
      run.run(0.3, override);
      CHECK(run.fastest <= kMost * override * rates.tool_speed);
      if (free && run.bench().mode.limit().kind == JogLimit::Kind::Share)
        CHECK(run.mean() >= 0.97 * override * rates.tool_speed);
      run.bench().check_limits();
    }
  }
}

TEST_CASE("a jog that is asked to be slower slows down at once, without a last rise above both") {
  SpeedRun run("lwa4p", embedded_robot("lwa4p"), along(Space::World, 2, 0.25));
  run.run(0.12);  // it speeds up still
  const double before = run.fastest;
  run.ask(along(Space::World, 2, 0.5 * before));
  run.run(0.1);
  // It takes its acceleration back with all the jerk that jogs have: 40 ms of 2.8 m/s².
  CHECK(run.fastest < before + 0.06);
  run.run(0.3);
  run.forget();
  run.run(0.2);
  CHECK(run.fastest <= kMost * 0.5 * before);
  CHECK(run.mean() >= 0.97 * 0.5 * before);
  run.bench().check_limits();
}

}  // namespace rob::test
