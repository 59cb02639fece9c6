#pragma once

#include <Eigen/Core>

namespace rob::drivers {

/// An incremental encoder and the velocity estimate of the drive that counts it. m or rad, s.
///
/// Positions are whole counts. The velocity is that of a critically damped tracking filter over
/// samples taken every kPeriod (the fading-memory α-β filter, Morrison 1969):
///
///     r = count − (x + v·h);   x += v·h + (1 − p²)·r;   v += (1 − p)²·r/h;   p = exp(−ω·h)
///
/// Seen from outside it is the true velocity filtered by ω²/(s + ω)², that is 2/ω late.
/// Every call but the constructor may be used in the tick.
class Encoder {
 public:
  /// [choice] Twenty samples in a servo period of 5 ms; drives sample at 4 kHz and more.
  static constexpr double kPeriod = 250e-6;
  /// [choice] ω, rad/s: 3.3 ms late, which costs a loop of 40 rad/s some 10° of phase.
  static constexpr double kBandwidth = 600;

  /// The most samples that are taken at once.
  static constexpr int kBlock = 32;
  /// Positions at samples that follow each other.
  using Block = Eigen::Array<double, Eigen::Dynamic, 1, 0, kBlock, 1>;

  /// Counts of `resolution`, > 0.
  explicit Encoder(double resolution);

  double position(double q) const noexcept;
  void sample(double q) noexcept;
  /// As sample() of each of them in turn, but for rounding.
  void sample(const Block& q) noexcept;
  /// Whether further samples at q would change nothing.
  bool rests_at(double q) const noexcept { return v_ == 0 && x_ == position(q); }
  /// As if it had followed q, v for a long time.
  void settle(double q, double v) noexcept;
  double velocity() const noexcept { return v_; }

 private:
  /// How n samples change the state of the filter. The filter is linear in them.
  struct Response;
  static const Response& response() noexcept;

  double resolution_;
  double per_metre_;  ///< counts, or per rad
  double alpha_;
  double beta_;
  double x_ = 0;
  double v_ = 0;
};

}  // namespace rob::drivers
