#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <span>

#include "motion/servo/drive_data.h"
#include "motion/servo/servo_backend.h"
#include "motion/space/joint_vector.h"

namespace rob::motion {

/// |q − its nearest place between `from` and `to`|: how far a position is off a way. In the unit of
/// all three.
inline double off_way(double from, double to, double q) noexcept {
  return std::abs(q - std::clamp(q, std::min(from, to), std::max(from, to)));
}

/// The finding of the servo about the machine in one cycle. Fixed size; texts are made above.
struct FollowingFinding {
  enum class Verdict : std::uint8_t { None, Warn, Stop };
  enum class Cause : std::uint8_t {
    None,
    FollowingError,  ///< value: |q0 − q|; limit: the stop limit, also for a warning
    Frozen,      ///< value: way of the reference from q without a count; limit: the most allowed
    Jump,        ///< value: way since the last measurement that is not on the way to the goal;
                 ///< limit: what the axis can do
    NotFinite,   ///< a reference or a measurement is NaN or infinite
    Silent,      ///< value: cycles without an answer; limit: so many are too many
    Alarm,       ///< the machine itself has stopped
    Lost,        ///< the backend is gone
    Saturated,   ///< value: κ; limit: 1. The path is slowed down. Its task says so
    Noisy,       ///< value: share of what goes over its wire that is repeated. Its task says so
    Force,       ///< axis: 0, 1, 2 for x, y, z of the world; value, limit: N. Its task says so
    Insensible,  ///< value: s since the force sensor has reported anything new. Its task says so
    Overrun      ///< value: s without a servo cycle; limit: so long is too long. Its task says so
  };

  Verdict verdict = Verdict::None;
  Cause cause = Cause::None;
  int axis = -1;  ///< −1: the whole machine
  double value = 0;
  double limit = 0;
};

/// Does the machine do what is commanded, and can what it reports be true? m or rad, s.
///
/// *Following error*, as LinuxCNC's FERROR and MIN_FERROR: a cycle with |q0 − q| above
///
///     limit(v) = max(following_warn, following_limit·|q0'|/v_max)
///
/// is a stop, above half of it a warning. DriveData.following_warn is thus the limit at rest and at
/// low speed, DriveData.following_limit the one at v_max.
///
/// *Frozen*: q has not changed by a single count, in three cycles at least, while the reference
/// went away from it further than 20 counts + three times the way on which the servo overcomes
/// Coulomb friction (3·C/kp: a reversal takes two of them) + the way by which a loop lags where the
/// acceleration leaps, a_max/ω² but a quarter of following_warn at most. A reference that comes
/// back to an axis that lags it asks for no count. Because it is counted in way, not in time, no
/// slow motion can raise it. [choice] 20 counts: real encoders miss a few; three cycles: a drive
/// that answers late repeats itself once.
///
/// *Jump*: since the last measurement the axis has gone further than 2·v_max·(time since then, at
/// least T, and what is uncertain of both instants). Way that brings it nearer to its goal does not
/// count: after a late command a drive with a position loop of its own makes up its lag as fast as
/// it can, and that is no fault of the encoder. The limit of the following error bounds that lag.
///
/// *Silent*: the third answer in a row that did not come. *Alarm*, *Lost*: at once. Pending and
/// Late say nothing about the machine.
///
/// The gravest finding is reported, of equals that of the lowest axis, in every cycle in which it
/// holds: a jump once. Every call but the constructor may be used in the tick.
class FollowingSupervisor {
 public:
  static constexpr int kSilentCycles = 3;
  static constexpr int kFrozenCounts = 20;
  static constexpr int kFrozenCycles = 3;

  /// At most kMaxJoints drives.
  FollowingSupervisor(std::span<const DriveData> drives, const JointVector& v_max,
                      const JointVector& a_max, double servo_period);

  /// At enable: what is measured now is believed.
  void reset(const JointReference& reference, const JointMeasurement& measured) noexcept;

  /// Reference and measurement of the same instant; `goal`: the newest reference; `spread`: s by
  /// which the instant of an axis may be another. Unless `status` is Ok, `measured` is not looked
  /// at.
  FollowingFinding check(DriverStatus status, const JointReference& reference,
                         const JointVector& goal, const JointMeasurement& measured,
                         double spread = 0) noexcept;

 private:
  struct AxisWatch {
    double v_max = 0;
    double limit_at_rest = 0;
    double limit_at_v_max = 0;
    double frozen_way = 0;
    double q = 0;        // last measured
    double nearest = 0;  // |q0 − q|, the least since q last changed
    int unchanged = 0;   // cycles since then, as far as they count
  };

  FollowingFinding no_answer(DriverStatus status) noexcept;
  FollowingFinding check_axis(int i, double elapsed, double q, double goal,
                              const JointReference& reference) noexcept;
  static bool is_frozen(AxisWatch& axis, double q, double error) noexcept;

  std::array<AxisWatch, kMaxJoints> axes_;
  int count_;
  double servo_period_;
  double time_ = 0;  // of the last measurement
  double spread_ = 0;
  int silent_ = 0;
};

}  // namespace rob::motion
