#pragma once

#include <cstdint>
#include <variant>

#include "motion/path/tool_path.h"

namespace rob::motion {

/// A straight line, on which the fixed angles a, b, c (pose.h) change evenly, each by its shorter
/// way.
class EulerLine final : public ToolPath {
 public:
  /// Why there is none.
  enum class Trouble : std::uint8_t {
    HalfTurn,        ///< an angle would change by 180°: there is no shorter way
    SteepBeginning,  ///< b is within 1° of ±90°, where a and c turn about one line
    SteepEnd
  };
  static std::variant<EulerLine, Trouble> between(const Pose& from, const Pose& to);

  Pose at(double s) const noexcept override;
  double way() const noexcept override { return shift_.norm(); }
  double turn() const noexcept override { return turn_; }
  double greatest_turning() const noexcept override { return greatest_turning_; }

 private:
  EulerLine(const Pose& from, const Pose& to);

  /// The turning of the tool, rad per unit of s.
  double turning_at(double s) const noexcept;

  Eigen::Vector3d from_;
  Eigen::Vector3d shift_;
  FixedAngles first_;
  FixedAngles change_;
  double turn_ = 0;
  double greatest_turning_ = 0;
};

}  // namespace rob::motion
