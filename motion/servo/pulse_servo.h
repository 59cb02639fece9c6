#pragma once

#include <array>
#include <span>

#include "motion/servo/drive_data.h"
#include "motion/servo/servo.h"

namespace rob::motion {

/// The gains of one axis under PulseServo, 1/s, 1, 1/s.
struct PulseGains {
  double kp = 0;  ///< of the position loop
  double kv = 0;  ///< of the velocity loop inside
  double ki = 0;
};

/// For a drive whose speed follows its pulses with the time constant τ = J/(D + Dc); J inertia, D
/// speed_stiffness, Dc viscous friction.
///
/// *PositionLoop*, and the counter inside a drive under PulseTrain: critically damped,
/// kp = (1 + Dc/D)/(4τ). There is no more in one loop around such a motor.
///
/// *DoubleLoop*: the velocity loop's pole at −ω_v: kv = (ω_v·J − Dc)/D − 1, at least 0; around it
/// kp = ω_v/4, and the velocity's integral works at half of that, ki = (1 + kv)·kp/2.
/// ω_v = min(4·bandwidth, 0.4/T). [choice] A quarter: a loop outside leaves the one inside its
/// time; 0.4 rad of phase, with as much again in the encoder's estimate, leave 60° of it.
PulseGains pulse_gains(const DriveData& drive, const PulseDriveData& pulses,
                       ServoStructure structure, double servo_period);

/// S3's servo: it counts the edges of encoders and sends pulses. Every cycle, for the next:
///
///     PulseTrain     v = q0' + (q0 − what has been sent)/T          no feedback
///     PositionLoop   v = q0'·(1 + Dc/D) + kp·(q0 − q)
///     DoubleLoop     v* = q0' + kp·(q0 − q)                         position loop outside,
///                    v  = v* + kv·(v* − q') + ki·∫(v* − q')dt       velocity loop inside
///
/// Pulses = v·T/pulse, whole ones; the rest waits for the next cycle, so that none is lost. The
/// loops ask for no more than the motor has, |v − q'| <= force_max/D; beyond that the integral
/// stands still. S3 compares three structures without their formulas: [choice] these are what a
/// controller with a pulse board, an encoder board, and both can do. An axis whose values are not
/// finite gets no pulses.
/// Every call but the constructor may be used in the tick.
class PulseServo final : public Servo {
 public:
  /// As many drives as pulse drives, at most kMaxJoints; servo_period in s; not Force.
  PulseServo(std::span<const DriveData> drives, std::span<const PulseDriveData> pulses,
             ServoStructure structure, double servo_period);

  void reset(double now) noexcept override;
  JointVector update(double now, const JointReference& reference,
                     const JointMeasurement& measured) noexcept override;
  /// κ = max |v − q'|·D/force_max; under PulseTrain nobody knows it: 0.
  double take_saturation() noexcept override;

 private:
  struct AxisLoop {
    PulseGains gains;
    double pulse = 1;
    double reach = 0;  ///< force_max/D
    double feed = 1;   ///< 1 + Dc/D
    double integral = 0;
    double sent = 0;  ///< where the pulses so far, and the rest, would bring the axis
    double rest = 0;  ///< of a pulse
  };

  double rate(AxisLoop& axis, double elapsed, double position_error, double reference_rate,
              double measured_rate) noexcept;
  static double whole_pulses(AxisLoop& axis, double way) noexcept;

  std::array<AxisLoop, kMaxJoints> axes_;
  int count_;
  ServoStructure structure_;
  double period_;
  double time_ = 0;
  bool begun_ = false;
  double saturation_ = 0;
};

}  // namespace rob::motion
