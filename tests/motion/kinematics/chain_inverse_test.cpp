#include <doctest/doctest.h>

#include <bit>
#include <cmath>
#include <numbers>
#include <random>

#include "motion/kinematics/chain_kinematics.h"
#include "motion/plan/reach.h"
#include "motion/robots/robot_library.h"
#include "tests/motion/kinematics/arms.h"
#include "tests/motion/kinematics/five_axes.h"
#include "tests/support/kdl_chain.h"
#include "tests/support/no_allocation.h"

using namespace rob::motion;
using namespace rob::test;

namespace {

constexpr double kHalfTurn = std::numbers::pi;

// Without full optimisation a search takes ten milliseconds.
#ifdef NDEBUG
constexpr int kPoses = 10'000;
#else
constexpr int kPoses = 300;
#endif

/// The chain of a table in the standard convention, with its limits.
JointChain chain_of(const std::vector<TableRow>& rows, const std::vector<double>& limits) {
  std::vector<ChainJoint> joints;
  Pose before;
  for (std::size_t i = 0; i < rows.size(); ++i) {
    joints.push_back({before, false, -limits[i], limits[i]});
    before = {{rows[i].a, 0, rows[i].d}, orientation_from({rows[i].alpha, 0, 0})};
  }
  return JointChain(joints, before);
}

ChainKinematics chain_kinematics(const JointChain& chain) {
  return ChainKinematics(chain, chain.size(), {0, 1, 2, 3, 4, 5});
}

/// The PUMA 560 as a chain, as a URDF would have it; limits as puma560's.
JointChain puma() {
  std::vector<double> limits;
  for (const double degrees : {160, 110, 135, 266, 100, 266}) limits.push_back(degrees * kDegree);
  return chain_of(puma_table(), limits);
}

const ChainKinematics& chain_of(const RobotModel& robot) {
  return dynamic_cast<const ChainKinematics&>(*robot.kinematics);
}

JointVector random_within(const JointChain& chain, std::mt19937& random) {
  JointVector q(chain.size());
  for (int i = 0; i < chain.size(); ++i)
    q[i] = std::uniform_real_distribution<double>(chain.joint(i).min, chain.joint(i).max)(random);
  return q;
}

JointVector middle_of(const JointChain& chain) {
  JointVector q(chain.size());
  for (int i = 0; i < chain.size(); ++i) q[i] = (chain.joint(i).min + chain.joint(i).max) / 2;
  return q;
}

/// Whether whole turns bring it within its limits.
bool turns_within(const JointChain& chain, const JointVector& q) {
  for (int i = 0; i < chain.size(); ++i) {
    const ChainJoint& joint = chain.joint(i);
    const double below = std::ceil((joint.min - 1e-9 - q[i]) / (2 * kHalfTurn));
    const double value = joint.linear ? q[i] : q[i] + 2 * kHalfTurn * below;
    if (value > joint.max + 1e-9 || value < joint.min - 1e-9) return false;
  }
  return true;
}

struct Found {
  int poses = 0;     ///< with a solution within the limits
  double worst = 0;  ///< m, rad: by KDL's forward kinematics
  int solutions = 0;
};

Found search_all(const ChainKinematics& kinematics, KdlChain oracle, int poses) {
  std::mt19937 random(7);
  Found found;
  const JointChain& chain = kinematics.chain();
  const JointVector near = middle_of(chain);
  for (int i = 0; i < poses; ++i) {
    const Pose pose = oracle.forward(random_within(chain, random));
    bool within = false;
    for (const JointVector& q : kinematics.solutions(pose, near)) {
      found.worst = std::max(found.worst, difference(oracle.forward(q), pose));
      within = within || turns_within(chain, q);
      ++found.solutions;
    }
    found.poses += within ? 1 : 0;
  }
  return found;
}

void check_forward(const ChainKinematics& kinematics, KdlChain oracle) {
  std::mt19937 random(3);
  for (int i = 0; i < 1000; ++i) {
    const JointVector q = random_within(kinematics.chain(), random);
    CHECK(difference(kinematics.forward(q), oracle.forward(q)) < 1e-9);
    JointChain::Jacobian jacobian;
    kinematics.chain().forward(q, jacobian);
    CHECK((jacobian.leftCols(q.size()) - oracle.jacobian(q)).cwiseAbs().maxCoeff() < 1e-9);
  }
}

}  // namespace

