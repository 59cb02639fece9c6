#pragma once

#include <cstdint>

#include "motion/robots/robot_model.h"

namespace rob::motion {

/// A capability that a robot's law of motion may have or not.
enum class Capability : std::uint8_t {
  AccelerationBound,  ///< of a single motion
  JerkBound,
  Path,       ///< many motions planned as one
  Force,      ///< a force kept along an axis
  Lead,       ///< its tool led along a way in space, or to a pose
  TurnAboutZ  ///< of its tool: what FREE leaves open
};

/// Whether motions of this robot have it, under its law. Under Paul's (S1) time alone says how fast
/// motions begin and end.
bool can(const RobotModel& robot, Capability capability) noexcept;

/// Whether it can be run under that law: Paul's needs a t_acc, the look-ahead law nothing.
bool can(const RobotModel& robot, Law law) noexcept;

}  // namespace rob::motion
