#pragma once

#include <cstddef>
#include <cstdint>
#include <deque>
#include <optional>

#include "motion/kinematics/kinematics.h"
#include "motion/space/joint_vector.h"

namespace rob::runtime {

/// Measures by how far the tool's tip missed each programmed point: the least distance of its
/// measured path from it, in m. Between two measurements the path is taken as a chord, which at 10
/// ms and the accelerations of a robot lies within micrometres of it (a·T²/8).
///
/// Where motions are shorter than the way of a period or two, the tip may pass a point that long
/// before its motion begins or after the next one has ended. So the way of the last kAround
/// periods counts for a point within it, and a point that is left is watched for as long.
class CornerMeter {
 public:
  /// Periods. [choice] A mean of the axes was seen to lead on a curve by the way of one period.
  static constexpr int kAround = 4;

  /// A point's motion, and the least distance of the tip from the point.
  struct Miss {
    std::uint32_t tag = 0;  ///< of its motion
    double least = 0;       ///< m
  };

  explicit CornerMeter(const motion::Kinematics& kinematics) : kinematics_(kinematics) {}

  /// From now on the path is measured against segment `number`'s target too, reached with a tool
  /// whose tip is there, seen from the flange, m.
  void watch(std::uint32_t number, const motion::JointVector& target, const Eigen::Vector3d& tip);
  /// `pressed`: by what the flange is beside its path, in the world, m.
  void measured(const motion::JointVector& q,
                const Eigen::Vector3d& pressed = Eigen::Vector3d::Zero());
  /// The tip has passed the point of segment `number`, which belongs to `tag`, but for kAround
  /// periods.
  void leave(std::uint32_t number, std::uint32_t tag);
  /// The next point whose miss is known; `all`: the run is over.
  std::optional<Miss> take(bool all = false);

 private:
  struct Vertex {
    std::uint32_t number = 0;
    Eigen::Vector3d tip = Eigen::Vector3d::Zero();
    Eigen::Vector3d position = Eigen::Vector3d::Zero();
    Eigen::Vector3d passed = Eigen::Vector3d::Zero();  ///< the last place of the tip
    double least = 0;
    std::uint32_t tag = 0;
    int left = kUnbounded;  ///< periods for which it is watched

    /// The tip has come here from where it was.
    void pass(const Eigen::Vector3d& place);
  };

  static constexpr int kUnbounded = -1;
  /// A point is near for two segments; what is not left by then is watched no longer.
  static constexpr std::ptrdiff_t kNear = 4;

  void forget_oldest();

  const motion::Kinematics& kinematics_;
  std::deque<Vertex> vertices_;
  std::deque<motion::Pose> poses_;  ///< of the flange: the last kAround + 1
};

}  // namespace rob::runtime
