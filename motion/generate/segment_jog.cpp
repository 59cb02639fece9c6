#include <algorithm>
#include <utility>

#include "motion/generate/limit_numbers.h"
#include "motion/generate/segment_generator.h"

/// Member functions of SegmentGenerator that move at given rates.
namespace rob::motion {

using EventKind = MotionEvent::Kind;

namespace {

std::uint8_t number_of(const JogLimit& limit) noexcept {
  using namespace limit_number;
  switch (limit.kind) {
    case JogLimit::Kind::None:
      return kNone;
    case JogLimit::Kind::Share:
      return kPace;
    case JogLimit::Kind::Speed:
      return of_axis(kSpeed, limit.axis);
    case JogLimit::Kind::Acceleration:
      return of_axis(kAcceleration, limit.axis);
    case JogLimit::Kind::Reach:
      return kReach;
    case JogLimit::Kind::End:
      break;
  }
  return of_axis(kEndOfAxis, limit.axis);
}

}  // namespace

bool SegmentGenerator::jog_is_over() const noexcept {
  return jog_done_ >= segment_.jog->lasts - kSameInstant;
}

/// The axes stand, or are those of a jog that it joins. Its first period follows `instant`.
void SegmentGenerator::begin_jog(const SegmentDescriptor& segment, double instant) noexcept {
  if (!jogging()) jog_.stand_at(segment_.target);
  jog_.aim(*segment.jog);
  const std::uint32_t before = segment_.number;
  const JointVector from = segment_.target;
  segment_ = segment;
  segment_.target = from;
  running_ = true;
  jog_told_ = false;
  jog_done_ = 0;
  passed_ = before;
  tell({.kind = EventKind::SegmentStarted,
        .time = instant,
        .tag = segment.tag,
        .number = segment.number,
        .value = 1});
  pop_segment();
}

/// One without a time is over, too, where it can go no further: else it would never end.
void SegmentGenerator::run_jog() noexcept {
  join_jog();
  const double share = jog_is_over() ? 0 : jog_share();
  jog_.step(share);
  jog_done_ += period_ * share;
  report_jog_stopped();
  const bool ends_here = jog_.stopped() && jog_.stands() && segment_.jog->lasts == JogRates::kAny;
  if (ends_here) jog_done_ = JogRates::kAny;
  if (jog_is_over() && jog_.stands() && !braking_) end_jog();
}

/// What follows at the end of its time, or while it comes to rest; one in another space, or of
/// another tool, begins at rest.
void SegmentGenerator::join_jog() noexcept {
  const SegmentDescriptor* const next = faulted_ ? nullptr : next_segment();
  const bool may = jog_share() > 0 && !segment_.guard.present();
  if (!may || next == nullptr || !next->jog->present() || !jog_.takes(*next->jog)) return;
  if (!jog_is_over() && !next->jog->at_once) return;
  const double instant = stamp_ - period_;
  begin_jog(*next, instant);
  fire_effects(instant);
}

/// At rest, and nothing has joined it.
void SegmentGenerator::end_jog() noexcept {
  latest_ = std::max(latest_, stamp_);
  stand_at(jog_.reference().q);
  passed_ = segment_.number;
  begin_rest(Rest::Outcome::Reached, nullptr, latest_);
  rest_.q = segment_.target;
  tell_rest(latest_);
}

/// Once, as long as it does not go on.
void SegmentGenerator::report_jog_stopped() noexcept {
  const bool told = std::exchange(jog_told_, jog_.stopped());
  if (told || !jog_told_) return;
  tell({.kind = EventKind::JogStopped,
        .time = stamp_,
        .tag = segment_.tag,
        .number = segment_.number,
        .axis = jog_.limit().kind == JogLimit::Kind::End ? jog_.limit().axis : -1});
}

void SegmentGenerator::follow_jog() noexcept {
  const double time = sample_.reference.time;
  sample_.reference = jog_.reference();
  sample_.reference.time = time;
  sample_.sigma = jog_done_;
  sample_.rate = jog_.granted() * jog_share();
  sample_.limit = number_of(jog_.limit());
  if (sample_.limit == 0 && override_ < 1) sample_.limit = limit_number::kOverride;
}

}  // namespace rob::motion
