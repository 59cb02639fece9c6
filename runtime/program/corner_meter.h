#pragma once

#include <array>
#include <cstdint>
#include <optional>

#include "motion/kinematics/kinematics.h"
#include "motion/space/joint_vector.h"

namespace rob::runtime {

/// Measures by how far the tool's tip missed each programmed point: the least distance of its
/// measured path from it, in m. Between two measurements the path is taken as a chord, which at 10
/// ms and the accelerations of a robot lies within micrometres of it (a·T²/8).
class CornerMeter {
 public:
  explicit CornerMeter(const motion::Kinematics& kinematics) : kinematics_(kinematics) {}

  /// From now on the path is measured against segment `number`'s target too, reached with a tool
  /// whose tip is there, seen from the flange, m.
  void watch(std::uint32_t number, const motion::JointVector& target, const Eigen::Vector3d& tip);
  /// `pressed`: by what the flange is beside its path, in the world, m.
  void measured(const motion::JointVector& q,
                const Eigen::Vector3d& pressed = Eigen::Vector3d::Zero());
  /// The least distance so far; the point is watched no longer.
  std::optional<double> take(std::uint32_t number);

 private:
  struct Vertex {
    std::uint32_t number = 0;  ///< 0: free
    Eigen::Vector3d tip = Eigen::Vector3d::Zero();
    Eigen::Vector3d position = Eigen::Vector3d::Zero();
    Eigen::Vector3d passed = Eigen::Vector3d::Zero();  ///< the last place of the tip
    double least = 0;

    /// The tip has come here from where it was.
    void pass(const Eigen::Vector3d& place);
  };

  const motion::Kinematics& kinematics_;
  std::array<Vertex, 4> vertices_;    ///< a point is near for two segments
  std::optional<motion::Pose> last_;  ///< of the flange
};

}  // namespace rob::runtime
