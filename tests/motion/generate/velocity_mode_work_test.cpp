#include <doctest/doctest.h>

#include <algorithm>
#include <memory>
#include <random>
#include <utility>

#include "motion/robots/robot_library.h"
#include "tests/motion/generate/jog_bench.h"

using namespace rob::motion;
using namespace rob::test;
using Space = JogRates::Space;

namespace {

/// Those of an arm, counting how often a posture is asked for.
class CountingKinematics final : public Kinematics {
 public:
  explicit CountingKinematics(std::shared_ptr<const Kinematics> whole) : whole_(std::move(whole)) {}

  int axes() const noexcept override { return whole_->axes(); }
  Pose forward(const JointVector& q) const noexcept override { return whole_->forward(q); }
  InverseSolutions solutions(const Pose& pose, const JointVector& near) const noexcept override {
    return whole_->solutions(pose, near);
  }
  std::optional<JointVector> inverse(const Pose& pose,
                                     const JointVector& near) const noexcept override {
    ++count;
    return whole_->inverse(pose, near);
  }
  double lever(int axis, const Eigen::Vector3d& tip) const noexcept override {
    return whole_->lever(axis, tip);
  }
  double stretch(const JointVector& q) const noexcept override { return whole_->stretch(q); }
  LinkFrames frames(const JointVector& q) const noexcept override { return whole_->frames(q); }
  const char* reach() const noexcept override { return whole_->reach(); }

  mutable int count = 0;

 private:
  std::shared_ptr<const Kinematics> whole_;
};

struct Work {
  int most = 0;    ///< postures in a period
  double way = 0;  ///< m or rad: of the axes, all together
};

/// Random jogs of the tool, into whatever stands in its way.
Work jog_about(JogBench& bench, const CountingKinematics& counting, double seconds) {
  std::mt19937 random(3);
  std::uniform_real_distribution<double> share(-1, 1);
  Work work;
  for (double t = 0; t < seconds; t += 0.5) {
    JogRates rates = jog_rates(Space::World, {0, 0, 0, 0, 0, 0});
    for (int i = 0; i < 6; ++i) rates.rate[i] = share(random) * (i < 3 ? 0.3 : 1);
    bench.mode.aim(rates);
    for (int i = 0; i * bench.robot.reference_period < 0.5; ++i) {
      const JointVector before = bench.q();
      counting.count = 0;
      bench.step();
      work.most = std::max(work.most, counting.count);
      work.way += (bench.q() - before).norm();
    }
  }
  return work;
}

}  // namespace

TEST_CASE("the work of a period is bounded, and at 1 kHz an arm jogs as far as at 250 Hz") {
  double way = 0;
  for (const double period : {0.004, 0.001}) {
    CAPTURE(period);
    RobotModel robot = embedded_robot("puma560");
    robot.reference_period = period;
    const auto counting = std::make_shared<const CountingKinematics>(robot.kinematics);
    robot.kinematics = counting;
    JogBench bench(robot);
    const Work work = jog_about(bench, *counting, 1);
    // 3 postures a step: 120 of rests, 3 tried and 2 along a rest; 2 for what rates make of axes.
    CHECK(work.most <= 3 * (120 + 3 + 2) + 2);
    CHECK(work.most > 100);
    CHECK(bench.speed <= 1 + 2e-6);
    CHECK(bench.acceleration <= 1 + 2e-6);
    CHECK(bench.jerk <= 1 + 2e-6);
    CHECK(bench.out <= 2e-9);
    CHECK(work.way > 0.7 * way);
    way = work.way;
  }
}
