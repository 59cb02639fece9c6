#include "motion/space/speed_change.h"

#include <algorithm>
#include <cmath>

namespace rob::motion {

namespace {

/// Relative: of a difference that is none.
constexpr double kRounding = 1e-15;

}  // namespace

AxisState JerkPhase::after(const AxisState& begin, double time) const noexcept {
  return {begin.q + ((jerk * time / 3 + acceleration) * time / 2 + begin.v) * time,
          begin.v + (jerk * time / 2 + acceleration) * time, acceleration + jerk * time};
}

double SpeedChange::duration() const noexcept {
  return phases[0].duration + phases[1].duration + phases[2].duration;
}

AxisState SpeedChange::end(AxisState begin) const noexcept {
  for (const JerkPhase& phase : phases) begin = phase.after(begin, phase.duration);
  return begin;
}

SpeedChange speed_change(const AxisState& from, double target, const AxisLimits& limits) noexcept {
  const double missing = target - from.v;
  if (std::isinf(limits.j)) {
    return {{{{}, {std::abs(missing) / limits.a, std::copysign(limits.a, missing), 0}, {}}}};
  }
  // The change that taking back the acceleration at once would bring shows which way to push.
  const double by_itself = from.a * std::abs(from.a) / (2 * limits.j);
  const double sign = missing >= by_itself ? 1 : -1;
  const double a = sign * from.a;
  double square = sign * missing * limits.j + a * a / 2;
  if (square < kRounding * a * a) square = 0;  // to take it back is all
  const double peak = std::min(std::sqrt(square), limits.a);
  // Beyond a_max only what lies above the way down from there is left.
  const double rest = a > limits.a ? square - a * a : square - peak * peak;
  const double hold = peak > 0 ? std::max(0.0, rest) / (limits.j * peak) : 0;
  return {{{{std::abs(peak - a) / limits.j, from.a, std::copysign(limits.j, sign * (peak - a))},
            {hold, sign * peak, 0},
            {peak / limits.j, sign * peak, -sign * limits.j}}}};
}

}  // namespace rob::motion