TEST_CASE("forward kinematics and Jacobian of chains are KDL's") {
  check_forward(chain_of(embedded_robot("ur5e")), KdlChain::standard(ur5e_table()));
  check_forward(chain_of(embedded_robot("ur10e")), KdlChain::standard(ur10e_table()));
  check_forward(chain_of(embedded_robot("fr3")), KdlChain::craig(fr3_table()));
  check_forward(chain_kinematics(puma()), KdlChain::standard(puma_table()));
}

TEST_CASE("nearly every reachable pose of a chain is found, and KDL confirms all solutions") {
  const RobotModel ur5e = embedded_robot("ur5e");
  const RobotModel ur10e = embedded_robot("ur10e");
  const RobotModel fr3 = embedded_robot("fr3");
  const ChainKinematics puma560 = chain_kinematics(puma());
  CHECK(chain_of(ur5e).closed());
  CHECK(chain_of(ur10e).closed());
  CHECK(puma560.closed());
  CHECK_FALSE(chain_of(fr3).closed());
  const auto check = [](const ChainKinematics& kinematics, const KdlChain& oracle) {
    const Found found = search_all(kinematics, oracle, kPoses);
    CHECK(found.poses >= 0.999 * kPoses);
    CHECK(found.worst < 1e-8);
    CHECK(found.solutions > 4 * kPoses);
  };
  check(chain_of(ur5e), KdlChain::standard(ur5e_table()));
  check(chain_of(ur10e), KdlChain::standard(ur10e_table()));
  check(puma560, KdlChain::standard(puma_table()));
  check(chain_of(fr3), KdlChain::craig(fr3_table()));
}

TEST_CASE("nearly every reachable pose of six axes in whatever places is found, KDL confirms it") {
  for (const unsigned number : {1U, 2U}) {
    std::mt19937 random(number);
    std::uniform_real_distribution<double> length(-0.3, 0.3);
    std::uniform_real_distribution<double> half(100, 170);
    std::normal_distribution<double> any;
    const auto place = [&] {
      const Eigen::Quaterniond turn(any(random), any(random), any(random), any(random));
      return Pose{{length(random), length(random), length(random)}, turn.normalized()};
    };
    std::vector<ChainJoint> joints;
    for (int i = 0; i < 6; ++i) {
      const double limit = half(random) * kDegree;
      joints.push_back({place(), false, -limit, limit});
    }
    const ChainKinematics kinematics = chain_kinematics(JointChain(joints, place()));
    CHECK_FALSE(kinematics.closed());
    const Found found = search_all(kinematics, KdlChain::of(kinematics.chain()), kPoses / 3);
    CHECK(found.poses >= 0.999 * (kPoses / 3));
    CHECK(found.worst < 1e-8);
  }
}

TEST_CASE("a PUMA as a chain has the solutions of the closed form of [arm]") {
  const ChainKinematics chain = chain_kinematics(puma());
  const auto closed = arm("puma560");
  std::mt19937 random(5);
  for (int i = 0; i < 300; ++i) {
    const JointVector q = random_within(chain.chain(), random);
    const Pose pose = chain.forward(q);
    const InverseSolutions found = chain.solutions(pose, q);
    const InverseSolutions wanted = closed->solutions(closed->forward(q), q);
    CHECK(found.count == wanted.count);
    bool own = false;
    for (const JointVector& other : found) own = own || (other - q).cwiseAbs().maxCoeff() < 1e-8;
    CHECK(own);
  }
}

TEST_CASE("a calibrated UR is solved on its exact chain, from the nominal closed form") {
  // Lengths off by tenths of a millimetre, angles by tenths of a milliradian.
  std::vector<TableRow> rows = ur5e_table();
  const std::vector<TableRow> off{{1e-4, 3e-4, 2e-4},  {-2e-4, 4e-4, 0},     {1e-4, -3e-4, 0},
                                  {2e-4, -2e-4, 1e-4}, {-1e-4, 1e-4, -2e-4}, {0, 0, 1e-4}};
  for (std::size_t i = 0; i < rows.size(); ++i) {
    rows[i].a += off[i].a;
    rows[i].alpha += off[i].alpha;
    rows[i].d += off[i].d;
  }
  const ChainKinematics kinematics =
      chain_kinematics(chain_of(rows, std::vector<double>(6, kHalfTurn)));
  CHECK(kinematics.closed());
  KdlChain oracle = KdlChain::standard(rows);
  const Found found = search_all(kinematics, oracle, kPoses / 10);
  CHECK(found.poses >= 0.999 * (kPoses / 10));
  CHECK(found.worst < 1e-8);
}

