#pragma once

#include <cmath>
#include <cstdint>

#include "drivers/sim/encoder.h"
#include "motion/servo/drive_data.h"

namespace rob::drivers {

/// One simulated servo axis under a constant force: m·v' = u − b·v − C·sign(v). SI.
///
/// Solved in closed form, so that a step may have any length and standstill is exact. At rest it
/// stays at rest until |u| > C; when friction stops it inside a step, that instant is solved for.
/// Every call but the constructor may be used in the tick.
class SimAxis {
 public:
  explicit SimAxis(const motion::DriveData& drive);

  /// Stands at q without force.
  void place(double q) noexcept;

  /// Force from now on, limited to what the motor has; one that is not finite counts as none.
  void push(double force) noexcept;
  /// The drive brakes with all its force until the axis stands, and then holds it.
  void hold() noexcept;
  void release() noexcept { push(0); }

  void advance(double dt) noexcept;
  /// `count` whole periods of the encoder, with a sample at the end of each. In one step unless the
  /// speed passes 0, otherwise one by one; the results differ by rounding only.
  void advance_sampled(std::int64_t count) noexcept;
  /// The encoder's sample, every Encoder::kPeriod.
  void sample() noexcept { encoder_.sample(q_); }
  /// After a time in which no samples were taken.
  void settle() noexcept { encoder_.settle(q_, v_); }

  double q() const noexcept { return q_; }
  double v() const noexcept { return v_; }
  double measured_q() const noexcept { return encoder_.position(q_); }
  double measured_v() const noexcept { return encoder_.velocity(); }

 private:
  double resistance() const noexcept;
  void note_step(double dt) noexcept;
  bool stands() const noexcept { return v_ == 0 && std::abs(u_) <= resistance(); }
  double direction() const noexcept { return std::copysign(1.0, v_ != 0 ? v_ : u_); }
  bool pass_samples(int count) noexcept;

  motion::DriveData drive_;
  Encoder encoder_;
  double q_ = 0;
  double v_ = 0;
  double u_ = 0;
  bool holding_ = false;
  /// After each of so many periods: q + v·times_ + a·ways_, v + a·gains_.
  Encoder::Block times_;
  Encoder::Block ways_;
  Encoder::Block gains_;
  double step_ = 0;  ///< s, of the last advance(), and the φ of it
  double step_phi1_ = 1;
  double step_phi2_ = 0.5;
};

}  // namespace rob::drivers
