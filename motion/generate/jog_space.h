#pragma once

#include <algorithm>
#include <optional>

#include "motion/kinematics/kinematics.h"
#include "motion/plan/jog_rates.h"

namespace rob::motion {

/// Where a jog is, in the space of its rates. World: six coordinates, integrated as they are, so
/// that nothing is lost where an orientation does not give the fixed angles (b = ±90°).
struct JogPlace {
  JointVector coordinates;  ///< Joint: the axes; World: x y z a b c; Tool: none
  Pose tip;                 ///< Tool
};

/// A jog at an instant.
struct JogState {
  JogPlace place;
  JointVector rate;          ///< of the coordinates
  JointVector acceleration;  ///< d rate / dt
  JointReference axes;
};

/// How fast a tool is: its tip, m/s, and how fast it turns, rad/s.
struct JogSpeed {
  /// By how much a bound may be exceeded: rounding, and the speed between the steps of a rest.
  /// [choice] less than half of what a person could measure
  static constexpr double kOver = 2e-3;
  /// m/s, rad/s: the same where nothing is to move. [choice] far below an encoder's count in a
  /// period
  static constexpr double kStill = 1e-7;

  double linear = 0;
  double angular = 0;

  bool within(const JogSpeed& most) const noexcept {
    return linear <= most.linear * (1 + kOver) + kStill &&
           angular <= most.angular * (1 + kOver) + kStill;
  }
};

/// The greater of each.
inline JogSpeed greater(const JogSpeed& a, const JogSpeed& b) noexcept {
  return {std::max(a.linear, b.linear), std::max(a.angular, b.angular)};
}

/// The space of a jog's rates, and the way from it to the axes. May be used in the tick.
class JogSpace {
 public:
  /// Without kinematics there is the space of the axes alone.
  explicit JogSpace(const Kinematics* kinematics) noexcept : kinematics_(kinematics) {}

  /// The space of `rates`; its first place, where the axes are at q.
  JogPlace enter(const JogRates& rates, const JointVector& q) noexcept;
  /// Whether a place of it stays one for `rates`.
  bool same_as(const JogRates& rates) const noexcept;
  bool joint() const noexcept { return space_ == JogRates::Space::Joint; }

  /// The place after a displacement: of each coordinate, or a screw along the tool's axes.
  JogPlace moved(const JogPlace& from, const JointVector& displacement) const noexcept;
  /// The axis values nearest to `near` that bring the tip there; none where there are none.
  std::optional<JointVector> axes(const JogPlace& place, const JointVector& near) const noexcept;
  /// The rates of the axes for a rate of the coordinates, m/s or rad/s; none if the arm reaches to
  /// neither side.
  std::optional<JointVector> image(const JogState& at, const JointVector& rate) const noexcept;
  /// How fast rates would move the tool in a state.
  JogSpeed speed(const JogState& at, const JointVector& rate) const noexcept;
  /// How fast the tool is at the end of a step at constant jerk, or where its rates are greatest.
  JogSpeed fastest(const JogState& from, const JogState& to, double time) const noexcept;
  /// See Kinematics.
  double stretch(const JointVector& q) const noexcept { return kinematics_->stretch(q); }
  /// The tip where the axes are at q.
  Pose tip(const JointVector& q) const noexcept;

 private:
  const Kinematics* kinematics_;
  JogRates::Space space_ = JogRates::Space::None;
  Pose flange_T_tip_;
};

}  // namespace rob::motion
