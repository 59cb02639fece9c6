#include "motion/collision/clearance.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <limits>

#include "motion/collision/distance.h"

namespace rob::motion {

namespace {

/// How far a body's capsules reach from the origin of its frame. Their radii do not count: a
/// distance of capsules is one of their segments.
double extent(const Body& body) {
  double most = 0;
  for (const Capsule& shape : body.shapes)
    most = std::max({most, shape.from.norm(), shape.to.norm()});
  return most;
}

bool named(const Apart& apart, const std::string& a, const std::string& b) {
  return (apart.first == a && apart.second == b) || (apart.first == b && apart.second == a);
}

}  // namespace

Clearance::Clearance(std::shared_ptr<const Kinematics> kinematics, const JointVector& travel,
                     CollisionData data)
    : kinematics_(std::move(kinematics)), travel_(travel), data_(std::move(data)) {
  std::ranges::stable_sort(data_.bodies, {}, &Body::frame);
  const auto count = static_cast<int>(data_.bodies.size());
  for (int i = 0; i < count; ++i) {
    const Body& body = data_.bodies[static_cast<std::size_t>(i)];
    for (int j = i + 1; j < count; ++j)
      if (!may_touch(body, data_.bodies[static_cast<std::size_t>(j)]))
        pairs_.push_back({i, j, false});
    if (body.frame == 0) continue;
    for (int j = 0; j < static_cast<int>(data_.obstacles.size()); ++j)
      if (!may_touch(body, data_.obstacles[static_cast<std::size_t>(j)]))
        pairs_.push_back({i, j, true});
  }
  find_levers(travel);
}

Clearance Clearance::with(Body carried) const {
  CollisionData data = data_;
  data.bodies.push_back(std::move(carried));
  return {kinematics_, travel_, std::move(data)};
}

bool Clearance::allowed(const std::string& name) const {
  return std::ranges::find(data_.allowed, name) != data_.allowed.end();
}

/// Neighbours hang together. The flange is fixed to the last axis' link: the two are one.
bool Clearance::may_touch(const Body& a, const Body& b) const {
  const auto joint = [&](const Body& body) { return std::min(body.frame, kinematics_->axes()); };
  if (std::abs(joint(a) - joint(b)) <= 1) return true;
  if (allowed(a.name) || allowed(b.name)) return true;
  return std::ranges::any_of(data_.apart,
                             [&](const Apart& two) { return named(two, a.name, b.name); });
}

bool Clearance::may_touch(const Body& body, const Obstacle& obstacle) const {
  if (allowed(body.name) || allowed(obstacle.name)) return true;
  if (obstacle.hand_may_touch && body.frame > kinematics_->axes()) return true;
  return std::ranges::any_of(
      data_.apart, [&](const Apart& two) { return named(two, body.name, obstacle.name); });
}

const std::string& Clearance::name_of_other(const Pair& pair) const {
  const auto number = static_cast<std::size_t>(pair.other);
  return pair.obstacle ? data_.obstacles[number].name : data_.bodies[number].name;
}

Capsule Clearance::placed(const Capsule& shape, int frame,
                          const LinkFrames& frames) const noexcept {
  return frame == 0 ? shape : moved(shape, frames[static_cast<std::size_t>(frame - 1)]);
}

double Clearance::distance(const Pair& pair, const LinkFrames& frames) const noexcept {
  double least = std::numeric_limits<double>::infinity();
  const Body& body = data_.bodies[static_cast<std::size_t>(pair.body)];
  for (const Capsule& shape : body.shapes) {
    const Capsule here = placed(shape, body.frame, frames);
    if (pair.obstacle) {
      const Obstacle& obstacle = data_.obstacles[static_cast<std::size_t>(pair.other)];
      least = std::min(least, motion::distance(here, obstacle));
      continue;
    }
    const Body& other = data_.bodies[static_cast<std::size_t>(pair.other)];
    for (const Capsule& its : other.shapes)
      least = std::min(least, motion::distance(here, placed(its, other.frame, frames)));
  }
  return least;
}

/// Neighbouring frames keep their distance when axes turn; a linear axis adds its travel. So the
/// sum of these distances from an axis to a body bounds how far any point of the body is from the
/// axis.
void Clearance::find_levers(const JointVector& travel) {
  if (pairs_.empty()) return;
  const int axes = kinematics_->axes();
  most_ = JointVector::Zero(axes);
  const LinkFrames at_zero = kinematics_->frames(JointVector::Zero(axes));
  const auto lever = [&](const Body& body, int axis) {
    if (axis >= body.frame) return 0.0;  // it does not move the body
    if (kinematics_->shifts(axis)) return 1.0;
    double length = extent(body);
    for (int k = axis + 1; k < body.frame; ++k) {
      const auto i = static_cast<std::size_t>(k);
      length += (at_zero[i].position - at_zero[i - 1].position).norm();
      if (k < axes) length += travel[k];
    }
    return length;
  };
  for (const Pair& pair : pairs_) {
    const Body& near = data_.bodies[static_cast<std::size_t>(pair.body)];
    const Body& far = pair.obstacle ? near : data_.bodies[static_cast<std::size_t>(pair.other)];
    JointVector levers = JointVector::Zero(axes);
    // An axis that moves both of two bodies does not change their distance.
    const int first = pair.obstacle ? 0 : near.frame;
    for (int axis = first; axis < axes; ++axis) levers[axis] = lever(far, axis);
    levers_.push_back(levers);
    most_ = most_.cwiseMax(levers);
  }
}

}  // namespace rob::motion
