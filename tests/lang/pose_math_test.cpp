#include "lang/values/pose_math.h"

#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>
#include <numbers>
#include <random>

#include <doctest/doctest.h>
#include <Eigen/Geometry>

#include "lang/values/pose_functions.h"
#include "lang/values/pose_slots.h"
#include "lang/values/units.h"

/// The oracle is Eigen's rotation matrices, which share no formula with the quaternions here.
namespace rob::lang {
namespace {

using namespace pose_math;

constexpr double kDeg = std::numbers::pi / 180;

double degrees(const char* number) {
  return to_si(*quantity_of(number, *find_unit("deg")), kAngle);
}

Eigen::Quaterniond eigen(const Quaternion& q) { return {q.w, q.i, q.j, q.k}; }
Eigen::Vector3d eigen(const Vector3& v) { return {v.x, v.y, v.z}; }
Eigen::Isometry3d eigen(const PoseValue& pose) {
  return Eigen::Translation3d(eigen(pose.position)) * eigen(pose.rotation);
}
Eigen::Matrix3d about(double angle, const Eigen::Vector3d& axis) {
  return Eigen::AngleAxisd(angle, axis).toRotationMatrix();
}

class RandomPoses {
 public:
  double between(double low, double high) {
    return low + (high - low) * std::uniform_real_distribution<double>()(generator_);
  }
  FixedAngles angles() { return {between(-3.1, 3.1), between(-1.57, 1.57), between(-3.1, 3.1)}; }
  Vector3 place() { return {between(-1, 1), between(-1, 1), between(-1, 1)}; }
  PoseValue pose() { return {place(), from_fixed(angles())}; }

