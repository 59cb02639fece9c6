#include "motion/generate/jog_space.h"

#include <algorithm>
#include <cmath>

namespace rob::motion {

namespace {

/// m, rad: the step of the differences from which rates of the axes come. [choice] the square root
/// of the rounding of a position
constexpr double kNearby = 1e-7;

/// A body that moves for a unit of time at constant velocity and angular velocity, both along its
/// own axes: the exponential of a twist (Murray, Li, Sastry 1994, eq. 2.36).
Pose screw(const Eigen::Vector3d& velocity, const Eigen::Vector3d& turning) noexcept {
  constexpr double kNoTurn = 1e-6;  // rad; below, the series is exact: angle^4/120 < 1e-26
  const double angle = turning.norm();
  const double square = angle * angle;
  const bool straight = angle < kNoTurn;
  const double half_sine = straight ? 0.5 - square / 48 : std::sin(angle / 2) / angle;
  const double first = 2 * half_sine * half_sine;  // (1 − cos)/angle²
  const double second =
      straight ? 1.0 / 6 - square / 120 : (angle - std::sin(angle)) / (angle * square);
  const Eigen::Vector3d across = turning.cross(velocity);
  Pose pose;
  pose.position = velocity + first * across + second * turning.cross(across);
  pose.orientation.w() = std::cos(angle / 2);
  pose.orientation.vec() = half_sine * turning;
  return pose;
}

}  // namespace

JogPlace JogSpace::enter(const JogRates& rates, const JointVector& q) noexcept {
  space_ = rates.space;
  flange_T_tip_ = rates.tip;
  JogPlace place;
  place.coordinates = q;
  if (joint()) return place;
  place.tip = tip(q);
  place.coordinates.setZero(6);
  if (space_ != JogRates::Space::World) return place;
  const FixedAngles angles = fixed_angles(place.tip.orientation);
  place.coordinates << place.tip.position, angles.a, angles.b, angles.c;
  return place;
}

bool JogSpace::same_as(const JogRates& rates) const noexcept {
  if (rates.space != space_) return false;
  return joint() || (rates.tip.position == flange_T_tip_.position &&
                     rates.tip.orientation.coeffs() == flange_T_tip_.orientation.coeffs());
}

JogPlace JogSpace::moved(const JogPlace& from, const JointVector& displacement) const noexcept {
  JogPlace to = from;
  if (space_ != JogRates::Space::Tool) {
    to.coordinates += displacement;
    return to;
  }
  to.tip = composed(from.tip, screw(displacement.head<3>(), displacement.tail<3>()));
  to.tip.orientation.normalize();
  return to;
}

std::optional<JointVector> JogSpace::axes(const JogPlace& place,
                                          const JointVector& near) const noexcept {
  if (joint()) return place.coordinates;
  Pose tip = place.tip;
  if (space_ == JogRates::Space::World) {
    const JointVector& x = place.coordinates;
    tip = {x.head<3>(), orientation_from({x[3], x[4], x[5]})};
  }
  return kinematics_->inverse(composed(tip, inverse(flange_T_tip_)), near);
}

std::optional<JointVector> JogSpace::image(const JogState& at,
                                           const JointVector& rate) const noexcept {
  if (joint()) return rate;
  const double time = kNearby / std::max(rate.cwiseAbs().maxCoeff(), kNearby);
  const JointVector& here = at.axes.q;
  const auto ahead = axes(moved(at.place, rate * time), here);
  const auto behind = axes(moved(at.place, rate * -time), here);
  if (ahead && behind) return JointVector((*ahead - *behind) / (2 * time));
  if (ahead) return JointVector((*ahead - here) / time);
  if (behind) return JointVector((here - *behind) / time);
  return std::nullopt;
}

JogSpeed JogSpace::speed(const JogState& at, const JointVector& rate) const noexcept {
  if (joint()) {
    // s between the places of the tip. [choice] an axis turns by less than 1e-3 rad meanwhile
    constexpr double kBetween = 1e-4;
    const Pose behind = tip(at.axes.q - rate * (kBetween / 2));
    const Pose ahead = tip(at.axes.q + rate * (kBetween / 2));
    return {(ahead.position - behind.position).norm() / kBetween,
            behind.orientation.angularDistance(ahead.orientation) / kBetween};
  }
  const double linear = rate.head<3>().norm();
  if (space_ == JogRates::Space::Tool) return {linear, rate.tail<3>().norm()};
  // R = Rz(c)·Ry(b)·Rx(a): the axes of a and c meet at an angle whose cosine is −sin b.
  const double leaning = 2 * rate[3] * rate[5] * std::sin(at.place.coordinates[4]);
  return {linear, std::sqrt(std::max(0.0, rate.tail<3>().squaredNorm() - leaning))};
}

JogSpeed JogSpace::fastest(const JogState& from, const JogState& to, double time) const noexcept {
  const double gains = from.acceleration.dot(from.rate);
  const double loses = -to.acceleration.dot(to.rate);
  if (!(gains > 0 && loses > 0)) return speed(to, to.rate);
  const double part = gains / (gains + loses);
  const JointVector bend = from.acceleration * (2 - part) + to.acceleration * part;
  return speed(to, from.rate + bend * (part * time / 2));
}

Pose JogSpace::tip(const JointVector& q) const noexcept {
  return composed(kinematics_->forward(q), flange_T_tip_);
}

}  // namespace rob::motion
