#include "motion/generate/jog_space.h"

#include <cmath>

namespace rob::motion {

namespace {

Pose composed(const Pose& frame, const Pose& inner) noexcept {
  return {place_of(inner.position, frame), frame.orientation * inner.orientation};
}

Pose inverted(const Pose& pose) noexcept {
  const Eigen::Quaterniond back = pose.orientation.conjugate();
  return {-(back * pose.position), back};
}

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
  return kinematics_->inverse(composed(tip, inverted(flange_T_tip_)), near);
}

Pose JogSpace::tip(const JointVector& q) const noexcept {
  return composed(kinematics_->forward(q), flange_T_tip_);
}

}  // namespace rob::motion
