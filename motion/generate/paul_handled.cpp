#include <algorithm>

#include "motion/generate/paul_generator.h"

/// The part of PaulGenerator that lets a handler have the axes.
namespace rob::motion {

/// One at a time, and none once the program has come to its end.
bool PaulGenerator::may_be_handled() const noexcept {
  return handling_ == nullptr && !stopped_ && !buffer_.closed() && !handlers_barred_;
}

JointVector PaulGenerator::standing_place() const noexcept {
  if (jogging()) return jog_.reference().q;
  if (!running_ || segment_.dwell) return segment_.target;
  return path_.sample(clock_.path_time() - zero_).q;
}

void PaulGenerator::begin_handling(WatchedAction& action) noexcept {
  handling_ = &action;
  action.fired.store(true, std::memory_order_relaxed);
  if (handling()) return clock_.hold();
  handled_told_ = true;
  tell_handled(view_.time);
}

/// Once the axes stand; what was braking then has ended first.
void PaulGenerator::report_handled() noexcept {
  if (!handling() || handled_told_ || stopped_) return;
  if (!axes_held() || clock_.braking()) return;
  handled_told_ = true;
  tell_handled(std::max(latest_, jogging() ? clock_.stamp() : clock_.steady_since()));
}

void PaulGenerator::tell_handled(double time) noexcept {
  const Rest braking = rest_;  // a Call may come while a guarded motion brakes
  begin_rest(Rest::Outcome::Handled, handling_, view_.time);
  rest_.q = standing_place();
  tell_rest(time);
  rest_ = braking;
}

void PaulGenerator::go_on(double time) noexcept {
  handling_ = nullptr;
  handled_told_ = false;
  latest_ = std::max(latest_, time);
  if (!stopped_) clock_.resume();
}

/// One that has not begun comes true anew when handlers may begin again.
void PaulGenerator::bar_handlers(bool barred) noexcept {
  handlers_barred_ = barred;
  if (barred && handling_ != nullptr && !handled_told_) decline_handler(view_.time);
}

void PaulGenerator::decline_handler(double time) noexcept {
  if (handling_ == nullptr) return;
  handling_->fired.store(false, std::memory_order_relaxed);
  watches_.renew(*handling_);
  go_on(time);
}

void PaulGenerator::leave_path(const JointVector& q, double time, bool all) noexcept {
  begin_rest(Rest::Outcome::Braked, nullptr, time);
  rest_.q = q;
  kept_ = passed_;
  stand_at(q);
  for (const SegmentDescriptor* next = buffer_.next_segment(); next != nullptr;
       next = buffer_.next_segment()) {
    if (all) segment_.number = next->number;
    segment_.generation = next->generation;
    buffer_.pop_segment();
  }
  if (all) ended_ = segment_.generation;
  passed_ = passing_ = segment_.number;
  latest_ = std::max(latest_, time);
  clock_.release();
  go_on(time);
  tell_rest(latest_);
}

void PaulGenerator::stand_at(const JointVector& q) noexcept {
  running_ = inserted_ = false;
  path_events_.drop();
  segment_.target = q;
  segment_.guard = {};
  t_acc_ = usual_t_acc_;
  stand();
}

void PaulGenerator::brake() noexcept {
  if (!faulted_ && !clock_.braking()) trip(Rest::Outcome::Braked);
}

}  // namespace rob::motion
