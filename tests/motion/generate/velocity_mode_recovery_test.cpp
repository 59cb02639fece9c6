#include <doctest/doctest.h>

#include <memory>
#include <utility>

#include "motion/robots/robot_library.h"
#include "tests/motion/generate/jog_bench.h"

using namespace rob::motion;
using namespace rob::test;
using Space = JogRates::Space;

namespace {

/// Those of a robot, until they find no posture any more.
class LosingKinematics final : public Kinematics {
 public:
  explicit LosingKinematics(std::shared_ptr<const Kinematics> whole) : whole_(std::move(whole)) {}

  int axes() const noexcept override { return whole_->axes(); }
  Pose forward(const JointVector& q) const noexcept override { return whole_->forward(q); }
  InverseSolutions solutions(const Pose& pose, const JointVector& near) const noexcept override {
    return lost ? InverseSolutions() : whole_->solutions(pose, near);
  }
  double lever(int axis, const Eigen::Vector3d& tip) const noexcept override {
    return whole_->lever(axis, tip);
  }
  LinkFrames frames(const JointVector& q) const noexcept override { return whole_->frames(q); }
  const char* reach() const noexcept override { return whole_->reach(); }

  bool lost = false;

 private:
  std::shared_ptr<const Kinematics> whole_;
};

/// m that the tool gets away from q within 0.3 s at a rate along an axis of the world.
double way_from(const char* name, const JointVector& q, int axis, double rate) {
  JogBench bench(name, q);
  const Eigen::Vector3d from = bench.tool().position;
  JogRates rates = jog_rates(Space::World, {0, 0, 0, 0, 0, 0});
  rates.rate[axis] = rate;
  bench.run(rates, 0.3);
  bench.come_to_rest();
  bench.check_limits();
  return (bench.tool().position - from).norm();
}

}  // namespace

TEST_CASE("where no posture is found any more, each axis is braked by itself") {
  RobotModel robot = embedded_robot("gantry");
  const auto losing = std::make_shared<LosingKinematics>(robot.kinematics);
  robot.kinematics = losing;
  JogBench bench(robot);
  bench.run(jog_rates(Space::World, {0.015, 0.01, 0, 0, 0, 0.1}), 0.5);
  REQUIRE(bench.mode.reference().qd[0] == doctest::Approx(0.015).epsilon(1e-9));
  const double from = bench.q()[0];
  losing->lost = true;
  bench.step();
  CHECK(bench.mode.limit().kind == JogLimit::Kind::Reach);
  CHECK(!bench.mode.stands());
  CHECK(!bench.mode.takes(jog_rates(Space::World, {0.015, 0, 0, 0, 0, 0})));
  // 15 mm/s with 100 mm/s² and 1000 mm/s³ take v/a + a/j = 0.25 s, and half of 15 mm/s · 0.25 s.
  const int periods = 1 + bench.come_to_rest();
  CHECK(periods >= 25);
  CHECK(periods <= 28);
  CHECK(bench.q()[0] - from == doctest::Approx(0.015 * 0.25 / 2).epsilon(0.1));
  bench.check_limits();
}

TEST_CASE("from a singular wrist an arm goes every way that needs no leap of axis 4") {
  for (const auto& [arm, q] : {std::pair{"lwa4p", joints_deg({0, 30, 60, 0, 0, 5})},
                               {"puma560", joints_deg({0, 60, -30, 0, 0, 5})}}) {
    const char* const name = arm;
    CAPTURE(name);
    for (const double rate : {0.05, -0.05}) {
      // In the arm's plane the hand is kept upright by axis 5 alone, ...
      CHECK(way_from(name, q, 0, rate) > 0.01);
      CHECK(way_from(name, q, 2, rate) > 0.01);
      // ... across it by axis 4, a quarter of a turn away.
      CHECK(way_from(name, q, 1, rate) < 1e-9);
    }
    JogBench by_axes(name, q);
    by_axes.run(jog_rates(Space::Joint, {0, 0, 0, 0, 0.5, 0}), 0.5);
    CHECK(by_axes.q()[4] > 0.1);
    by_axes.check_limits();
  }
}

TEST_CASE("an arm that a jog has stretched, or led to the end of an axis, goes back at once") {
  for (const char* name : {"lwa4p", "puma560"}) {
    CAPTURE(name);
    JogBench stretched(name);
    stretched.run(jog_rates(Space::World, {0.3, 0, 0, 0, 0, 0}), 4);
    CHECK(stretched.mode.stands());
    CHECK(stretched.mode.stopped());
    const Eigen::Vector3d border = stretched.tool().position;
    stretched.run(jog_rates(Space::World, {-0.1, 0, 0, 0, 0, 0}), 1.5);
    stretched.come_to_rest();
    CHECK(border.x() - stretched.tool().position.x() > 0.01);
    stretched.check_limits();

    JogBench ended(name);
    const double most = ended.robot.axes[0].max;
    ended.run(jog_rates(Space::Joint, {1, 0, 0, 0, 0, 0}), 4);
    CHECK(ended.mode.stands());
    CHECK(ended.mode.limit().kind == JogLimit::Kind::End);
    CHECK(ended.q()[0] <= most + 1e-9);
    CHECK(ended.q()[0] > most - 0.01);
    ended.run(jog_rates(Space::Joint, {-1, 0, 0, 0, 0, 0}), 0.3);
    CHECK(ended.q()[0] < most - 0.1);
    ended.check_limits();
  }
}