TEST_CASE("an arm with its wrist 5 mm off has no closed form, and is solved by search") {
  const RobotModel robot = embedded_robot("lwa4p_urdf");
  const ChainKinematics& kinematics = chain_of(robot);
  CHECK_FALSE(kinematics.closed());
  std::mt19937 random(11);
  int found = 0;
  constexpr int kTried = kPoses / 10;
  for (int i = 0; i < kTried; ++i) {
    const Pose pose = kinematics.forward(random_within(kinematics.chain(), random));
    const auto q = reach(robot, pose, robot.start);
    if (!q) continue;
    ++found;
    CHECK(difference(kinematics.forward(*q), pose) < 1e-8);
  }
  CHECK(found >= 0.998 * kTried);  // of some hundred one may be missed
}

TEST_CASE("going on along a path takes no memory and stays beside where it was") {
  for (const char* name : {"ur5e", "fr3", "lwa4p_urdf", "t3"}) {
    CAPTURE(name);
    const RobotModel robot = embedded_robot(name);
    const JointVector from = robot.start;
    JointVector to = from;
    for (int i = 0; i < to.size(); ++i)
      if (robot.axes[static_cast<std::size_t>(i)].kind == AxisKind::Rotary)
        to[i] += 0.01 * (i % 2 == 0 ? 1 : -1);
    const Pose pose = robot.kinematics->forward(to);
    std::optional<JointVector> q;
    {
      const NoAllocation guard;
      q = robot.kinematics->inverse(pose, from);
      static_cast<void>(robot.kinematics->solutions(pose, from));
      CHECK(guard.count() == 0);
    }
    REQUIRE(q.has_value());
    CHECK(difference(robot.kinematics->forward(*q), pose) < 1e-10);
    CHECK((*q - from).cwiseAbs().maxCoeff() < 0.05);
  }
}

TEST_CASE("of seven axes that which can best be spared keeps its value along a path") {
  const RobotModel robot = embedded_robot("fr3");
  const unsigned kept = chain_of(robot).kept();
  CHECK(std::popcount(kept) == 1);
  Pose pose = robot.kinematics->forward(robot.start);
  pose.position += Eigen::Vector3d(0.02, 0.03, -0.02);
  const auto q = robot.kinematics->inverse(pose, robot.start);
  REQUIRE(q.has_value());
  const int axis = std::countr_zero(kept);
  CHECK((*q)[axis] == robot.start[axis]);
  CHECK((*q - robot.start).norm() > 0.01);
}

TEST_CASE("the nearest pose to one out of reach is where the arm is stretched towards it") {
  const RobotModel robot = embedded_robot("ur5e");
  Pose far = robot.kinematics->forward(robot.start);
  far.position = Eigen::Vector3d(3, 0, 0.4);
  CHECK(robot.kinematics->solutions(far, robot.start).count == 0);
  const auto q = robot.kinematics->closest(far, robot.start);
  REQUIRE(q.has_value());
  const Pose there = robot.kinematics->forward(*q);
  // Its axes cannot reach farther than their lengths, and it goes most of that way.
  CHECK(there.position.norm() < 1.2);
  CHECK(there.position.x() > 0.8);
}

