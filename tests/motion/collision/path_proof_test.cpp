#include "motion/collision/path_proof.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <memory>

#include "base/split_mix.h"
#include "base/unit_factors.h"
#include "motion/kinematics/arm_kinematics.h"
#include "motion/kinematics/gantry_kinematics.h"

using namespace rob::motion;
using Eigen::Vector3d;
using rob::kDegree;
using rob::SplitMix;

namespace {

Pose level(const Vector3d& position) { return {position, Eigen::Quaterniond::Identity()}; }

/// An arm of the PUMA's size, whose links are beams of 50 mm.
std::shared_ptr<const ArmKinematics> arm() {
  ArmParameters measures;
  measures.c1 = 0.4;
  measures.c2 = 0.4;
  measures.c3 = 0.4;
  measures.c4 = 0.1;
  return std::make_shared<const ArmKinematics>(measures);
}

std::vector<Body> beams() {
  return {{"base", 0, {{{0, 0, 0}, {0, 0, 0.2}, 0.05}}},
          {"upper_arm", 2, {{{0, 0, 0}, {0, 0, 0.4}, 0.05}}},
          {"forearm", 3, {{{0, 0, 0}, {0, 0, 0.4}, 0.05}}},
          {"hand", 7, {{{0, 0, 0}, {0, 0, 0.1}, 0.03}, {{0, -0.05, 0.1}, {0, 0.05, 0.1}, 0.01}}}};
}

std::vector<Obstacle> things() {
  return {{"table", HalfSpace{-0.1}},
          {"post", Capsule{{0.6, 0.3, -0.1}, {0.6, 0.3, 1}, 0.05}},
          {"ball", Sphere{{-0.5, 0, 0.8}, 0.1}},
          {"crate", Box{{{0.4, -0.5, 0.1}, orientation_from({0.3, 0.2, 0.5})}, {0.2, 0.1, 0.15}}}};
}

double least_distance(const Clearance& clearance, const JointVector& q) {
  const LinkFrames frames = clearance.frames(q);
  double least = 1;
  for (const Clearance::Pair& pair : clearance.pairs())
    least = std::min(least, clearance.distance(pair, frames));
  return least;
}

JointVector random_joints(SplitMix& random, int axes) {
  JointVector q(axes);
  for (int i = 0; i < axes; ++i) q[i] = (2 * random.share() - 1) * 170 * kDegree;
  return q;
}

/// Where the straight way from `from` to `to` comes first into contact, as a share of it; 2: not at
/// all. Looks at 5000 places, of which two are less than 1 mm apart.
double first_contact(const Clearance& clearance, const JointVector& from, const JointVector& to) {
  constexpr int kPlaces = 5000;
  for (int i = 0; i <= kPlaces; ++i) {
    const double share = static_cast<double>(i) / kPlaces;
    if (least_distance(clearance, from + share * (to - from)) < PathProof::kContact) return share;
  }
  return 2;
}

}  // namespace

TEST_CASE("bodies that hang together are no pairs, nor are those that may touch") {
  const JointVector travel = JointVector::Zero(6);
  const Clearance clearance(
      arm(), travel, {.bodies = beams(), .obstacles = things(), .apart = {{"ball", "upper_arm"}}});
  std::vector<std::string> names;
  for (const Clearance::Pair& pair : clearance.pairs())
    names.push_back(clearance.name_of_body(pair) + " " + clearance.name_of_other(pair));
  CHECK(names == std::vector<std::string>{"base upper_arm", "base forearm", "base hand",
                                          "upper_arm hand", "upper_arm table", "upper_arm post",
                                          "upper_arm crate", "forearm hand", "forearm table",
                                          "forearm post", "forearm ball", "forearm crate",
                                          "hand table", "hand post", "hand ball", "hand crate"});
}

