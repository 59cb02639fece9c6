#pragma once

#include "base/motion_clauses.h"

namespace rob::motion {

using rob::Profile;

/// A motion from rest to rest over the share 0 … 1 of its way: a pulse of acceleration, a cruise,
/// the pulse mirrored.
///
///     s''  __
///         /  \            pulse of peak A and length t_a, whose shape has the name;
///     ___/    \____       k = 1, 4/3, 3/2, 2 is A over its mean:  t_a = k·v/A
///                  \  /
///
/// Trapezoidal: its ramps are a quarter of t_a each. 1, s. Every call may be used in the tick.
class ProfileLaw {
 public:
  struct Point {
    double share = 0;
    double rate = 0;          ///< 1/s
    double acceleration = 0;  ///< 1/s²
  };

  ProfileLaw() = default;
  /// As fast as `rate` and the peak `acceleration` allow, above 0, but not before `at_least`: then
  /// slower.
  ProfileLaw(Profile shape, double rate, double acceleration, double at_least) noexcept;
  /// The same with its acceleration so low that the jerk is at most `jerk`, 1/s³, above 0. No bound
  /// makes a rectangular pulse keep it.
  static ProfileLaw within_jerk(Profile shape, double rate, double acceleration, double jerk,
                                double at_least) noexcept;

  /// The same, run at a share of its speed.
  ProfileLaw slowed(double share) const noexcept;

  bool present() const noexcept { return shape_ != Profile::Unspecified; }
  double duration() const noexcept { return duration_; }
  /// The greatest, 1/s³.
  double jerk() const noexcept;
  /// 0 <= t <= duration().
  Point at(double t) const noexcept;
  /// When that share is reached.
  double time_at(double share) const noexcept;

 private:
  Point rising(double t) const noexcept;

  Profile shape_ = Profile::Unspecified;
  double rate_ = 0;   ///< of the cruise
  double pulse_ = 0;  ///< t_a
  double duration_ = 0;
};

}  // namespace rob::motion
