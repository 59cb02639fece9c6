#pragma once

namespace rob::motion {

/// One servo axis as its maker would describe it: kg or kg·m², N or Nm, m or rad.
/// The servo law computes its gains from it, a simulation integrates it.
struct DriveData {
  double inertia = 0;             ///< all that moves with the axis, motor included
  double viscous_friction = 0;    ///< N/(m/s) or Nm/(rad/s)
  double coulomb_friction = 0;    ///< N or Nm; the servo law does not know it
  double force_max = 0;           ///< N or Nm
  double encoder_resolution = 0;  ///< m or rad per count
  double bandwidth = 0;           ///< ω of the closed loop, rad/s
  double following_warn = 0;      ///< m or rad: limit at rest; see FollowingSupervisor
  double following_limit = 0;     ///< m or rad: limit at v_max
};

}  // namespace rob::motion
