#pragma once

#include "drivers/contact/plane_contact.h"

namespace rob::drivers {

/// A hole for tubes, seen by the middle of a tube's lower end: where that can go. SI.
struct Hole {
  Eigen::Vector3d mouth = Eigen::Vector3d::Zero();  ///< its middle, at the height of the face
  double depth = 0;
  double clearance = 0;  ///< radius of the hole less that of the tube
  double chamfer = 0;    ///< of the edge, at 45°

  double bottom() const noexcept { return mouth.z() - depth; }
  /// How far a place is beside the hole's axis.
  double beside(const Eigen::Vector3d& place) const noexcept {
    return (place - mouth).head<2>().norm();
  }
  bool over_mouth(const Eigen::Vector3d& place) const noexcept {
    return beside(place) < clearance + chamfer;
  }
};

/// The lower end of a tube that the tool carries.
struct Foot {
  Eigen::Vector3d place = Eigen::Vector3d::Zero();
  /// It has stood on the face, tilted by what held it there, and has to right itself as it sinks.
  bool tilted = false;
};

/// How a tilted tube sinks: by itself with `speed`, and faster by pressing force over resistance.
struct Sinking {
  /// m that it sinks until it stands upright. [choice] 1 mm, the clearance that lets it tilt.
  static constexpr double kNeck = 1e-3;

  double speed = 0;       ///< m/s
  double resistance = 0;  ///< N·s/m
};

/// Carries a tube's foot for `dt` over the face around a hole, over its edge, into it and down to
/// its bottom: pressed on the face until its middle is over the mouth; then it slides down the
/// chamfer, and from there it is led by the wall, which holds it within the clearance. Returns the
/// force of the rack on the tube. May be used in the tick.
Pressed carry_into(const Hole& hole, const Carried& carried, Foot& foot, double dt,
                   const ContactLaw& law, const Sinking& sinking) noexcept;

}  // namespace rob::drivers
