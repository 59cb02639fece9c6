#include "motion/generate/early_end.h"

#include <algorithm>
#include <cstdint>

namespace rob::motion {

namespace {

using EventKind = MotionEvent::Kind;

Rest::Outcome outcome_of(WatchAnswer answer) noexcept {
  return answer == WatchAnswer::Yes ? Rest::Outcome::Hit : Rest::Outcome::Failed;
}

}  // namespace

void EarlyEnd::ask_guard() noexcept {
  const std::uint32_t number = buffer_.to_be_braked();
  if (number != 0 && number <= now_.segment.number) return trip(Rest::Outcome::Braked);
  if (!now_.running || !now_.segment.guard.present()) return;
  const WatchAnswer answer = now_.segment.guard.ask(now_.view);
  if (answer != WatchAnswer::No) trip(outcome_of(answer));
}

void EarlyEnd::trip(Rest::Outcome outcome, WatchedAction* by) noexcept {
  const std::uint32_t number = now_.segment.number;
  rest_ = now_.rest(outcome, by, now_.view.time);
  // After an error nothing acts that has not acted yet; else what stands before the motion does.
  effects_.keep(by != nullptr ? effects_.passed() : number - (number > 0 ? 1 : 0));
  braking_ = true;
  events_.report({.kind = outcome == Rest::Outcome::Hit ? EventKind::Hit : EventKind::Braking,
                  .time = now_.view.time,
                  .tag = now_.segment.tag,
                  .number = number});
}

bool EarlyEnd::hit_at_start(const SegmentDescriptor& segment, double instant) noexcept {
  if (!segment.guard.present()) return false;
  const WatchAnswer answer = segment.guard.ask(now_.view);
  if (answer == WatchAnswer::No) return false;
  now_.segment.tag = segment.tag;
  now_.segment.number = segment.number;
  now_.segment.generation = segment.generation;
  events_.report({.kind = EventKind::SegmentStarted,
                  .time = instant,
                  .tag = segment.tag,
                  .number = segment.number});
  now_.running = false;
  trip(outcome_of(answer));
  return true;
}

void EarlyEnd::finish(double time) noexcept {
  if (rest_.outcome == Rest::Outcome::Braked) buffer_.braked();
  untaken_ = rest_.by != nullptr;
  braking_ = false;
  rest_.q = now_.segment.target;
  events_.report(rest_, time, now_.segment.number);
}

void EarlyEnd::close_guard(const SegmentDescriptor* next, double instant) noexcept {
  SegmentDescriptor& segment = now_.segment;
  if (!segment.guard.present() || braking_) return;
  if (next != nullptr && next->no_length && next->guard.present()) return;  // its own exact end
  segment.guard = {};
  const double time = std::max(events_.latest(), instant);
  Rest rest = now_.rest(Rest::Outcome::Reached, nullptr, time);
  rest.q = segment.target;
  events_.report(rest, time, segment.number);
}

}  // namespace rob::motion
