#pragma once

#include <limits>

#include <Eigen/Core>

namespace rob::motion {

/// The in-position window: how near the measured robot must be to its reference before an exact
/// motion counts as done. SI. It says nothing where neither distance nor angle is bounded.
struct SettleWindow {
  double distance = std::numeric_limits<double>::infinity();  ///< m, of the tool's tip
  double angle = std::numeric_limits<double>::infinity();     ///< rad, of the tool and rotary axes
  double time = 1;  ///< s from the end of the reference: by then the robot must be in position
  Eigen::Vector3d tip = Eigen::Vector3d::Zero();  ///< m, seen from the flange

  bool present() const noexcept {
    constexpr double kAny = std::numeric_limits<double>::infinity();
    return distance < kAny || angle < kAny;
  }
};

}  // namespace rob::motion