TEST_CASE("distances of an arm's bodies are those of its drawing") {
  const Clearance clearance(arm(), JointVector::Zero(6), {beams(), things(), {}});
  // The upper arm straight up, the forearm level, along x at a height of 0.8 m.
  JointVector q = JointVector::Zero(6);
  q[2] = 90 * kDegree;
  const LinkFrames frames = clearance.frames(q);
  CHECK(frames[2].position.isApprox(Vector3d(0, 0, 0.8), 1e-12));
  CHECK(frames[6].position.isApprox(Vector3d(0.5, 0, 0.8), 1e-12));
  CHECK(frames[6].position.isApprox(arm()->forward(q).position, 1e-12));
  for (const Clearance::Pair& pair : clearance.pairs()) {
    const std::string name = clearance.name_of_body(pair) + " " + clearance.name_of_other(pair);
    CAPTURE(name);
    const double distance = clearance.distance(pair, frames);
    if (name == "forearm table") CHECK(distance == doctest::Approx(0.9 - 0.05));
    if (name == "forearm ball") CHECK(distance == doctest::Approx(0.5 - 0.1 - 0.05));
    // The post stands 0.2 m ahead of the wrist and 0.3 m beside it.
    if (name == "forearm post")
      CHECK(distance == doctest::Approx(std::hypot(0.2, 0.3) - 0.05 - 0.05));
    if (name == "base forearm") CHECK(distance == doctest::Approx(0.6 - 0.05 - 0.05));
  }
}

TEST_CASE("a way is proved free exactly where a search along it finds no contact") {
  const auto kinematics = arm();
  const Clearance clearance(kinematics, JointVector::Zero(6), {beams(), things(), {}});
  PathProof proof(clearance, 0);
  SplitMix random(7);
  int hits = 0;
  int free = 0;
  while (hits < 40 || free < 40) {
    const JointVector from = random_joints(random, 6);
    if (least_distance(clearance, from) < PathProof::kContact) continue;
    const JointVector to = from + 0.4 * (random_joints(random, 6) - from);
    // References as a tick hands them out: of uneven ways.
    const int references = 20 + static_cast<int>(200 * random.share());
    proof.begin(from);
    double found = 2;
    for (int i = 1; i <= references && found > 1; ++i) {
      const double share = static_cast<double>(i) / references;
      if (proof.follow(from + share * (to - from))) found = share;
    }
    const double searched = first_contact(clearance, from, to);
    CAPTURE(from.transpose());
    CAPTURE(to.transpose());
    if (searched <= 1) {
      ++hits;
      CHECK(found <= 1);
      // Not before the contact by more than a reference, nor later.
      CHECK(found >= searched - 2e-4);
      CHECK(found <= searched + 1.0 / references + 2e-4);
    } else {
      ++free;
      CHECK(found == 2);
    }
  }
}

TEST_CASE("no thin thing lies between two references") {
  // 100 mm from reference to reference, past a wire of 2 mm and a tool of 2 mm: only where they
  // are nearer than 0.5 mm do they touch.
  const auto gantry = std::make_shared<const GantryKinematics>(3, GantryKinematics::Turn::None);
  const auto touches = [&](double beside) {
    const Clearance clearance(gantry, JointVector::Constant(3, 1),
                              {{{"tool", 4, {{{0, 0, 0}, {0, 0, 0}, 0.001}}}},
                               {{"wire", Capsule{{0.05, beside, -1}, {0.05, beside, 1}, 0.001}}}});
    PathProof proof(clearance, 0);
    proof.begin(JointVector{{0, 0, 0}});
    return proof.follow(JointVector{{0.1, 0, 0}}).has_value();
  };
  CHECK(touches(0));
  CHECK(touches(0.0024));
  CHECK_FALSE(touches(0.0026));
}

