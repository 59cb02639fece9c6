#include <algorithm>

#include "motion/generate/segment_generator.h"

/// Member functions of SegmentGenerator that give the axes to a handler.
namespace rob::motion {

/// One at a time, and none once the program has come to its end.
bool SegmentGenerator::may_be_handled() const noexcept {
  return handling_ == nullptr && !stopped_ && !closed() && !handlers_barred_;
}

JointVector SegmentGenerator::standing_place() const noexcept {
  if (jogging()) return jog_.reference().q;
  if (!on_path()) return segment_.target;
  GeneratorSample here = sample_;
  sample_path(here);
  return here.reference.q;
}

void SegmentGenerator::begin_handling(WatchedAction& action) noexcept {
  handling_ = &action;
  action.fired.store(true, std::memory_order_relaxed);
  if (handling()) return;  // once the axes stand
  handled_told_ = true;
  tell_handled(view_.time);
}

/// Once the axes stand; what was braking then has ended first.
void SegmentGenerator::report_handled() noexcept {
  if (!handling() || handled_told_ || stopped_) return;
  const auto since = at_rest_since();
  if (!since || braking_) return;
  handled_told_ = true;
  tell_handled(std::max(latest_, *since));
}

void SegmentGenerator::tell_handled(double time) noexcept {
  const Rest braking = rest_;  // a Call may come while a guarded motion brakes
  begin_rest(Rest::Outcome::Handled, handling_, view_.time);
  rest_.q = standing_place();
  tell_rest(time);
  rest_ = braking;
}

void SegmentGenerator::go_on(double time) noexcept {
  handling_ = nullptr;
  handled_told_ = false;
  latest_ = std::max(latest_, time);
}

/// One that has not begun comes true anew when handlers may begin again.
void SegmentGenerator::bar_handlers(bool barred) noexcept {
  handlers_barred_ = barred;
  if (barred && handling_ != nullptr && !handled_told_) decline_handler(view_.time);
}

void SegmentGenerator::decline_handler(double time) noexcept {
  if (handling_ == nullptr) return;
  handling_->fired.store(false, std::memory_order_relaxed);
  watches_.renew(*handling_);
  go_on(time);
}

void SegmentGenerator::leave_path(const JointVector& q, double time, bool all) noexcept {
  begin_rest(Rest::Outcome::Braked, nullptr, time);
  rest_.q = q;
  kept_ = passed_;
  stand_at(q);
  for (const SegmentDescriptor* next = next_segment(); next != nullptr; next = next_segment()) {
    if (all) segment_.number = next->number;
    segment_.generation = next->generation;
    pop_segment();
  }
  if (all) ended_ = segment_.generation;
  drop_path(all ? ended_ : 0);
  passed_ = segment_.number;
  latest_ = std::max(latest_, time);
  braking_ = false;
  go_on(time);
  tell_rest(latest_);
}

void SegmentGenerator::stand_at(const JointVector& q) noexcept {
  end_path();
  running_ = false;
  segment_.target = q;
  segment_.guard = {};
  segment_.settle = {};
  stand();
}

void SegmentGenerator::brake() noexcept {
  if (!faulted_ && !braking_) trip(Rest::Outcome::Braked);
}

}  // namespace rob::motion