 private:
  std::mt19937_64 generator_{20};
};

constexpr int kTries = 1000;
constexpr double kRounding = 1e-14;

double difference(const PoseValue& a, const Eigen::Isometry3d& b) {
  return (eigen(a).matrix() - b.matrix()).cwiseAbs().maxCoeff();
}

TEST_CASE("angles about fixed axes are the product of the three turns") {
  RandomPoses random;
  for (int i = 0; i < kTries; ++i) {
    const FixedAngles angles = random.angles();
    const Eigen::Matrix3d expected = about(angles.c, Eigen::Vector3d::UnitZ()) *
                                     about(angles.b, Eigen::Vector3d::UnitY()) *
                                     about(angles.a, Eigen::Vector3d::UnitX());
    const Eigen::Matrix3d made = eigen(from_fixed(angles)).toRotationMatrix();
    REQUIRE((made - expected).cwiseAbs().maxCoeff() < kRounding);
  }
}

TEST_CASE("ZYZ angles are the product of the three turns") {
  RandomPoses random;
  for (int i = 0; i < kTries; ++i) {
    const FixedAngles angles = random.angles();
    const Eigen::Matrix3d expected = about(angles.a, Eigen::Vector3d::UnitZ()) *
                                     about(angles.b, Eigen::Vector3d::UnitY()) *
                                     about(angles.c, Eigen::Vector3d::UnitZ());
    const Eigen::Matrix3d made = eigen(from_zyz(angles.a, angles.b, angles.c)).toRotationMatrix();
    REQUIRE((made - expected).cwiseAbs().maxCoeff() < kRounding);
  }
}

TEST_CASE("poses compose, invert and transform as their matrices do") {
  RandomPoses random;
  for (int i = 0; i < kTries; ++i) {
    const PoseValue p = random.pose();
    const PoseValue q = random.pose();
    const Vector3 v = random.place();
    REQUIRE(difference(compose(p, q), eigen(p) * eigen(q)) < kRounding);
    REQUIRE(difference(inverse(p), eigen(p).inverse()) < kRounding);
    REQUIRE((eigen(transform(p, v)) - eigen(p) * eigen(v)).norm() < kRounding);
  }
}

TEST_CASE("the product that the Vm computes is compose(), to the bit") {
  RandomPoses random;
  const auto bits = [](const PoseValue& pose) {
    return std::bit_cast<std::array<std::uint64_t, kPoseSlots>>(pose);
  };
  const auto checked = [&](const PoseValue& p, const PoseValue& q) {
    // The way of this processor, and that of all.
    for (const auto product : {pose_functions::product, pose_functions::product_in_pairs}) {
      std::array<Slot, 2 * kPoseSlots> slots{};
      store(p, slots.data());
      store(q, &slots[kPoseSlots]);
      // Into its own first operand, as p = p * q does.
      REQUIRE(product(slots.data(), &slots[kPoseSlots], slots.data()) == ArithmeticError::None);
      REQUIRE(bits(load_pose(slots.data())) == bits(compose(p, q)));
    }
  };
  const PoseValue none;
  const PoseValue quarter{{0, 0.5, 0}, from_fixed({0, 0, degrees("90")})};
  checked(none, none);
  checked(quarter, quarter);
  checked(quarter, {{-0.5, 0, 0}, from_fixed({degrees("180"), 0, 0})});
  for (int i = 0; i < kTries; ++i) checked(random.pose(), random.pose());
}

TEST_CASE("a product whose place is too large for a number is an error") {
  for (const auto product : {pose_functions::product, pose_functions::product_in_pairs}) {
    for (const Vector3& far : {Vector3{1.5e308, 0, 0}, {0, 1.5e308, 0}, {0, 0, 1.5e308}}) {
      const PoseValue moved{far, {}};
      std::array<Slot, 2 * kPoseSlots> slots{};
      store(moved, slots.data());
      store(moved, &slots[kPoseSlots]);
      CHECK(product(slots.data(), &slots[kPoseSlots], slots.data()) == ArithmeticError::NotFinite);
      CHECK(load_pose(slots.data()).position.x == far.x);  // as it was
    }
    // The sum of the coordinates alone may overflow.
    std::array<Slot, 2 * kPoseSlots> slots{};
    store(PoseValue{{1.5e308, 1.5e308, 1.5e308}, {}}, slots.data());
    store(PoseValue{}, &slots[kPoseSlots]);
    CHECK(product(slots.data(), &slots[kPoseSlots], slots.data()) == ArithmeticError::None);
  }
}

TEST_CASE("angles written to 1e-12 degrees come back to the bit") {
  for (const char* text : {"30", "0.1", "-179.999", "45.123456789012", "180", "90", "1e-12"}) {
    const double angle = degrees(text);
    CHECK(to_fixed(from_fixed({.c = angle})).c == angle);
    CHECK(to_fixed(from_fixed({.a = angle})).a == angle);
  }
  const FixedAngles angles{degrees("12.5"), degrees("-33.3"), degrees("170")};
  const FixedAngles back = to_fixed(from_fixed(angles));
  CHECK(back.a == angles.a);
  CHECK(back.b == angles.b);
  CHECK(back.c == angles.c);
}

TEST_CASE("the angles of any rotation make the same rotation") {
  RandomPoses random;
  for (int i = 0; i < kTries; ++i) {
    const Quaternion q = compose(random.pose(), random.pose()).rotation;
    const Quaternion again = from_fixed(to_fixed(q));
    REQUIRE(turn({{}, q}, {{}, again}) < 1e-11 * kDeg);
  }
}

TEST_CASE("where b is 90 degrees a is 0 and c holds the rest") {
  for (const double b : {degrees("90"), degrees("-90")}) {
    const FixedAngles angles =
        to_fixed(from_fixed({.a = degrees("20"), .b = b, .c = degrees("50")}));
    CHECK(angles.a == 0);
    CHECK(angles.b == b);
    // R = Rz(c)·Ry(90°)·Rx(a) = Rz(c - a)·Ry(90°), and Rz(c + a)·Ry(-90°).
    CHECK(angles.c == (b > 0 ? degrees("30") : degrees("70")));
  }
}

TEST_CASE("a half turn is 180 degrees, never -180") {
  CHECK(to_fixed(from_fixed({.c = degrees("-180")})).c == degrees("180"));
  CHECK(to_fixed(from_fixed({.a = degrees("540")})).a == degrees("180"));
  CHECK(to_fixed({0, 0, 0, -1}).c == degrees("180"));
}

TEST_CASE("quarter turns leave no rounding, however often they are composed") {
  const Quaternion about_z = from_fixed({.c = degrees("90")});
  const Vector3 turned = rotate(about_z, {0.01, 0.02, 0.03});
  CHECK(turned.x == -0.02);
  CHECK(turned.y == 0.01);
  CHECK(turned.z == 0.03);
  const PoseValue step{{0.01, 0, 0}, from_fixed({.a = degrees("90"), .c = degrees("-90")})};
  PoseValue pose;
  for (int i = 0; i < 3000; ++i) pose = compose(pose, step);
  // The axis of this rotation is a diagonal of the cube, so three of them are none.
  const Vector3 x = rotate(pose.rotation, {1, 0, 0});
  CHECK(x.x == 1);
  CHECK(x.y == 0);
  CHECK(x.z == 0);
}

TEST_CASE("a long chain of products stays a rotation") {
  PoseValue pose;
  const PoseValue step{{}, from_fixed({.a = 0.3, .b = 0.2, .c = 0.1})};
  for (int i = 0; i < 1'000'000; ++i) pose = compose(pose, step);
  CHECK(std::fabs(eigen(pose.rotation).norm() - 1) < 1e-15);
}

TEST_CASE("a quaternion of any length is brought to length 1, zero is none") {
  for (const double s : {1.0, 1e-200, 1e200, 5e-324}) {
    const auto q = normalized({s, 0, 0, s});
    REQUIRE(q.has_value());
    CHECK(std::fabs(q->w - std::sqrt(0.5)) < kRounding);
    CHECK(q->w == q->k);
  }
  CHECK_FALSE(normalized({0, 0, 0, 0}).has_value());
}

TEST_CASE("TURN is the angle of the shortest rotation") {
  const PoseValue p{{}, from_fixed({.c = degrees("170")})};
  const PoseValue q{{}, from_fixed({.c = degrees("-170")})};
  CHECK(turn(p, q) == degrees("20"));
  CHECK(turn(p, p) == 0);
  CHECK(turn({}, {{}, {0, 1, 0, 0}}) == degrees("180"));
  RandomPoses random;
  for (int i = 0; i < kTries; ++i) {
    const PoseValue a = random.pose();
    const PoseValue b = random.pose();
    const double expected = eigen(a.rotation).angularDistance(eigen(b.rotation));
    REQUIRE(std::fabs(turn(a, b) - expected) < 1e-13);
    REQUIRE(std::fabs(turn(a, b) - turn(b, a)) < 1e-13);
  }
}

TEST_CASE("MIX goes straight and turns the shortest way") {
  const PoseValue p{{0, 0, 0}, from_fixed({.c = degrees("170")})};
  const PoseValue q{{0.1, 0.2, 0.4}, from_fixed({.c = degrees("-150")})};
  const auto half = mix(p, q, 0.5);
  REQUIRE(half.has_value());
  CHECK(half->position.x == 0.05);
  CHECK(to_fixed(half->rotation).c == degrees("-170"));
  CHECK(to_fixed(mix(p, q, 0)->rotation).c == degrees("170"));
  CHECK(mix(p, q, 1)->position.z == 0.4);
  CHECK(to_fixed(mix(p, q, 1)->rotation).c == degrees("-150"));
  CHECK(to_fixed(mix(p, q, 1.5)->rotation).c == degrees("-130"));
  RandomPoses random;
  for (int i = 0; i < kTries; ++i) {
    const PoseValue a = random.pose();
    const PoseValue b = random.pose();
    const double t = random.between(0, 1);
    const auto mixed = mix(a, b, t);
    REQUIRE(mixed.has_value());
    const Eigen::Quaterniond expected = eigen(a.rotation).slerp(t, eigen(b.rotation));
    REQUIRE(eigen(mixed->rotation).angularDistance(expected) < 1e-7);
  }
}

TEST_CASE("poses that are 180 degrees apart have no mixture") {
  CHECK_FALSE(mix({}, {{}, from_fixed({.b = degrees("180")})}, 0.5).has_value());
  CHECK(mix({}, {{}, from_fixed({.b = degrees("179.9999")})}, 0.5).has_value());
}

TEST_CASE("three places make a frame") {
  const auto frame = frame_through({0.1, 0, 0}, {0.1, 0.5, 0}, {0, 0.2, 0});
  REQUIRE(frame.has_value());
  const FixedAngles angles = to_fixed(frame->rotation);
  CHECK(angles.a == 0);
  CHECK(angles.b == 0);
  CHECK(angles.c == degrees("90"));
  RandomPoses random;
  for (int i = 0; i < kTries; ++i) {
    const PoseValue p = random.pose();
    const Vector3 on_x = transform(p, {random.between(0.1, 1), 0, 0});
    const Vector3 on_xy = transform(p, {random.between(-1, 1), random.between(0.1, 1), 0});
    const auto found = frame_through(p.position, on_x, on_xy);
    REQUIRE(found.has_value());
    REQUIRE(difference(*found, eigen(p)) < 1e-13);
  }
}

TEST_CASE("places on a line make no frame") {
  CHECK_FALSE(frame_through({}, {1, 0, 0}, {2, 0, 0}).has_value());
  CHECK_FALSE(frame_through({}, {1, 0, 0}, {-2, 1e-10, 0}).has_value());
  CHECK_FALSE(frame_through({}, {0, 0, 0}, {0, 1, 0}).has_value());
  CHECK_FALSE(frame_through({}, {1, 0, 0}, {0, 0, 0}).has_value());
}

TEST_CASE("what is no number any more is noticed") {
  constexpr double kInfinity = std::numeric_limits<double>::infinity();
  CHECK(is_finite({{1e308, 1e308, 0}, {}}));
  CHECK_FALSE(is_finite({{kInfinity, -kInfinity, 0}, {}}));
  CHECK_FALSE(is_finite(compose({{1e308, 0, 0}, {}}, {{1e308, 0, 0}, {}})));
}

}  // namespace
}  // namespace rob::lang