TEST_CASE("of several branches that is chosen which the axes reach first at full speed") {
  // Axes of the UR10e are not equally fast: 120 deg/s on 1 and 2, 180 deg/s on the others.
  const RobotModel robot = embedded_robot("ur10e");
  std::mt19937 random(17);
  int differs = 0;
  for (int i = 0; i < 300; ++i) {
    const JointVector q = random_within(chain_of(robot).chain(), random);
    const Pose pose = robot.kinematics->forward(q);
    const auto chosen = reach(robot, pose, robot.start);
    REQUIRE(chosen.has_value());
    const auto measure = [&](const JointVector& to, bool weighted) {
      double sum = 0;
      for (int k = 0; k < 6; ++k) {
        const double v = weighted ? robot.axes[static_cast<std::size_t>(k)].v_max : 1;
        sum += std::pow((to[k] - robot.start[k]) / v, 2);
      }
      return sum;
    };
    JointVector plain = *chosen;
    for (const JointVector& other : robot.kinematics->solutions(pose, robot.start)) {
      if (std::abs(other[2]) > kHalfTurn) continue;
      CHECK(measure(*chosen, true) <= measure(other, true) + 1e-9);
      if (measure(other, false) < measure(plain, false) - 1e-9) plain = other;
    }
    if ((plain - *chosen).norm() > 1e-6) ++differs;
  }
  CHECK(differs > 0);  // the weights matter
}

namespace {

/// rad by which a and b differ.
double leaning_between(const Pose& one, const Pose& other) {
  const FixedAngles a = fixed_angles(one.orientation);
  const FixedAngles b = fixed_angles(other.orientation);
  return std::hypot(std::remainder(a.a - b.a, 2 * kHalfTurn), a.b - b.b);
}

}  // namespace

TEST_CASE("five axes bring their tool to a place and two angles, and c is what the place makes") {
  const RobotModel robot = five_axes();
  const ChainKinematics& kinematics = chain_of(robot);
  std::mt19937 random(23);
  int found = 0;
  constexpr int kTried = kPoses / 10;
  for (int i = 0; i < kTried; ++i) {
    const Pose made = kinematics.forward(random_within(kinematics.chain(), random));
    // Any c will do.
    FixedAngles asked = fixed_angles(made.orientation);
    if (std::abs(asked.b) > 1.4) continue;  // a and b say little near ±90 deg
    asked.c = std::uniform_real_distribution<double>(-kHalfTurn, kHalfTurn)(random);
    const Pose pose{made.position, orientation_from(asked)};
    bool there = false;
    for (const JointVector& q : kinematics.solutions(pose, robot.start)) {
      const Pose is = kinematics.forward(q);
      CHECK((is.position - pose.position).norm() < 1e-8);
      CHECK(leaning_between(is, pose) < 1e-7);
      there = true;
    }
    CHECK(there);
    ++found;
  }
  CHECK(found > kTried / 2);
}

TEST_CASE("pointing straight down with c left out, axis 5 of five keeps its value") {
  const RobotModel robot = five_axes();
  JointVector q(5);
  q << 0.3, 0.2, 0.3, kHalfTurn / 2 - 0.5, 0.7;  // lift, elbow and wrist add up to a quarter
  const Pose down = robot.kinematics->forward(q);
  const Eigen::Vector3d z = down.orientation * Eigen::Vector3d::UnitZ();
  REQUIRE(z.z() < -0.999999);
  Pose beside = down;
  beside.position.x() += 0.004;
  const auto there = robot.kinematics->inverse(beside, q);
  REQUIRE(there.has_value());
  CHECK(std::abs((*there)[4] - q[4]) < 1e-6);
  CHECK((robot.kinematics->forward(*there).position - beside.position).norm() < 1e-9);
}

TEST_CASE("what the tool's own turn leaves free is not asked for") {
  const RobotModel robot = embedded_robot("ur5e");
  const ChainKinematics& kinematics = chain_of(robot);
  Pose pose = kinematics.forward(robot.start);
  pose.position += Eigen::Vector3d(0.02, -0.01, 0.03);
  pose.orientation = pose.orientation * Eigen::AngleAxisd(2.5, Eigen::Vector3d::UnitZ());
  JointVector q = robot.start;
  REQUIRE(ChainDescent(kinematics.chain()).leave(Freedom::Spin).run(pose, 40, q));
  const Pose is = kinematics.forward(q);
  CHECK((is.position - pose.position).norm() < 1e-9);
  const Eigen::Vector3d z = Eigen::Vector3d::UnitZ();
  CHECK((is.orientation * z - pose.orientation * z).norm() < 1e-9);
  // The axes move less than with the turn.
  JointVector whole = robot.start;
  REQUIRE(ChainDescent(kinematics.chain()).run(pose, 40, whole));
  CHECK((q - robot.start).norm() < (whole - robot.start).norm());
}
