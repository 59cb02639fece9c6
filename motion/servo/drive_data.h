#pragma once

#include <cstdint>

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

/// How much farther than at v_max an axis may have moved between two measurements: beyond that its
/// encoder has jumped (FollowingSupervisor). [choice] twice: an axis overshoots.
inline constexpr double kJumpMargin = 2;

/// The law that closes the loop of the axes, and what goes out to the drives.
enum class ServoStructure : std::uint8_t {
  Force,         ///< S2's law: forces (ServoLaw)
  PulseTrain,    ///< pulses of the reference; the drive counts them against its motor (PulseServo)
  PositionLoop,  ///< pulses out of one loop on the encoder's counts
  DoubleLoop     ///< S3: position loop outside, velocity loop inside, pulses out
};

/// A drive that is moved by pulses, one axis: its motor runs at their frequency as far as it can,
///
///     force = speed_stiffness·(rate of the pulses − q') + ripple·sin(2π·q/ripple_period)
///
/// with |force| <= force_max. The first part is a motor on a voltage proportional to the frequency:
/// what its speed induces works against it. The second is what the gear does, at equal places of
/// every turn (Tuttle, Seering: A nonlinear model of a harmonic drive gear transmission, 1996).
struct PulseDriveData {
  double pulse = 0;            ///< m or rad a pulse
  double speed_stiffness = 0;  ///< N/(m/s) or Nm/(rad/s) by which the motor lags
  double ripple = 0;           ///< N or Nm, amplitude; the servo does not know it
  double ripple_period = 1;    ///< m or rad
};

}  // namespace rob::motion