TEST_CASE("a contact at the beginning may be left, and not deepened") {
  const auto gantry = std::make_shared<const GantryKinematics>(3, GantryKinematics::Turn::None);
  const JointVector travel = JointVector::Constant(3, 1);
  const Clearance clearance(
      gantry, travel,
      {{{"tool", 3, {{{0, 0, 0}, {0, 0, 0.1}, 0.02}}}},
       {{"table", HalfSpace{0}}, {"wall", Box{level({1, 0, 0}), {0.1, 9, 9}}}}});
  PathProof proof(clearance, 0.01);
  proof.begin(JointVector{{0.5, 0, 0.01}});  // 10 mm in the table
  REQUIRE(proof.at_start().has_value());
  CHECK(proof.at_start()->distance == doctest::Approx(-0.01));
  CHECK_FALSE(proof.follow(JointVector{{0.6, 0, 0.01}}).has_value());
  CHECK_FALSE(proof.follow(JointVector{{0.6, 0, 0.015}}).has_value());
  CHECK_FALSE(proof.follow(JointVector{{0.6, 0, 0.030}}).has_value());
  CHECK(proof.follow(JointVector{{0.6, 0, 0.020}}).has_value());

  proof.begin(JointVector{{0.5, 0, 0.01}});
  CHECK(proof.follow(JointVector{{0.5, 0, 0.009}}).has_value());
}

TEST_CASE("the least distance of an obstacle is kept, if it is near") {
  const auto gantry = std::make_shared<const GantryKinematics>(3, GantryKinematics::Turn::None);
  const Clearance clearance(gantry, JointVector::Constant(3, 1),
                            {{{"tool", 4, {{{0, 0, 0}, {0, 0, 0.1}, 0.02}}}},
                             {{"table", HalfSpace{0}}, {"ball", Sphere{{0, 0, 0.5}, 0.1}}}});
  PathProof proof(clearance, 0.01);
  proof.begin(JointVector{{0.5, 0, 0.3}});
  for (int i = 1; i <= 100; ++i)
    CHECK_FALSE(proof.follow(JointVector{{0.5, 0, 0.3 - 0.0027 * i}}).has_value());
  REQUIRE(proof.nearest().has_value());
  CHECK(clearance.name_of_other(proof.nearest()->pair) == "table");
  CHECK(proof.nearest()->distance == doctest::Approx(0.03 - 0.02));
  proof.begin(JointVector{{0.5, 0, 0.3}});
  CHECK_FALSE(proof.follow(JointVector{{0.5, 0, 0.2}}).has_value());
  CHECK_FALSE(proof.nearest().has_value());
}

TEST_CASE("a proof that goes on says what one that begins anew says") {
  const auto kinematics = arm();
  const Clearance clearance(kinematics, JointVector::Zero(6), {beams(), things(), {}});
  PathProof goes_on(clearance, 0.05);
  SplitMix random(11);
  int hits = 0;
  int near = 0;
  JointVector at = random_joints(random, 6);
  for (int motion = 0; motion < 120; ++motion) {
    CAPTURE(motion);
    const JointVector to = random_joints(random, 6);
    PathProof fresh(clearance, 0.05);
    goes_on.begin(at);
    fresh.begin(at);
    CHECK(goes_on.at_start().has_value() == fresh.at_start().has_value());
    bool hit = false;
    for (int i = 1; i <= 20 && !hit; ++i) {
      const JointVector q = at + i / 20.0 * 0.2 * (to - at);
      const auto one = goes_on.follow(q);
      const auto other = fresh.follow(q);
      REQUIRE(one.has_value() == other.has_value());
      hit = one.has_value();
      if (hit) CHECK(one->distance == doctest::Approx(other->distance).epsilon(1e-6));
    }
    hits += hit ? 1 : 0;
    REQUIRE(goes_on.nearest().has_value() == fresh.nearest().has_value());
    near += goes_on.nearest() ? 1 : 0;
    at = hit ? random_joints(random, 6) : goes_on.last();
  }
  CHECK(hits > 5);
  CHECK(near > 5);
}
