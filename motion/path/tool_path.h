#pragma once

#include <numbers>

#include "motion/space/pose.h"

namespace rob::motion {

class JointPath;

/// Where the tip of a tool goes, without time: its pose in the world as a smooth function of a
/// parameter s from begin() to end(). m, rad.
class ToolPath {
 public:
  virtual ~ToolPath() = default;

  /// Also a little beyond both ends, where the curve goes on.
  virtual Pose at(double s) const noexcept = 0;
  /// The motion of the axes along it, where they lead the tool; null where they follow from it.
  virtual const JointPath* axes() const noexcept { return nullptr; }
  virtual double begin() const noexcept { return 0; }
  virtual double end() const noexcept { return 1; }

  /// The tip's way along the curve, m, and what the tool turns on it, rad.
  virtual double way() const noexcept = 0;
  virtual double turn() const noexcept = 0;
  /// The greatest speeds of both per unit of s.
  virtual double greatest_speed() const noexcept { return way() / (end() - begin()); }
  virtual double greatest_turning() const noexcept { return turn() / (end() - begin()); }
  /// The first and the last point between its ends that it has to meet; the other end without.
  virtual double first_point() const noexcept { return end(); }
  virtual double last_point() const noexcept { return begin(); }
  /// In so many even parts it bends little. [choice] eight at least: then the differences from
  /// which derivatives are made are small, too.
  virtual double parts() const noexcept { return 8; }
  /// Where the tip has gone that part of its way, 0 … 1; and the other way round.
  virtual double at_share(double share) const noexcept {
    return begin() + share * (end() - begin());
  }
  virtual double share_at(double s) const noexcept { return (s - begin()) / (end() - begin()); }
};

/// ToolPath::at_share() from share_at(), which only grows.
double parameter_of(const ToolPath& path, double share) noexcept;

/// m: what a radian counts where ways and turns are compared, 1 mm a degree.
inline constexpr double kPerRadian = 0.18 / std::numbers::pi;

/// How fast the tool moves at s, per unit of s.
struct ToolSpeed {
  double way = 0;   ///< m: of its tip
  double turn = 0;  ///< rad
};
ToolSpeed speed_at(const ToolPath& path, double s) noexcept;

/// The measure of a path, m: its way, or where only the orientation changes 1 mm a degree.
double measure_of(const ToolPath& path) noexcept;

}  // namespace rob::motion
