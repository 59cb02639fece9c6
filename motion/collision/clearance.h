#pragma once

#include <memory>
#include <string>
#include <vector>

#include "motion/collision/collision_data.h"
#include "motion/kinematics/kinematics.h"

namespace rob::motion {

/// The pairs of a robot that can hit each other, and their distances. Bodies that hang together are
/// left out: those of one frame or of neighbouring ones, and the base among the obstacles. A robot
/// without bodies has no pairs.
class Clearance {
 public:
  /// A body and a body, or a body and an obstacle.
  struct Pair {
    int body = 0;
    int other = 0;  ///< the number of a body that is farther from the base, or an obstacle's
    bool obstacle = false;  ///< the other is one
  };

  Clearance() = default;
  /// `travel`: of each axis, m, for a linear one the way from 0 to its farthest end; 0 for others.
  Clearance(std::shared_ptr<const Kinematics> kinematics, const JointVector& travel,
            CollisionData data);

  /// The same where the robot carries this, too.
  Clearance with(Body carried) const;

  const std::vector<Pair>& pairs() const noexcept { return pairs_; }
  const std::string& name_of_body(const Pair& pair) const {
    return data_.bodies[static_cast<std::size_t>(pair.body)].name;
  }
  const std::string& name_of_other(const Pair& pair) const;

  int axes() const noexcept { return static_cast<int>(travel_.size()); }
  LinkFrames frames(const JointVector& q) const noexcept { return kinematics_->frames(q); }
  /// m; 0 or less where they touch.
  double distance(const Pair& pair, const LinkFrames& frames) const noexcept;
  /// How much nearer a pair comes at most where the axes go so far, m: `way`, m or rad of each.
  double approach(std::size_t pair, const JointVector& way) const noexcept {
    return levers_[pair].dot(way);
  }
  /// The most that any pair does.
  double greatest_approach(const JointVector& way) const noexcept { return most_.dot(way); }
  /// approach() multiplies the way with these.
  const JointVector& levers(std::size_t pair) const noexcept { return levers_[pair]; }
  const JointVector& greatest_levers() const noexcept { return most_; }

 private:
  Capsule placed(const Capsule& shape, int frame, const LinkFrames& frames) const noexcept;
  void find_levers(const JointVector& travel);
  bool allowed(const std::string& name) const;
  bool may_touch(const Body& a, const Body& b) const;
  bool may_touch(const Body& body, const Obstacle& obstacle) const;

  std::shared_ptr<const Kinematics> kinematics_;
  JointVector travel_;
  CollisionData data_;
  std::vector<Pair> pairs_;
  std::vector<JointVector> levers_;  // for each pair and axis: m per rad; 1 if it is linear
  JointVector most_;                 // for each axis the greatest lever of all pairs
};

}  // namespace rob::motion
