#include "motion/kinematics/arm_kinematics.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <stdexcept>
#include <utility>
#include <vector>

#include <Eigen/Geometry>

#include "motion/kinematics/chain_descent.h"

namespace rob::motion {

namespace {

constexpr double kPi = std::numbers::pi;

/// m: the wrist is on an axis, or as good as in reach. [choice] far above rounding (1e-15 m), far
/// below what any arm repeats.
constexpr double kOnAxis = 1e-9;
// m. Where an angle keeps its value for want of a better one the tool is off by twice the distance
// from the axis at most, which shall stay below 1e-9.
constexpr double kKept = 4e-10;
/// sin θ5: axes 4 and 6 are in line. [choice] below it θ4 would be made of rounding.
constexpr double kInLine = 1e-10;

Eigen::Quaterniond about_z(double angle) {
  return {std::cos(angle / 2), 0, 0, std::sin(angle / 2)};
}

Eigen::Quaterniond about_y(double angle) {
  return {std::cos(angle / 2), 0, std::sin(angle / 2), 0};
}

/// √(u² − v²) for u, v ≥ 0, without the cancellation; 0 where it is not real.
double other_side(double u, double v) { return std::sqrt(std::max(0.0, (u - v) * (u + v))); }

/// How the forearm is turned: Rz(θ1)·Ry(θ2 + θ3).
Eigen::Matrix3d forearm(const Eigen::Matrix<double, 6, 1>& theta) {
  const double s1 = std::sin(theta[0]);
  const double c1 = std::cos(theta[0]);
  const double s = std::sin(theta[1] + theta[2]);
  const double c = std::cos(theta[1] + theta[2]);
  Eigen::Matrix3d r;
  r << c1 * c, -s1, c1 * s, s1 * c, c1, s1 * s, -s, 0, c;
  return r;
}

/// Angle from the next multiple of half a turn.
double off_line(double angle) { return std::abs(std::remainder(angle, kPi)); }

void check(const ArmParameters& p) {
  const std::array<double, 7> measures{p.a1, p.a2, p.b, p.c1, p.c2, p.c3, p.c4};
  const auto finite = [](double value) { return std::isfinite(value); };
  if (!std::ranges::all_of(measures, finite) || !std::ranges::all_of(p.offset, finite))
    throw std::invalid_argument("ArmKinematics: a measure is not finite");
  if (p.c2 <= 0 || p.c3 < 0 || std::hypot(p.a2, p.c3) == 0)
    throw std::invalid_argument("ArmKinematics: the upper arm or the forearm has no length");
  if (!std::ranges::all_of(p.sign, [](double sign) { return std::abs(sign) == 1; }))
    throw std::invalid_argument("ArmKinematics: a sign is neither 1 nor -1");
}

/// The frame of an axis that lies as `lying` turns z, and counts as the robot does.
Eigen::Quaterniond counted(const Eigen::Quaterniond& lying, double sign, double offset) {
  const Eigen::Quaterniond over(0, 1, 0, 0);  // half a turn about x
  return sign > 0 ? lying * about_z(offset) : lying * about_z(offset) * over;
}

/// The arm as a chain, one axis after the other.
JointChain chain_of(const ArmParameters& p, const ArmLimits& limits) {
  const Eigen::Quaterniond up = Eigen::Quaterniond::Identity();
  const Eigen::Quaterniond across(
      Eigen::AngleAxisd(-kPi / 2, Eigen::Vector3d::UnitX()));  // along y
  const std::array<Pose, ArmParameters::kAxes> steps{
      Pose{{0, 0, 0}, up},   {{p.a1, p.b, p.c1}, across}, {{0, 0, p.c2}, across},
      {{p.a2, 0, p.c3}, up}, {{0, 0, 0}, across},         {{0, 0, 0}, up}};
  std::vector<ChainJoint> joints;
  Eigen::Quaterniond back = up;  // from the frame of the axis before to the picture's
  for (std::size_t i = 0; i < steps.size(); ++i) {
    const Eigen::Quaterniond own = counted(steps[i].orientation, p.sign[i], p.offset[i]);
    joints.push_back({{back * steps[i].position, back * own}, false, limits.min[i], limits.max[i]});
    back = counted(steps[i].orientation, p.sign[i], 0).conjugate();
  }
  return JointChain(std::move(joints), {back * Eigen::Vector3d(0, 0, p.c4), back});
}

/// The wrist's three angles for the hand's rotation seen from the forearm,
/// Rz(θ4)·Ry(θ5)·Rz(θ6); θ4 comes in as what it keeps in the singular place.
void turn_hand(const Eigen::Matrix3d& r, Eigen::Matrix<double, 6, 1>& theta) {
  if (r.block<2, 1>(0, 2).norm() >= kInLine) theta[3] = std::atan2(r(1, 2), r(0, 2));
  const double s4 = std::sin(theta[3]);
  const double c4 = std::cos(theta[3]);
  // From Rz(−θ4)·r: well conditioned whatever θ5 is, and what θ4 lacks θ6 makes good.
  theta[4] = std::atan2(c4 * r(0, 2) + s4 * r(1, 2), r(2, 2));
  theta[5] = std::atan2(c4 * r(1, 0) - s4 * r(0, 0), c4 * r(1, 1) - s4 * r(0, 1));
}

}  // namespace

/// Where the wrist shall be, seen from axis 2's height, and how the hand shall be turned.
struct ArmKinematics::Wrist {
  Eigen::Vector3d at;
  Eigen::Matrix3d hand;
  double radius = 0;  // from axis 1
  double ahead = 0;   // of axis 1 in the arm's plane, which is b beside the axis
};

ArmKinematics::ArmKinematics(const ArmParameters& parameters, const ArmLimits& limits)
    : p_(parameters), chain_(chain_of(parameters, limits)) {
  check(p_);
  k_ = std::hypot(p_.a2, p_.c3);
  psi_ = std::atan2(p_.a2, p_.c3);
}

ArmKinematics::Angles ArmKinematics::angles_of(const JointVector& q) const noexcept {
  Angles theta;
  for (int i = 0; i < ArmParameters::kAxes; ++i) {
    const auto index = static_cast<std::size_t>(i);
    theta[i] = p_.sign[index] * q[i] + p_.offset[index];
  }
  return theta;
}

/// How far the wrist is ahead of axis 1, in the arm's plane.
double ArmKinematics::ahead(const Angles& theta) const noexcept {
  return p_.a1 + p_.c2 * std::sin(theta[1]) + k_ * std::sin(theta[1] + theta[2] + psi_);
}

Pose ArmKinematics::forward(const JointVector& q) const noexcept {
  const Angles theta = angles_of(q);
  const double up = p_.c1 + p_.c2 * std::cos(theta[1]) + k_ * std::cos(theta[1] + theta[2] + psi_);
  const Eigen::Quaterniond base = about_z(theta[0]);
  Pose pose;
  pose.orientation = base * about_y(theta[1] + theta[2]) * about_z(theta[3]) * about_y(theta[4]) *
                     about_z(theta[5]);
  const Eigen::Vector3d wrist = base * Eigen::Vector3d(ahead(theta), p_.b, up);
  pose.position = wrist + p_.c4 * (pose.orientation * Eigen::Vector3d::UnitZ());
  return pose;
}

LinkFrames ArmKinematics::frames(const JointVector& q) const noexcept {
  const Angles theta = angles_of(q);
  LinkFrames frames;
  frames[0].orientation = about_z(theta[0]);
  frames[1].position = place_of({p_.a1, p_.b, p_.c1}, frames[0]);
  frames[1].orientation = frames[0].orientation * about_y(theta[1]);
  frames[2].position = place_of({0, 0, p_.c2}, frames[1]);
  frames[2].orientation = frames[1].orientation * about_y(theta[2]);
  frames[3].position = place_of({p_.a2, 0, p_.c3}, frames[2]);
  frames[3].orientation = frames[2].orientation * about_z(theta[3]);
  frames[4] = {frames[3].position, frames[3].orientation * about_y(theta[4])};
  frames[5] = {frames[3].position, frames[4].orientation * about_z(theta[5])};
  frames[6] = {place_of({0, 0, p_.c4}, frames[5]), frames[5].orientation};
  return frames;
}

ArmKinematics::Wrist ArmKinematics::wrist_of(const Pose& pose) const noexcept {
  Wrist wrist;
  // Not normalized(), which takes a quaternion of no length for no rotation.
  const Eigen::Quaterniond hand(pose.orientation.coeffs() / pose.orientation.norm());
  wrist.hand = hand.toRotationMatrix();
  wrist.at = pose.position - p_.c4 * wrist.hand.col(2);
  wrist.at.z() -= p_.c1;
  wrist.radius = std::hypot(wrist.at.x(), wrist.at.y());
  wrist.ahead = other_side(wrist.radius, std::abs(p_.b));
  return wrist;
}

/// From axis 2 to the wrist, in the arm's plane: ahead, up.
Eigen::Vector2d ArmKinematics::span(const Wrist& wrist, bool behind) const noexcept {
  return {(behind ? -wrist.ahead : wrist.ahead) - p_.a1, wrist.at.z()};
}

/// θ1, which comes in as what it keeps where the wrist is on axis 1.
double ArmKinematics::turn_base(const Wrist& wrist, bool behind, double kept) const noexcept {
  if (wrist.radius < kKept) return behind ? kept + kPi : kept;
  return std::atan2(wrist.at.y(), wrist.at.x()) -
         std::atan2(p_.b, behind ? -wrist.ahead : wrist.ahead);
}

/// Shows `take` every solution, those of the branch `first` first. It may lower `within`, a square
/// of the distance from `near`: what is farther by its first axes alone is not worked out.
template <typename Take>
void ArmKinematics::search(const Pose& pose, const JointVector& near, ArmBranch first,
                           const double& within, Take take) const noexcept {
  const Wrist wrist = wrist_of(pose);
  if (!wrist.at.allFinite() || !wrist.hand.allFinite()) return;
  if (wrist.radius < std::abs(p_.b) - kOnAxis) return;
  const Angles kept = angles_of(near);
  for (const bool behind : {first.behind, !first.behind}) {
    const Eigen::Vector2d to_wrist = span(wrist, behind);
    const double s = to_wrist.norm();
    if (s > p_.c2 + k_ + kOnAxis || s < std::abs(p_.c2 - k_) - kOnAxis) continue;
    Angles theta = kept;
    theta[0] = turn_base(wrist, behind, kept[0]);
    if (square_of_way(theta, near, 1) > within) continue;
    // The triangle of upper arm c2, forearm k and s: half its outer angle at axis 3, and by how
    // much the upper arm leads the line to the wrist.
    const double bend =
        2 * std::atan2(other_side(p_.c2 + k_, s), other_side(s, std::abs(p_.c2 - k_)));
    const double lead = std::atan2(k_ * std::sin(bend), p_.c2 + k_ * std::cos(bend));
    const double line = std::atan2(to_wrist.x(), to_wrist.y());
    for (const bool negative : {first.elbow_negative, !first.elbow_negative}) {
      const double side = negative ? -1 : 1;
      if (s >= kKept) theta[1] = line - side * lead;
      theta[2] = side * bend - psi_;
      theta[3] = kept[3];
      if (square_of_way(theta, near, 3) <= within) turn_wrist(wrist, theta, take);
    }
  }
}

/// Both ways to turn the hand on a forearm that stands.
template <typename Take>
void ArmKinematics::turn_wrist(const Wrist& wrist, Angles theta, Take take) noexcept {
  turn_hand(forearm(theta).transpose() * wrist.hand, theta);
  take(theta);
  theta[3] += kPi;
  theta[4] = -theta[4];
  theta[5] += kPi;
  take(theta);
}

InverseSolutions ArmKinematics::solutions(const Pose& pose,
                                          const JointVector& near) const noexcept {
  InverseSolutions found;
  constexpr double kAnywhere = std::numeric_limits<double>::infinity();
  search(pose, near, {}, kAnywhere, [&](const Angles& theta) noexcept {
    JointVector& q = found.q[static_cast<std::size_t>(found.count++)];
    q.resize(ArmParameters::kAxes);
    for (int i = 0; i < ArmParameters::kAxes; ++i) q[i] = axis_value(i, theta[i], near[i]);
  });
  return found;
}

std::optional<JointVector> ArmKinematics::inverse(const Pose& pose,
                                                  const JointVector& near) const noexcept {
  std::optional<Angles> nearest;
  double least = std::numeric_limits<double>::infinity();
  search(pose, near, branch(near), least, [&](const Angles& theta) noexcept {
    const double square = square_of_way(theta, near, ArmParameters::kAxes);
    if (!(square < least)) return;
    least = square;
    nearest = theta;
  });
  if (!nearest) return std::nullopt;
  JointVector q(ArmParameters::kAxes);
  for (int i = 0; i < ArmParameters::kAxes; ++i) q[i] = axis_value(i, (*nearest)[i], near[i]);
  return q;
}

/// As the robot counts the axis, brought near by whole turns.
double ArmKinematics::axis_value(int axis, double theta, double near) const noexcept {
  const auto index = static_cast<std::size_t>(axis);
  const double value = p_.sign[index] * (theta - p_.offset[index]);
  const double apart = value - near;
  return std::abs(apart) <= kPi ? value : near + std::remainder(apart, 2 * kPi);
}

/// Sum of squares of what the first axes are away from `near`.
double ArmKinematics::square_of_way(const Angles& theta, const JointVector& near,
                                    int axes) const noexcept {
  double sum = 0;
  for (int i = 0; i < axes; ++i) {
    const double apart = axis_value(i, theta[i], near[i]) - near[i];
    sum += apart * apart;
  }
  return sum;
}

std::optional<JointVector> ArmKinematics::closest(const Pose& pose,
                                                  const JointVector& near) const noexcept {
  constexpr int kSteps = 40;
  JointVector q = near;
  ChainDescent(chain_).within_limits().approach(pose, kSteps, q);
  return q;
}

Shortfall ArmKinematics::shortfall(const Pose& pose) const noexcept {
  using Kind = Shortfall::Kind;
  const Wrist wrist = wrist_of(pose);
  if (!wrist.at.allFinite() || !wrist.hand.allFinite()) return {};
  if (wrist.radius < std::abs(p_.b) - kOnAxis)
    return {Kind::BesideAxis, std::abs(p_.b) - wrist.radius};
  Shortfall least{Kind::Elsewhere, INFINITY};
  for (const bool behind : {false, true}) {
    const double s = span(wrist, behind).norm();
    const double far = s - (p_.c2 + k_);
    const double near = std::abs(p_.c2 - k_) - s;
    if (std::max(far, near) <= kOnAxis) return {};
    if (std::max(far, near) >= least.distance) continue;
    least = far > near ? Shortfall{Kind::TooFar, far} : Shortfall{Kind::TooNear, near};
  }
  return least;
}

/// Bounds by the lengths between axis and tip, wherever the arm bends.
double ArmKinematics::lever(int axis, const Eigen::Vector3d& tip) const noexcept {
  const double hand = (tip + p_.c4 * Eigen::Vector3d::UnitZ()).norm();
  switch (axis) {
    case 0:
      return std::hypot(std::abs(p_.a1) + p_.c2 + k_, p_.b) + hand;
    case 1:
      return p_.c2 + k_ + hand;
    case 2:
      return k_ + hand;
    case 5:
      return std::hypot(tip.x(), tip.y());
    default:
      return hand;
  }
}

Eigen::Matrix<double, 6, 6> ArmKinematics::jacobian(const JointVector& q) const noexcept {
  const Angles theta = angles_of(q);
  const Pose pose = forward(q);
  const Eigen::Quaterniond base = about_z(theta[0]);
  const Eigen::Matrix3d on_forearm = forearm(theta);
  const Eigen::Vector3d y = Eigen::Vector3d::UnitY();
  const Eigen::Vector3d z = Eigen::Vector3d::UnitZ();
  const Eigen::Vector3d shoulder = base * Eigen::Vector3d(p_.a1, 0, p_.c1);
  const Eigen::Vector3d elbow = shoulder + base * about_y(theta[1]) * Eigen::Vector3d(0, 0, p_.c2);
  const Eigen::Vector3d wrist = pose.position - p_.c4 * (pose.orientation * z);
  // Each axis: its direction, and a point on it.
  const std::array<Eigen::Vector3d, 6> direction{z,
                                                 base * y,
                                                 base * y,
                                                 on_forearm * z,
                                                 on_forearm * (about_z(theta[3]) * y),
                                                 pose.orientation * z};
  const std::array<Eigen::Vector3d, 6> point{
      Eigen::Vector3d::Zero(), shoulder, elbow, wrist, wrist, wrist};
  Eigen::Matrix<double, 6, 6> jacobian;
  for (std::size_t i = 0; i < 6; ++i) {
    const Eigen::Vector3d turning = p_.sign[i] * direction[i];
    jacobian.col(static_cast<int>(i)) << turning.cross(pose.position - point[i]), turning;
  }
  return jacobian;
}

ArmBranch ArmKinematics::branch(const JointVector& q) const noexcept {
  const Angles theta = angles_of(q);
  return {ahead(theta) < 0, std::sin(theta[2] + psi_) < 0, std::sin(theta[4]) < 0};
}

SingularPlace ArmKinematics::nearest_singularity(const JointVector& q,
                                                 double within) const noexcept {
  const SingularityDistances distance = singularities(q);
  const double shoulder = distance.shoulder / (p_.c2 + k_);  // as an angle
  if (std::min({distance.wrist, shoulder, distance.elbow}) > within) return SingularPlace::None;
  if (distance.wrist <= shoulder && distance.wrist <= distance.elbow) return SingularPlace::Wrist;
  return shoulder <= distance.elbow ? SingularPlace::Shoulder : SingularPlace::Elbow;
}

SingularityDistances ArmKinematics::singularities(const JointVector& q) const noexcept {
  const Angles theta = angles_of(q);
  return {std::abs(ahead(theta)), off_line(theta[2] + psi_), off_line(theta[4])};
}

}  // namespace rob::motion
