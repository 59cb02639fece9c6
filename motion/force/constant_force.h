#pragma once

#include <array>
#include <cmath>
#include <cstddef>

namespace rob::motion {

/// The known data of the contact that a force is kept on. SI.
struct PressContact {
  double stiffness = 0;     ///< N/m, the greatest that may be met
  double delay = 0;         ///< s from what acts to what is reported
  double period = 0;        ///< s of a step
  double acceleration = 0;  ///< m/s² that the motion along the axis may take
  double jerk = 0;          ///< m/s³, the same

  /// s from what acts to what is done about it, of small changes: a speed of v comes √(v/jerk)
  /// late; [choice] of 0.05 mm/s.
  double late() const noexcept { return delay + period + std::sqrt(5e-5 / jerk); }
  /// m/s at which what is gone before it is felt, and while the speed is taken back, presses with
  /// no more than `force`, N: k·v·(late + √(v/jerk)) with v = 1 mm/s in the root, which is S4's.
  double seek_speed(double force) const noexcept {
    return std::abs(force) / (stiffness * (delay + period + std::sqrt(1e-3 / jerk)));
  }
};

/// Motion along one axis that keeps the reaction of the world on it at a set-point:
///
///     v = −(Kp·e + Ki·∫e)      e = set-point − felt      Kp = 0.3/(k·T_d)      Ki = Kp/(8·T_d)
///
/// with T_d the sensor's delay, one period and what the jerk takes of it (late()), k the stiffness:
/// a phase margin of 50°, reached for any k between a third and one and a half of the true one. k
/// is learned from what the first newtons take: the line through felt against way, as late as the
/// samples fit best to, for the delay is known as a bound alone; until then it is the greatest.
/// Where nothing is felt the axis moves on at the speed with which what is gone within T_d presses
/// with no more than the set-point, and nothing is integrated.
///
/// Speed is limited to what was asked for, with the integral frozen meanwhile, and changes within
/// acceleration and jerk. Every call may be used in the tick.
class ConstantForce {
 public:
  explicit ConstantForce(const PressContact& contact) noexcept : contact_(contact) {}

  /// From rest. N along the axis, not 0; m/s, above 0.
  void begin(double force, double most_speed) noexcept;
  /// One period on, in which `felt` is what the sensor reports, N along the axis.
  void step(double felt) noexcept;
  /// One period on towards standstill.
  void brake() noexcept;

  /// Since begin(), m, m/s, m/s² along the axis.
  double way() const noexcept { return way_; }
  double rate() const noexcept { return rate_; }
  double acceleration() const noexcept { return acceleration_; }
  const PressContact& contact() const noexcept { return contact_; }
  /// N/m: learned, or the greatest.
  double stiffness() const noexcept { return stiffness_; }
  /// The force has been near the set-point for some time, at least once.
  bool settled() const noexcept { return settled_; }

 private:
  void learn(double felt) noexcept;
  void judge(double error) noexcept;
  void go(double rate) noexcept;

  /// Felt against way, in sums about the first sample.
  struct Line {
    int count = 0;
    double x0 = 0, y0 = 0;
    double x = 0, y = 0, xx = 0, xy = 0, yy = 0;

    void add(double way, double felt) noexcept;
    double slope() const noexcept;   ///< N/m; 0 where the way does not change
    double misfit() const noexcept;  ///< N²: mean square beside the line
  };

  static constexpr std::size_t kKept = 64;  ///< of ways: a delay of 64 periods

  const PressContact contact_;
  double force_ = 0;
  double most_ = 0;
  double stiffness_ = 0;
  double integral_ = 0;  ///< N·s
  double way_ = 0;
  double rate_ = 0;
  double acceleration_ = 0;
  std::array<double, kKept> ways_{};
  std::size_t steps_ = 0;
  std::array<Line, kKept> lines_{};  ///< for each delay in periods
  bool learned_ = false;
  double mean_error_ = 0;
  double near_ = 0;  ///< s
  bool settled_ = false;
};

}  // namespace rob::motion
