#include "motion/generate/dwell.h"

#include <algorithm>
#include <limits>

#include "motion/space/cycle_instant.h"

namespace rob::motion {

namespace {

/// s. [choice] An axis with a bandwidth of 20 rad/s goes so far beyond as it comes to rest; whoever
/// needs less to cross the window is only passing through.
constexpr double kCrossing = 0.05;

/// How far the robot may move in a period within the window.
SettleWindow slowly(SettleWindow window, double period) noexcept {
  const double share = std::min(period / kCrossing, 1.0);
  window.distance *= share;
  window.angle *= share;
  return window;
}

}  // namespace

void Dwell::settle(double instant) noexcept {
  end_ = std::numeric_limits<double>::infinity();
  settle_by_ = instant + now_.segment.settle.time;
}

double Dwell::done() const noexcept {
  if (settling()) return now_.segment.settle.time - (settle_by_ - now_.stamp);
  return now_.segment.duration - (end_ - now_.stamp);
}

/// The robot may be off the path that is commanded here, in a PRESS; what counts is where the axes
/// are commanded to be.
std::optional<PositionError> Dwell::off() const noexcept {
  using Kind = PositionError::Kind;
  const SettleWindow& window = now_.segment.settle;
  const PositionError off = error(window, now_.view.reference);
  const SettleWindow crossed = slowly(window, robot_.reference_period);
  const bool slow = error(crossed, measured_before_).kind == Kind::None;
  if (off.kind == Kind::None && slow) return std::nullopt;
  return off;
}

bool Dwell::late() const noexcept { return !(now_.stamp < settle_by_ - kSameInstant); }

}  // namespace rob::motion
