#include "motion/generate/velocity_mode.h"

#include <algorithm>
#include <cmath>

#include "motion/generate/rate_change.h"

namespace rob::motion {

namespace {

using Limit = JogLimit::Kind;

/// Relative: what rounding and differences of inverse solutions add.
constexpr double kRounding = 1e-6;
constexpr double kSamePlace = 1e-9;  // m, rad
constexpr double kNoRate = 1e-12;    // m/s, rad/s: what rounding leaves of a rest

/// s between the inverse solutions whose differences are speed and acceleration of the axes.
/// [choice] their rounding, 1e-15, makes 2e-8 rad/s² of it; what the axes' jerk changes, 1e-5.
constexpr double kInstant = 0x1p-11;

/// rad. [choice] an arm of 1 m is 10 µm from its reach there
constexpr double kStretched = 0.01;

/// Share of acceleration and jerk that rates of the tool may take; the rest is for what its
/// straight way asks of the axes. [choice] at full speed of an arm about a third.
constexpr double kForCurvature = 0.7;

/// Share of rates, or of what an acceleration makes of them in a step, that is nothing beside them.
/// [choice] far above rounding
constexpr double kBeside = 1e-6;

/// s: a step of a rest is a period, or as many together as this holds. [choice] A tenth of what it
/// takes an arm to reach its full acceleration, so that a robot at 1 kHz can work out a rest, too.
constexpr double kRestStep = 0.004;
/// The share of acceleration and jerk at the ends of a step of several periods that a motion of the
/// tool may ask at most; the rest is for what lies between. [choice] 0.9 was a fifth too much
/// beside singular places, in steps of 8 ms.
constexpr double kForBetween = 0.8;
/// Steps of rests that are worked out in a period: its work is bounded. [choice] twice what the
/// longest rest takes
constexpr int kMostSteps = 120;

/// Shares of the rates that are tried in a period, as parts of what was granted in the one before;
/// the first at least kLittle, so that it begins again; none lies above what speeds permit. From
/// rest, where nothing else is left to do: parts of that. [choice] Among several, those that led
/// random jogs as far as a closer search did. A rate that leaps by a factor is smoothed by the
/// axes' jerk.
constexpr std::array kAgain = {4.0, 1.5, 0.5};
constexpr double kLittle = 1.0 / 64;
constexpr std::array kFromRest = {1.0, 1.0 / 8, kLittle};
/// Where they would make the tool too fast, parts of what speeds permit instead. [choice] The tool
/// is too fast by some percent at most; of what falls back farther a hand that keeps a force with
/// its jogs loses it (docs/performance.md).
constexpr std::array kSlower = {1.0, 0.98, 0.9, 0.6};
/// Where none is possible the next are sought about this part.
constexpr double kLess = 0.8;

/// s before the tool would be too fast in which a jog slows down. [choice] the time in which an arm
/// brings its acceleration to a half
constexpr double kSoon = 0.05;

constexpr double square(double x) noexcept { return x * x; }

template <typename Get>
JointVector of_axes(const RobotModel& robot, Get get) {
  JointVector values(robot.axis_count());
  for (int i = 0; i < robot.axis_count(); ++i) {
    values[i] = get(robot.axes[static_cast<std::size_t>(i)]);
  }
  return values;
}

}  // namespace

VelocityMode::VelocityMode(const RobotModel& robot)
    : period_(robot.reference_period),
      periods_a_rest_step_(std::max(1, static_cast<int>(kRestStep / period_ + kRounding))),
      least_(of_axes(robot, [](const Axis& axis) { return axis.min; })),
      most_(of_axes(robot, [](const Axis& axis) { return axis.max; })),
      v_max_(of_axes(robot, [](const Axis& axis) { return axis.v_max; })),
      a_max_(of_axes(robot, [](const Axis& axis) { return axis.a_max; })),
      j_max_(of_axes(robot, [](const Axis& axis) { return axis.j_max; })),
      space_(robot.kinematics.get()) {
  for (std::size_t i = 0; i < robot.axes.size(); ++i) {
    rotary_[i] = robot.axes[i].kind == AxisKind::Rotary;
  }
  stand_at(robot.start);
}

void VelocityMode::stand_at(const JointVector& q) noexcept {
  const JointVector none = JointVector::Zero(q.size());
  state_.axes = {0, q, none, none};
  asked_ = {};
  asked_.space = JogRates::Space::Joint;
  asked_.rate = none;
  state_.place = space_.enter(asked_, q);
  state_.rate = state_.acceleration = none;
  rest_periods_ = 0;
  former_ = {};
}

bool VelocityMode::takes(const JogRates& rates) const noexcept {
  return stands() || space_.same_as(rates);
}

void VelocityMode::aim(const JogRates& rates) noexcept {
  keep_former();
  if (asked_.rate.size() != rates.rate.size() || asked_.rate != rates.rate) granted_ = 1;
  asked_ = rates;
  blocked_ = 0;
  broken_off_ = false;
  if (!stands()) return;
  // An end moves with what stands beyond it, but not with what rounding has led there.
  const JointVector rounding = JointVector::Constant(state_.axes.q.size(), kSamePlace);
  low_ = least_.cwiseMin(state_.axes.q + rounding);
  high_ = most_.cwiseMax(state_.axes.q - rounding);
  if (!space_.same_as(rates)) state_.place = space_.enter(rates, state_.axes.q);
  state_.rate = state_.acceleration = JointVector::Zero(rates.rate.size());
}

bool VelocityMode::at_rest(const State& state) noexcept {
  return state.rate.isZero(0) && state.acceleration.isZero(0);
}

void VelocityMode::step(double share) noexcept {
  if (stands() && share > 0 && share == blocked_) return;  // nothing has changed
  blocked_ = 0;
  limit_ = {};
  affordable_ = 0;
  if (share < override_) keep_former();
  override_ = share;
  if (stands() && !(share > 0)) return;
  const auto asked = share > 0 ? space_.image(state_, asked_.rate) : std::nullopt;
  if (share > 0 && !asked) {
    limit_ = {Limit::Reach, -1};
    affordable_ = 1;
  }
  if (asked && find_step(share, *asked)) return;
  if (stands()) {
    granted_ = 0;
    if (limit_.kind != Limit::Body) blocked_ = share;  // bodies are measured anew
    return;
  }
  if (share > 0) granted_ = asked ? granted_ * kLess : 0;
  if (!go_on_to_rest()) brake_axes();
}

/// The step towards as much of the rates as still lets it come to rest afterwards.
bool VelocityMode::find_step(double share, const JointVector& asked) noexcept {
  affordable_ = greatest_share(asked);
  int steps = kMostSteps;
  double tried = -1;
  bool fast = false;
  for (std::size_t i = 0; i < (fast ? kSlower.size() : kAgain.size()) && steps > 0; ++i) {
    double granted = fast       ? affordable_ * kSlower[i]
                     : stands() ? affordable_ * kFromRest[i]
                                : granted_ * kAgain[i];
    granted = std::clamp(granted, i == 0 ? affordable_ * kLittle : 0, affordable_);
    if (granted == tried) continue;
    tried = granted;
    State next;
    JogSpeed peak;
    JogLimit limit = go(state_, share * granted, asked, period_, next);
    if (limit.kind == Limit::None) limit = try_rest(next, steps, peak);
    if (limit.kind == Limit::None) {
      state_ = next;
      if (bounds_tool() && peak.within(permitted(next))) former_ = {};
      rest_periods_ = 0;
      granted_ = granted;
      return true;
    }
    if (i > 0) continue;
    limit_ = limit;
    fast = limit.kind == Limit::Share && !stands();
  }
  return false;
}

/// One period on along the rest that was found possible after the last step.
bool VelocityMode::go_on_to_rest() noexcept {
  if (rest_periods_ == 0) {
    rest_begin_ = state_;
    const JointVector none = JointVector::Zero(state_.axes.q.size());
    const double time = period_ * periods_a_rest_step_;
    if (go(state_, 0, none, time, rest_end_).kind == Limit::Reach) return false;
  }
  if (++rest_periods_ == periods_a_rest_step_) {
    rest_periods_ = 0;
    state_ = rest_end_;
    return true;
  }
  const JointVector near = state_.axes.q + state_.axes.qd * period_;
  const double time = period_ * rest_periods_;
  State next;
  next.acceleration =
      rest_begin_.acceleration + (rest_end_.acceleration - rest_begin_.acceleration) *
                                     (static_cast<double>(rest_periods_) / periods_a_rest_step_);
  next.rate = rest_begin_.rate + (rest_begin_.acceleration + next.acceleration) * (time / 2);
  next.place = moved(rest_begin_, next, time);
  if (!follow(near, next)) return false;
  state_ = next;
  return true;
}

/// At constant jerk.
JogPlace VelocityMode::moved(const State& from, const State& to, double time) const noexcept {
  const JointVector bend = from.acceleration * 2 + to.acceleration;
  return space_.moved(from.place, from.rate * time + bend * (time * time / 6));
}

/// The share of the rates, so that no axis becomes too fast here, nor the tool.
double VelocityMode::greatest_share(const JointVector& asked) noexcept {
  double share = 1;
  const auto bound = [&](double speed, double most, JogLimit limit) noexcept {
    if (!(std::abs(speed) * share > most * (1 + kRounding))) return;
    share = most / std::abs(speed);
    limit_ = limit;
  };
  for (int i = 0; i < asked.size(); ++i) {
    bound(asked[i], v_max_[i] * asked_.share, {asked_.share < 1 ? Limit::Share : Limit::Speed, i});
    const bool turns = space_.joint() && rotary_[static_cast<std::size_t>(i)];
    if (turns) bound(asked[i], asked_.turning_speed, {Limit::Share, i});
  }
  if (asked_.tool_speed == JogRates::kAny && asked_.turning_speed == JogRates::kAny) return share;
  const auto bound_tool = [&](const State& at) noexcept {
    const JogSpeed speed = space_.speed(at, asked_.rate);
    bound(speed.linear, asked_.tool_speed, {Limit::Share, -1});
    if (!space_.joint()) bound(speed.angular, asked_.turning_speed, {Limit::Share, -1});
  };
  bound_tool(state_);
  // The same where its motion leads soon: it must have slowed down by then.
  State soon = state_;
  soon.place = space_.moved(state_.place, state_.rate * kSoon);
  soon.axes.q += state_.axes.qd * kSoon;
  bound_tool(soon);
  return share;
}

/// A step of some time, towards a share of the asked rates, which make `asked` of the axes.
JogLimit VelocityMode::go(const State& from, double share, const JointVector& asked, double time,
                          State& to) const noexcept {
  const JointVector missing = asked_.rate * share - from.rate;
  to.acceleration = next_acceleration(from, missing, asked * share - from.axes.qd, time);
  to.rate = from.rate + (from.acceleration + to.acceleration) * (time / 2);
  if (share == 0 && to.rate.cwiseAbs().maxCoeff() < kNoRate &&
      to.acceleration.cwiseAbs().maxCoeff() < kNoRate / time) {
    to.rate.setZero();
    to.acceleration.setZero();
  }
  to.place = moved(from, to, time);
  const JointVector near = from.axes.q + from.axes.qd * time + from.axes.qdd * (time * time / 2);
  if (!follow(near, to) || leaves_reach(from.axes.q, to.axes.q)) return {Limit::Reach, -1};
  const JogLimit limit = judge(from.axes, to.axes, time);
  if (limit.kind != Limit::None || room_ == nullptr) return limit;
  const int pair = room_->stops(to.axes.q);
  return pair == JogRoom::kFree ? limit : JogLimit{Limit::Body, pair};
}

/// The acceleration of the rates. Its part that does not lie along what is missing would last as
/// long as that does, and lead the tool aside: half of the jerk takes it back at once. `of_axes`:
/// what is missing, as the axes feel it.
JointVector VelocityMode::next_acceleration(const State& from, const JointVector& missing,
                                            const JointVector& of_axes,
                                            double time) const noexcept {
  const double usable = space_.joint() ? 1 : kForCurvature;
  const double square = missing.squaredNorm();
  const double along = square > 0 ? from.acceleration.dot(missing) / square : 0;
  const JointVector beside = from.acceleration - missing * along;
  const JointVector a_max = a_max_ * usable;
  const JointVector j_max = j_max_ * usable;
  const double way = missing.norm();
  const double bent = from.acceleration.norm() * time;
  const bool directed = way > std::max(kBeside * bent, kNoRate);
  if (!directed || beside.norm() * time <= kBeside * std::max(bent, way)) {
    const JointVector felt = directed ? JointVector(of_axes * along) : from.axes.qdd;
    const RateChange change = rate_change(of_axes, felt, a_max, j_max, time);
    return missing * change.of_missing + from.acceleration * change.of_acceleration;
  }
  const JointVector felt = from.axes.qdd - of_axes * along;
  const JointVector left = (a_max - felt.cwiseAbs()).cwiseMax(a_max / 4);
  const RateChange change = rate_change(of_axes, of_axes * along, left, j_max / 2, time);
  const double most = felt.cwiseQuotient(j_max).cwiseAbs().maxCoeff() / time;
  const double kept = most > 0.5 ? 1 - 0.5 / most : 0;
  return missing * (change.of_missing + along * change.of_acceleration) + beside * kept;
}

/// The axes, their speed and acceleration for the place of a state and how it moves.
bool VelocityMode::follow(const JointVector& near, State& state) const noexcept {
  const auto q = space_.axes(state.place, near);
  if (!q) return false;
  state.axes.q = *q;
  if (space_.joint() || at_rest(state)) {
    const JointVector none = JointVector::Zero(q->size());
    state.axes.qd = space_.joint() ? state.rate : none;
    state.axes.qdd = space_.joint() ? state.acceleration : none;
    return true;
  }
  const JointVector way = state.rate * kInstant;
  const JointVector bend = state.acceleration * (kInstant * kInstant / 2);
  const auto ahead = space_.axes(space_.moved(state.place, bend + way), *q);
  const auto behind = space_.axes(space_.moved(state.place, bend - way), *q);
  if (!ahead || !behind) return false;
  state.axes.qd = (*ahead - *behind) / (2 * kInstant);
  state.axes.qdd = (*ahead - *q * 2 + *behind) / (kInstant * kInstant);
  return true;
}

bool VelocityMode::bounds_tool() const noexcept {
  return !space_.joint() || asked_.tool_speed != JogRates::kAny;
}

/// How fast rates, AT and the override let the tool be in a state.
JogSpeed VelocityMode::permitted(const State& at) const noexcept {
  if (space_.joint()) return {override_ * asked_.tool_speed, JogRates::kAny};
  const JogSpeed asked = space_.speed(at, asked_.rate);
  return {override_ * std::min(asked.linear, asked_.tool_speed),
          override_ * std::min(asked.angular, asked_.turning_speed)};
}

/// Called before the rates change. Until the tool has slowed down to the new rates, the old ones
/// bound its speed.
void VelocityMode::keep_former() noexcept {
  if (!stands() && bounds_tool()) former_ = greater(former_, permitted(state_));
}

/// Whether the tool is too fast at the end of a step, or where it is fastest in between; `peak`
/// rises to that.
bool VelocityMode::too_fast(const State& from, const State& to, double time,
                            JogSpeed& peak) const noexcept {
  if (!bounds_tool()) return false;
  const JogSpeed now = space_.fastest(from, to, time);
  peak = greater(peak, now);
  return !now.within(greater(permitted(to), former_));
}

/// Whether an arm is about to be stretched or folded; back it may go.
bool VelocityMode::leaves_reach(const JointVector& from, const JointVector& to) const noexcept {
  const double stretch = space_.stretch(to);
  return !space_.joint() && stretch < kStretched && stretch < space_.stretch(from);
}

/// Whether axes may go from one state to another in that time, and would do so smoothly.
JogLimit VelocityMode::judge(const JointReference& from, const JointReference& to,
                             double time) const noexcept {
  constexpr double kMost = 1 + kRounding;
  const bool between = time > period_;  // there are periods that are not judged
  const double forces = between && !space_.joint() ? kForBetween : kMost;
  const JointVector bent = to.qdd - from.qdd;
  // An axis whose jerk is constant leaves nothing; one that leaps leaves its leap.
  const JointVector left =
      to.q - from.q - (from.qd + to.qd) * (time / 2) + bent * (time * time / 12);
  for (int i = 0; i < to.q.size(); ++i) {
    const auto [least, most] = std::minmax(from.q[i], to.q[i]);
    // An axis that turns round in between has been farther than both ends, by no more than this.
    const bool turns = between && from.qd[i] * to.qd[i] < 0;
    const double more = turns ? time * std::min(std::abs(from.qd[i]), std::abs(to.qd[i])) : 0;
    const double rounding = kSamePlace - more;
    if (most > high_[i] + rounding || least < low_[i] - rounding) return {Limit::End, i};
    const double leap = j_max_[i] * time * time * time / 48 + kSamePlace;
    if (std::abs(left[i]) > leap) return {Limit::Reach, -1};
    if (std::abs(to.qd[i]) > v_max_[i] * kMost) return {Limit::Speed, i};
    const bool peaks = between && from.qdd[i] * to.qdd[i] < 0;
    const double peak = peaks ? from.qd[i] - square(from.qdd[i]) * time / (2 * bent[i]) : to.qd[i];
    if (std::abs(peak) > v_max_[i] * kMost) return {Limit::Speed, i};
    const bool bends = std::abs(bent[i]) > j_max_[i] * time * forces;
    if (bends || std::abs(to.qdd[i]) > a_max_[i] * forces) return {Limit::Acceleration, i};
  }
  return {};
}

/// From the state one period on comes to rest as go_on_to_rest() would.
JogLimit VelocityMode::try_rest(State state, int& steps, JogSpeed& peak) const noexcept {
  const JointVector none = JointVector::Zero(state.axes.q.size());
  const double time = period_ * periods_a_rest_step_;
  State next;
  if (too_fast(state_, state, period_, peak)) return {Limit::Share, -1};
  while (!at_rest(state)) {
    if (steps-- <= 0) return {Limit::Acceleration, -1};
    const JogLimit limit = go(state, 0, none, time, next);
    if (limit.kind != Limit::None) return limit;
    if (too_fast(state, next, time, peak)) return {Limit::Share, -1};
    state = next;
  }
  return {};
}

/// The last resort, where rounding has led to a place that the tool cannot be brought to rest from
/// on its way: each axis by itself.
void VelocityMode::brake_axes() noexcept {
  const JointReference axes = state_.axes;
  broken_off_ = true;
  asked_ = {};
  asked_.space = JogRates::Space::Joint;
  asked_.rate = JointVector::Zero(axes.q.size());
  state_.place = space_.enter(asked_, axes.q);
  state_.rate = axes.qd;
  state_.acceleration = axes.qdd;
  rest_periods_ = 0;
  go_on_to_rest();
}

}  // namespace rob::motion
