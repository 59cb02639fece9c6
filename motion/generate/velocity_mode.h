#pragma once

#include <array>
#include <cstdint>

#include "motion/collision/jog_room.h"
#include "motion/generate/jog_space.h"
#include "motion/robots/robot_model.h"

namespace rob::motion {

/// The limit that keeps a jog from going as fast as it is asked to.
struct JogLimit {
  enum class Kind : std::uint8_t {
    None,
    Share,         ///< AT: a share of the axes' speeds, a speed of the tool
    Speed,         ///< of the axis
    Acceleration,  ///< of the axis: near a singular place
    End,           ///< the axis is near the end of its way
    Reach,         ///< the arm does not reach further, or would have to jump
    Body           ///< two bodies would come too near; `axis`: what JogRoom::stops() says
  };

  Kind kind = Kind::None;
  int axis = -1;
};

/// Motion at given rates (S2's velocity modes): from any state, period by period, towards the rates
/// that were asked for last.
///
/// Rates change all together (rate_change()), within what every axis may accelerate and jerk, and
/// what a former change has left beside the direction of the current one is taken back; where
/// the tool moves, so does it straight in its space. No step is taken from which the jog could not
/// come to rest with every axis within its way, speed, acceleration and jerk: that rest is tried
/// beforehand, and where it is not possible smaller rates in the same direction are. Where none of
/// the few that are tried in a period is possible, the rest after the step before is gone on
/// with: so the work of a period is bounded. Neither the step nor that rest moves the tool faster
/// than the rates that were asked for and AT permit. A jog slows down before the end of an axis,
/// the border of its reach and singular places, stands still short of them, and goes wherever they
/// are not: each axis alone always back.
///
///     asked        ____              slower as long as an axis could not
///     made     ___/    ╲______       follow, or not be stopped in time
///
/// An axis beyond its limits at the beginning may go back, and no further out. SI. Every call but
/// the constructor may be used in the tick.
class VelocityMode {
 public:
  explicit VelocityMode(const RobotModel& robot);

  /// From here on no step is taken from which it could not come to rest within that room.
  void keep_to(const JogRoom& room) noexcept { room_ = &room; }
  /// At rest at q, with nothing asked.
  void stand_at(const JointVector& q) noexcept;
  /// Whether the rates can be asked for now: at rest any, else those of the same space and tool.
  bool takes(const JogRates& rates) const noexcept;
  /// Asks for rates that it takes. They hold until others are asked for.
  void aim(const JogRates& rates) noexcept;
  /// One period on, towards a share of them, 0 … 1; with 0 it comes to rest.
  void step(double share) noexcept;

  bool stands() const noexcept { return at_rest(state_); }
  /// Its time is the caller's.
  const JointReference& reference() const noexcept { return state_.axes; }
  /// The limit of the last step: what kept it, and what share of the rates asked for could be aimed
  /// at.
  const JogLimit& limit() const noexcept { return limit_; }
  double granted() const noexcept { return granted_; }
  /// It hardly goes on, though axes and tool are fast enough for what was asked; JogLimit says why.
  /// [choice] below a thirtieth it is hardly seen to move
  bool stopped() const noexcept {
    const bool waits = limit_.kind == JogLimit::Kind::Body && limit_.axis == JogRoom::kUnknown;
    return broken_off_ || (granted_ * 30 < affordable_ && !waits);
  }

 private:
  using State = JogState;

  static bool at_rest(const State& state) noexcept;
  bool find_step(double share, const JointVector& asked) noexcept;
  bool go_on_to_rest() noexcept;
  double greatest_share(const JointVector& asked) noexcept;
  JogLimit go(const State& from, double share, const JointVector& asked, double time,
              State& to) const noexcept;
  bool bounds_tool() const noexcept;
  JogSpeed permitted(const State& at) const noexcept;
  void keep_former() noexcept;
  bool too_fast(const State& from, const State& to, double time, JogSpeed& peak) const noexcept;
  JointVector next_acceleration(const State& from, const JointVector& missing,
                                const JointVector& of_axes, double time) const noexcept;
  JogPlace moved(const State& from, const State& to, double time) const noexcept;
  bool follow(const JointVector& near, State& state) const noexcept;
  JogLimit judge(const JointReference& from, const JointReference& to, double time) const noexcept;
  bool leaves_reach(const JointVector& from, const JointVector& to) const noexcept;
  JogLimit try_rest(State state, int& steps, JogSpeed& peak) const noexcept;
  void brake_axes() noexcept;

  const double period_;
  const int periods_a_rest_step_;
  const JointVector least_, most_, v_max_, a_max_, j_max_;  ///< of the axes
  std::array<bool, kMaxJoints> rotary_{};
  JointVector low_, high_;  ///< least_ and most_, or further, where the jog began beyond them
  const JogRoom* room_ = nullptr;
  JogSpace space_;
  JogRates asked_;
  State state_;
  State rest_begin_, rest_end_;  ///< of the step of a rest that state_ is in
  int rest_periods_ = 0;         ///< of it, since its beginning; 0: in none
  JogLimit limit_;
  double granted_ = 1;
  bool broken_off_ = false;  ///< the rates were given up, until others are asked for
  double blocked_ = 0;       ///< it stands, and this share of the rates does not let it go on
  double override_ = 1;      ///< of the rates, and of what AT permits the tool
  JogSpeed former_;        ///< permitted before what is asked for now; 0: it has come down to that
  double affordable_ = 0;  ///< share of the rates that speeds alone permit here; 0: nothing asked
};

}  // namespace rob::motion
