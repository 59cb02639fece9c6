#include "drivers/sim/sim_actuator.h"

namespace rob::drivers {
namespace {

// Sums of whole cycles reach the end of the way a rounding error early or late.
constexpr double kArrived = 1e-9;  // of the way

std::uint64_t bit(int channel) noexcept { return std::uint64_t{1} << channel; }

}  // namespace

void SimActuator::place_off() noexcept {
  on_ = false;
  from_ = 0;
  since_ = 0;
}

void SimActuator::command(double now, std::uint64_t outputs) noexcept {
  const bool on = (outputs & bit(parameters_.output)) != 0;
  if (on == on_) return;
  from_ = position(now);
  since_ = now;
  on_ = on;
}

std::uint64_t SimActuator::inputs(double now) const noexcept {
  const double at = position(now);
  return (at == 0 ? bit(parameters_.input_off) : 0) | (at == 1 ? bit(parameters_.input_on) : 0);
}

double SimActuator::position(double now) const noexcept {
  const double goal = on_ ? 1 : 0;
  const double left = on_ ? 1 - from_ : from_;
  const double gone = now - since_;
  if (gone >= (left - kArrived) * parameters_.travel_time) return goal;
  const double way = gone / parameters_.travel_time;
  return on_ ? from_ + way : from_ - way;
}

}  // namespace rob::drivers
