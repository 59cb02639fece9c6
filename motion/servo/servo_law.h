#pragma once

#include <array>
#include <optional>
#include <span>

#include "motion/servo/drive_data.h"
#include "motion/servo/feed_forward.h"
#include "motion/servo/servo.h"
#include "motion/space/joint_vector.h"

namespace rob::motion {

/// The gains of one axis: N/m, N/(m/s), N/(m·s), or Nm and rad.
struct ServoGains {
  double kp = 0;
  double kv = 0;
  double ki = 0;
};

/// Both error poles at −ω: kp = ω²·H, kv = 2ω·H − Dc, with H the inertia and Dc the viscous
/// friction, which damps already; kI = 0.1·ω·kp is slow against them.
ServoGains servo_gains(double omega, double inertia, double viscous_friction) noexcept;
/// ω = min(drive.bandwidth, 0.2/T), rad/s: a sampled loop with an estimated velocity has no phase
/// for more.
double servo_bandwidth(const DriveData& drive, double servo_period);
/// With that, and the drive's own inertia.
ServoGains servo_gains(const DriveData& drive, double servo_period);

/// S2's servo law: feed-forward plus PID, N or Nm.
///
///     u  = u0 + kp·(q0 − q) + kv·(q0' − q') + kI·e,   |u| <= force_max
///     e  = e + (q0 − q)·(time really elapsed),        |kI·e| <= force_max/2
///
/// Where the load changes, e is set so that the integral keeps its force, less what it has learned
/// of the new weight before it was reported: that is in u0 now.
///
/// u0 is FeedForward's; Coulomb friction is left to e. With an arm's mechanics the gains vary with
/// its posture, as Da·H_ii + Db does; otherwise the axes are decoupled and the gains constant.
/// e stands still while u is limited. An axis whose values are not finite gets no force.
/// Every call but the constructor may be used in the tick.
class ServoLaw final : public Servo {
 public:
  /// At most kMaxJoints drives; servo_period in s.
  ServoLaw(std::span<const DriveData> drives, double servo_period,
           const std::optional<ArmMechanics>& arm = std::nullopt);

  /// To be compared with: from now on without u0.
  void leave_out_feed_forward() noexcept { feeds_forward_ = false; }

  void reset(double now) noexcept override;
  void carry(const ArmLoad& load) noexcept override;
  JointVector update(double now, const JointReference& reference,
                     const JointMeasurement& measured) noexcept override;
  /// κ = max |u before limiting|/force_max, or |P|/P_max of the gears.
  double take_saturation() noexcept override;

 private:
  struct AxisLaw {
    DriveData drive;
    double omega = 0;
    double e = 0;
  };
  void preset_integrals(const JointVector& q) noexcept;
  double axis_force(AxisLaw& axis, const ServoGains& gains, double elapsed, double feed_forward,
                    double position_error, double velocity_error) noexcept;

  FeedForward feed_forward_;
  bool feeds_forward_ = true;
  std::array<AxisLaw, kMaxJoints> axes_;
  int count_;
  double time_ = 0;
  double saturation_ = 0;
  std::optional<ArmLoad> told_;  ///< what the next update() begins with
};

}  // namespace rob::motion
