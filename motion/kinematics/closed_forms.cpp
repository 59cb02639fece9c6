#include "motion/kinematics/closed_forms.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <vector>

namespace rob::motion {

namespace {

using Line = JointChain::Line;

constexpr double kTwoPi = 2 * std::numbers::pi;

/// Across each other, or along each other, as far as the tolerance goes.
bool across(const Line& a, const Line& b) {
  return std::abs(a.direction.dot(b.direction)) <= StructureTolerance::kAngle;
}
bool parallel(const Line& a, const Line& b) {
  return a.direction.cross(b.direction).norm() <= StructureTolerance::kAngle;
}

struct Meeting {
  Eigen::Vector3d point;  ///< the middle of the shortest way between them
  double apart = 0;       ///< its length, m
};

/// For two lines that are not parallel.
Meeting meeting(const Line& a, const Line& b) {
  const Eigen::Vector3d way = b.point - a.point;
  const double cosine = a.direction.dot(b.direction);
  const double along =
      (way.dot(a.direction) - cosine * way.dot(b.direction)) / (1 - cosine * cosine);
  const Eigen::Vector3d on_a = a.point + along * a.direction;
  const Eigen::Vector3d on_b = b.point + (on_a - b.point).dot(b.direction) * b.direction;
  return {(on_a + on_b) / 2, (on_a - on_b).norm()};
}

double distance(const Eigen::Vector3d& point, const Line& line) {
  return (point - line.point).cross(line.direction).norm();
}

/// z along axis 1, y along axis 2, the origin on axis 1 at the height of axis 2.
Pose base_of(const std::vector<Line>& lines) {
  const Eigen::Vector3d z = lines[0].direction;
  const Eigen::Vector3d y = (lines[1].direction - lines[1].direction.dot(z) * z).normalized();
  Eigen::Matrix3d axes;
  axes << y.cross(z), y, z;
  const double up = (lines[1].point - lines[0].point).dot(z);
  return {lines[0].point + up * z, Eigen::Quaterniond(axes)};
}

Line seen_from(const Pose& base, const Line& line) {
  const Pose back = inverse(base);
  return {place_of(line.point, back), back.orientation * line.direction};
}

/// From z towards x, as a turn about y goes.
double lean(double x, double z) { return std::atan2(x, z); }

bool six_rotary(const JointChain& chain) {
  if (chain.size() != 6) return false;
  for (int i = 0; i < 6; ++i)
    if (chain.joint(i).linear) return false;
  return true;
}

/// The lines at zero, seen from base_of them.
std::vector<Line> structure(const JointChain& chain, Pose& base) {
  std::vector<Line> lines = chain.lines(JointVector::Zero(6));
  base = base_of(lines);
  for (Line& line : lines) line = seen_from(base, line);
  return lines;
}

double near_by_turns(double value, double near) {
  return near + std::remainder(value - near, kTwoPi);
}

}  // namespace

std::optional<WristForm> WristForm::of(const JointChain& chain) {
  if (!six_rotary(chain)) return std::nullopt;
  Pose base;
  const std::vector<Line> lines = structure(chain, base);
  if (!across(lines[0], lines[1]) || !parallel(lines[1], lines[2]) || !across(lines[2], lines[3]) ||
      !across(lines[3], lines[4]) || !across(lines[4], lines[5]))
    return std::nullopt;
  const Eigen::Vector3d wrist = meeting(lines[3], lines[4]).point;
  for (std::size_t i = 3; i < 6; ++i)
    if (distance(wrist, lines[i]) > StructureTolerance::kDistance) return std::nullopt;

  ArmParameters arm;
  arm.a1 = lines[1].point.x();
  arm.b = wrist.y();
  const Eigen::Vector3d upper = lines[2].point - lines[1].point;
  arm.c2 = std::hypot(upper.x(), upper.z());
  arm.offset[1] = lean(upper.x(), upper.z());
  arm.sign[2] = lines[2].direction.y() < 0 ? -1 : 1;
  // Axis 4 points out along the forearm, or back.
  Eigen::Vector3d along = lines[3].direction;
  const Eigen::Vector3d fore = wrist - lines[2].point;
  if (fore.dot(along) < 0) along = -along;
  arm.sign[3] = along.dot(lines[3].direction) < 0 ? -1 : 1;
  const double leaning = lean(along.x(), along.z());
  arm.offset[2] = leaning - arm.offset[1];
  const Eigen::AngleAxisd on_forearm(leaning, Eigen::Vector3d::UnitY());
  const Eigen::Vector3d seen = on_forearm.inverse() * fore;
  arm.a2 = seen.x();
  arm.c3 = seen.z();
  if (arm.c2 < StructureTolerance::kDistance ||
      std::hypot(arm.a2, arm.c3) < StructureTolerance::kDistance)
    return std::nullopt;
  const Eigen::Vector3d fifth = on_forearm.inverse() * lines[4].direction;
  arm.offset[3] = std::atan2(-fifth.x(), fifth.y());
  const Eigen::Vector3d sixth = Eigen::AngleAxisd(-arm.offset[3], Eigen::Vector3d::UnitZ()) *
                                (on_forearm.inverse() * lines[5].direction);
  arm.offset[4] = lean(sixth.x(), sixth.z());
  const JointVector zero = JointVector::Zero(6);
  const Pose nominal = composed(base, ArmKinematics(arm).forward(zero));
  return WristForm(arm, base, composed(inverse(nominal), chain.forward(zero)));
}

InverseSolutions WristForm::solutions(const Pose& pose, const JointVector& near) const noexcept {
  return arm_.solutions(composed(composed(inverse(base_), pose), inverse(flange_)), near);
}

std::optional<ParallelForm> ParallelForm::of(const JointChain& chain) {
  if (!six_rotary(chain)) return std::nullopt;
  ParallelForm form;
  const std::vector<Line> lines = structure(chain, form.base_);
  if (!across(lines[0], lines[1]) || !parallel(lines[1], lines[2]) ||
      !parallel(lines[1], lines[3]) || !across(lines[3], lines[4]) || !across(lines[4], lines[5]))
    return std::nullopt;
  const Meeting hand = meeting(lines[4], lines[5]);
  if (hand.apart > StructureTolerance::kDistance) return std::nullopt;
  form.a1_ = lines[1].point.x();
  form.b_ = hand.point.y();
  const Eigen::Vector3d upper = lines[2].point - lines[1].point;
  const Eigen::Vector3d fore = lines[3].point - lines[2].point;
  form.upper_ = std::hypot(upper.x(), upper.z());
  form.fore_ = std::hypot(fore.x(), fore.z());
  if (std::min(form.upper_, form.fore_) < StructureTolerance::kDistance) return std::nullopt;
  form.upper_lean_ = lean(upper.x(), upper.z());
  form.fore_lean_ = lean(fore.x(), fore.z());
  form.sign3_ = lines[2].direction.y() < 0 ? -1 : 1;
  form.sign4_ = lines[3].direction.y() < 0 ? -1 : 1;
  const Eigen::Vector3d& fifth = lines[4].direction;
  const Eigen::Vector3d& sixth = lines[5].direction;
  form.hand_lean_ = lean(fifth.x(), fifth.z());
  const Eigen::Vector3d y = Eigen::Vector3d::UnitY();
  form.tilt_ = std::atan2(sixth.dot(fifth.cross(y)), sixth.dot(y));
  form.offset_ << hand.point.x() - lines[3].point.x(), hand.point.z() - lines[3].point.z();
  const Eigen::Vector3d across_sixth = (fifth - fifth.dot(sixth) * sixth).normalized();
  Eigen::Matrix3d axes;
  axes << across_sixth.cross(sixth), across_sixth, sixth;
  const Pose last = composed(form.base_, {hand.point, Eigen::Quaterniond(axes)});
  form.flange_ = composed(inverse(last), chain.forward(JointVector::Zero(6)));
  return form;
}

/// One way to turn the base and the hand.
struct ParallelForm::Turned {
  double q1, q5, q6;
  double lean;             ///< of axis 5
  Eigen::Vector2d fourth;  ///< axis 4, from axis 2: x, z
};

InverseSolutions ParallelForm::solutions(const Pose& pose, const JointVector& near) const noexcept {
  InverseSolutions found;
  const Pose hand = composed(composed(inverse(base_), pose), inverse(flange_));
  if (!hand.position.allFinite() || !hand.orientation.coeffs().allFinite()) return found;
  const double radius = std::hypot(hand.position.x(), hand.position.y());
  // The tolerance of the structure: what is just beyond reach may be in reach of the exact chain.
  if (radius < std::abs(b_) - StructureTolerance::kDistance) return found;
  const double ahead = std::sqrt(std::max(0.0, (radius - b_) * (radius + b_)));
  const Eigen::Matrix3d turn_of = hand.orientation.toRotationMatrix();
  for (const double side : {ahead, -ahead}) {
    const double theta1 = std::atan2(hand.position.y(), hand.position.x()) - std::atan2(b_, side);
    turn(turn_of, {side, b_, hand.position.z()}, theta1, near, found);
  }
  return found;
}

/// `wrist`: seen from the turned base. Both ways to turn the hand.
void ParallelForm::turn(const Eigen::Matrix3d& hand, const Eigen::Vector3d& wrist, double theta1,
                        const JointVector& near, InverseSolutions& found) const noexcept {
  constexpr double kInLine = 1e-10;  // sine: axes 4 and 6 are parallel, and axis 6 keeps its value
  const Eigen::Matrix3d r =
      Eigen::AngleAxisd(-theta1, Eigen::Vector3d::UnitZ()).toRotationMatrix() * hand;
  const double sine = std::hypot(r(1, 0), r(1, 1));
  for (const double side : {1.0, -1.0}) {
    Turned turned{};
    turned.q1 = theta1;
    turned.q5 = std::atan2(side * sine, r(1, 2)) - tilt_;
    turned.q6 = sine < kInLine ? near[5] : std::atan2(side * r(1, 1), -side * r(1, 0));
    const Eigen::Vector3d fifth = r * Eigen::Vector3d(std::sin(turned.q6), std::cos(turned.q6), 0);
    turned.lean = lean(fifth.x(), fifth.z());
    const double turn = turned.lean - hand_lean_;
    const double c = std::cos(turn);
    const double s = std::sin(turn);
    turned.fourth << wrist.x() - (c * offset_.x() + s * offset_.y()) - a1_,
        wrist.z() - (c * offset_.y() - s * offset_.x());
    bend(turned, near, found);
  }
}

/// Both ways to bend the elbow.
void ParallelForm::bend(const Turned& turned, const JointVector& near,
                        InverseSolutions& found) const noexcept {
  const double s = turned.fourth.norm();
  const double far = upper_ + fore_;
  const double close = std::abs(upper_ - fore_);
  if (s > far + StructureTolerance::kDistance || s < close - StructureTolerance::kDistance) return;
  const double outer = std::sqrt(std::max(0.0, (far - s) * (far + s)));
  const double inner = std::sqrt(std::max(0.0, (s - close) * (s + close)));
  const double line = lean(turned.fourth.x(), turned.fourth.y());
  for (const double side : {1.0, -1.0}) {
    const double bent = side * 2 * std::atan2(outer, inner);
    const double lead = std::atan2(fore_ * std::sin(bent), upper_ + fore_ * std::cos(bent));
    const double second = line - lead - upper_lean_;
    const double third = sign3_ * (line - lead + bent - fore_lean_ - second);
    const double fourth = sign4_ * (turned.lean - hand_lean_ - second - sign3_ * third);
    const std::array<double, 6> values{turned.q1, second, third, fourth, turned.q5, turned.q6};
    JointVector& q = found.q[static_cast<std::size_t>(found.count++)];
    q = near;
    for (int i = 0; i < 6; ++i) q[i] = near_by_turns(values[static_cast<std::size_t>(i)], near[i]);
  }
}

}  // namespace rob::motion
