#pragma once

#include <array>
#include <cstdint>
#include <optional>

#include "base/motion_clauses.h"
#include "lang/machine/motion_words.h"
#include "lang/machine/robot_signature.h"
#include "lang/values/pose_math.h"

namespace rob::lang {

/// A motion as the program asks for it. SI units: m, rad, s.
struct MoveCommand {
  /// The kind of the components of a target.
  enum class Target : std::uint8_t {
    Coordinates,  ///< of a tuple, as elements_of(robot) names them
    Axes,         ///< the axes themselves
    Pose          ///< of the tool in the world, x y z w i j k; BY: x y z added to its place
  };
  using Pace = rob::Pace;
  using Zone = rob::Zone;
  using Bound = rob::Bound;

  MotionKind kind = MotionKind::Joint;
  JogFrame jog{};  ///< of Jog
  Target means = Target::Coordinates;
  bool relative = false;   ///< BY: from the last commanded target
  int count = 0;           ///< components that there are
  std::uint8_t given = 0;  ///< bit i: component i was written
  /// A component not given is 0. For a Jog: rates, m/s or rad/s, of the coordinates or the axes.
  std::array<double, kMaxCoordinates> target{};
  bool in_frame = false;  ///< a Pose without a frame of its own: it is seen from the Setting's
  double radius = 0;      ///< of Spiral: where it begins, m from its centre
  double turns = 0;       ///< of Spiral: until the centre is reached
  double lasts = 0;       ///< of Jog: FOR, s of the motion; 0 where left out
  Pace pace = Pace::Unspecified;
  double pace_value = 0;
  double over = 0;  ///< OVER: lower bound on the duration, s; 0 where it was left out
  Zone zone = Zone::Unspecified;
  double zone_value = 0;  ///< 0: the target is reached exactly, as with FINE
  double zone_angle = 0;  ///< ZONE 5mm 2deg: rad by which the tool may turn off; 0: the robot's
  bool fine = false;
  bool euler = false;      ///< of Line: the angles a, b, c change evenly
  double fine_within = 0;  ///< FINE 0.1mm: m that the measured tool may be away; 0: the robot's
  Bound accel = Bound::Unspecified;
  double accel_value = 0;
  Bound jerk = Bound::Unspecified;
  double jerk_value = 0;
  Profile profile = Profile::Unspecified;
  FreeTurn free = FreeTurn::None;  ///< FREE: of the target and of the points of VIA
  /// For FREE c: z, in the world, of the frame that the target says it is in; none: of the
  /// Setting's.
  std::optional<Vector3> free_axis{};
  /// NEAR: joints of the branch, m or rad, one for each axis.
  std::optional<std::array<double, kMaxCoordinates>> near{};
  bool live = false;  ///< AT LIVE has said its pace before (Motions::live_pace)
  /// Lines (line_tag) of the WITH or DEFAULT that a clause is of; 0 where it is the motion's own.
  int pace_line = 0;
  int zone_line = 0;  ///< of FINE, too
  int accel_line = 0;

  bool has(int i) const { return (given >> i & 1) != 0; }
  /// Whether the motion must reach the target exactly, at rest.
  bool exact() const { return fine || (zone != Zone::Unspecified && zone_value == 0); }
};

/// Gives a motion the clauses of `defaults` that it does not have: each by itself, FINE and ZONE as
/// one. A motion with a profile, which ends at rest, takes no ZONE, and a jog nothing.
void take_defaults(const MoveCommand& defaults, MoveCommand& command);

/// MoveCommand::given where all of `count` components are.
constexpr std::uint8_t given_all(int count) {
  return static_cast<std::uint8_t>((1U << static_cast<unsigned>(count)) - 1);
}

constexpr Dimension dimension_of(MoveCommand::Pace pace) {
  return pace == MoveCommand::Pace::ToolSpeed      ? kSpeed
         : pace == MoveCommand::Pace::AngularSpeed ? kAngularSpeed
                                                   : kNone;
}

}  // namespace rob::lang
