#pragma once

#include <cstdint>
#include <limits>

#include "motion/space/joint_vector.h"
#include "motion/space/pose.h"

namespace rob::motion {

/// Rates at which a robot is asked to move, without a target (S2's velocity modes).
struct JogRates {
  enum class Space : std::uint8_t {
    None,   ///< no jog
    Joint,  ///< one rate for each axis, m/s or rad/s
    World,  ///< x y z of the tip in the world, m/s, and its fixed angles a b c (FixedAngles), rad/s
    Tool    ///< the tip's velocity, m/s, and angular velocity, rad/s, both along the tool's axes
  };

  static constexpr double kAny = std::numeric_limits<double>::infinity();

  Space space = Space::None;
  JointVector rate;     ///< as many as axes, or six
  Pose tip;             ///< of the tool, seen from the flange
  double lasts = kAny;  ///< s of the motion, whole periods; kAny: until something ends it, or it
                        ///< goes no further
  double share = 1;     ///< of the speeds of the axes, above 0 up to 1, that it may take
  double tool_speed = kAny;     ///< m/s that the tip may take
  double turning_speed = kAny;  ///< rad/s: of each rotary axis (Joint), or of the tool

  /// It joins the jog before as soon as it is seen, and does not wait for the end of its time:
  /// rates that a hand gives, each for as long as it may be silent.
  bool at_once = false;

  bool present() const noexcept { return space != Space::None; }
};

}  // namespace rob::motion
