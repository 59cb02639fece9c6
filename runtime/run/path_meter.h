#pragma once

#include <array>
#include <cstddef>
#include <vector>

#include <Eigen/Dense>

#include "motion/kinematics/kinematics.h"
#include "motion/plan/leg_motion.h"
#include "motion/space/joint_vector.h"

namespace rob::runtime {

/// Measures the way of the tip's reference, and how far it strays from the programmed path: the
/// legs that lead from target to target, straight in the axes or along a path of the tool. Lengths
/// in m.
class PathMeter {
 public:
  PathMeter(const motion::Kinematics& kinematics, const motion::JointVector& start)
      : kinematics_(&kinematics), last_(kinematics.forward(start)) {}

  /// A further leg of the programmed path; the reference is on it, or still on one before it.
  /// `line`: it leads the tip straight; `tip`: of its tool, seen from the flange, m.
  void programmed(const motion::LegMotion& leg, bool line, const Eigen::Vector3d& tip);
  /// No path is programmed from here on, but the tip goes on.
  void unprogrammed(const Eigen::Vector3d& tip);
  bool is_unprogrammed() const { return free_; }
  /// The next reference. Returns the way of the newest leg's tip since the one before it.
  double reference(const motion::JointVector& q);
  /// The greatest distance of any reference so far from the programmed path.
  double deviation() const { return deviation_; }

 private:
  /// A leg is known by points on it. [choice] 16 chords: on a leg of 90° about an axis 1 m away
  /// they lie within 1.2 mm of the arc, on a straight one exactly on it. 256 along a path of the
  /// tool: within 0.008 mm of a whole circle of 100 mm radius.
  static constexpr std::size_t kChords = 16;
  static constexpr std::size_t kPathChords = 256;
  /// The two legs of a corner, and one more for a motion of no length between them.
  static constexpr std::size_t kLegs = 3;
  struct Leg {
    Eigen::Vector3d tip = Eigen::Vector3d::Zero();
    std::vector<Eigen::Vector3d> points{};

    double distance(const motion::Pose& flange, double enough) const;
  };

  double distance(const motion::Pose& flange) const;

  const motion::Kinematics* kinematics_;
  motion::Pose last_;  ///< of the flange
  std::array<Leg, kLegs> legs_;
  std::size_t count_ = 0;  ///< of legs so far
  bool free_ = false;      ///< unprogrammed
  double deviation_ = 0;
};

/// The distance of a point from a stretch of a straight line.
double distance_to_chord(const Eigen::Vector3d& point, const Eigen::Vector3d& from,
                         const Eigen::Vector3d& to);

}  // namespace rob::runtime
