#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "tests/support/path_deviation.h"
#include "tests/support/trace_figures.h"

namespace rob::test {

/// What random motions have to know of a robot: mm, deg, s.
struct MotionRobot {
  enum class Kind {
    Linear,
    Gantry,
    Arm
  };  ///< targets (x, y, z), (x, y, theta), (x, y, z, a, b, c)

  Kind kind = Kind::Linear;
  std::string robot;                    ///< as --robot takes it
  std::vector<AxisBounds> axes;         ///< limits of the axes
  Eigen::Vector3d least, most;          ///< the box in which the tool is led
  Eigen::Vector3d turned{180, 0, 180};  ///< deg: of an arm's tool, whole ones
  double zone = 0;                      ///< mm: the most that a corner without ZONE misses
  double reach = 0;                     ///< mm: the longest motion
  int least_speed = 1, most_speed = 1;  ///< mm/s of AT
  bool turning = false;                 ///< a linear one with an axis that turns, too
  bool look_ahead = false;              ///< ACCEL and JERK are possible
};

/// How many of its first axes are linear.
inline std::size_t linear_axes(const MotionRobot& robot) {
  using Kind = MotionRobot::Kind;
  return robot.kind == Kind::Arm ? 0 : robot.kind == Kind::Gantry ? 2 : 3;
}

/// An output on the way of a motion: the next change of DOUT[8].
struct PathMark {
  int line = 0;       ///< of the motion, in the text
  double place = 0;   ///< mm from its beginning
  double lag = 0;     ///< s later; less than 0: sooner, by LEAD
  double length = 0;  ///< mm: of the motion
};

/// A program of all kinds of motions, and what is known of its way beforehand.
struct RandomMotions {
  std::string text;
  std::string signals;         ///< a signal script: what comes at random instants
  std::string override_share;  ///< "87%": of --override
  Eigen::Vector3d tool = Eigen::Vector3d::Zero();  ///< mm: its tip, seen from the flange
  ProgrammedPath path;          ///< where the tool is led; its points are the targets
  std::vector<int> lines;       ///< of each point: that of its motion, or the last behind it
  std::vector<double> misses;   ///< mm: by which each point may be missed
  std::vector<double> besides;  ///< mm: by which the tool may be beside the way to it
  std::vector<PathMark> marks;  ///< where nothing ends a motion early: in order
  double least_jerk = 0;        ///< mm/s³ that any motion asks for; 0: none does
  double jerk = 0;              ///< mm/s³ that every motion asks for; 0: not every one
  std::vector<int> leaping;     ///< lines of the text whose acceleration leaps: they have a PROFILE
  bool averaged = false;        ///< the jerk is bounded: corners may be longer than their legs
  bool known = true;            ///< the path between the points is that of `path`
  bool whole = true;            ///< nothing ends a motion before its target
};

/// The random program number `seed` for that robot: always the same for the same number. Motions of
/// all kinds, dense runs of short ones, repeated targets, every kind of ZONE, AT, OVER, ACCEL,
/// JERK, PROFILE, reversals, single axes, PATHs, targets in a frame, tools, outputs behind and
/// along motions, WAIT, STOP, OVERRIDE; holds (WHEN … HALT) and, in one program of four, UNTIL,
/// BRAKE, JOG in every frame, another tool and a handler that moves, at random instants. The last
/// motion is exact.
RandomMotions random_motions(std::uint64_t seed, const MotionRobot& robot);

}  // namespace rob::test
