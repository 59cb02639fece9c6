#include <algorithm>
#include <utility>

#include "motion/generate/paul_generator.h"

/// The part of PaulGenerator that moves at given rates.
namespace rob::motion {

using Kind = MotionEvent::Kind;

namespace {

/// s, as in paul_generator.cpp
constexpr double kSameInstant = 1e-9;

/// Numbers of the trace (docs/cli.md).
std::uint8_t limit_number(const JogLimit& limit) noexcept {
  const auto axis = static_cast<std::uint8_t>(std::max(limit.axis, 0));
  switch (limit.kind) {
    case JogLimit::Kind::None:
      return 0;
    case JogLimit::Kind::Share:
      return 1;
    case JogLimit::Kind::Speed:
      return static_cast<std::uint8_t>(2 + axis);
    case JogLimit::Kind::Acceleration:
      return static_cast<std::uint8_t>(10 + axis);
    case JogLimit::Kind::Reach:
      return 22;
    case JogLimit::Kind::End:
      break;
  }
  return static_cast<std::uint8_t>(30 + axis);
}

}  // namespace

bool PaulGenerator::jog_is_over() const noexcept {
  return jog_done_ >= segment_.jog.lasts - kSameInstant;
}

/// The axes stand, or are those of a jog that it joins. Its first period follows `instant`.
void PaulGenerator::begin_jog(const SegmentDescriptor& segment, double instant) noexcept {
  if (!jogging()) jog_.stand_at(segment_.target);
  jog_.aim(segment.jog);
  const std::uint32_t before = segment_.number;
  const JointVector from = segment_.target;
  segment_ = segment;
  segment_.target = from;
  t_acc_ = segment.t_acc;
  running_ = true;
  inserted_ = jog_told_ = false;
  zero_ = end_ = clock_.path_time();
  jog_done_ = 0;
  passed_ = passing_ = before;
  tell({.kind = Kind::SegmentStarted,
        .time = instant,
        .tag = segment.tag,
        .number = segment.number});
  buffer_.pop_segment();
}

/// One without a time is over, too, where it can go no further: else it would never end.
void PaulGenerator::run_jog() noexcept {
  join_jog();
  const double share = jog_is_over() ? 0 : clock_.rate();
  jog_.step(share);
  jog_done_ += period_ * share;
  report_jog_stopped();
  const bool ends_here = jog_.stopped() && jog_.stands() && segment_.jog.lasts == JogRates::kAny;
  if (ends_here) jog_done_ = JogRates::kAny;
  if (jog_is_over() && jog_.stands() && !clock_.braking()) end_jog();
}

/// What follows at the end of its time, or while it comes to rest; one in another space, or of
/// another tool, begins at rest.
void PaulGenerator::join_jog() noexcept {
  const SegmentDescriptor* const next = faulted_ ? nullptr : buffer_.next_segment();
  const bool may = clock_.rate() > 0 && !segment_.guard.present();
  if (!may || next == nullptr || !next->jog.present() || !jog_.takes(next->jog)) return;
  if (!jog_is_over() && !next->jog.at_once) return;
  const double instant = clock_.stamp() - period_;
  begin_jog(*next, instant);
  fire_effects(instant);
}

/// At rest, and nothing has joined it.
void PaulGenerator::end_jog() noexcept {
  latest_ = std::max(latest_, clock_.stamp());
  stand_at(jog_.reference().q);
  passed_ = passing_ = segment_.number;
  begin_rest(Rest::Outcome::Reached, nullptr, latest_);
  rest_.q = segment_.target;
  tell_rest(latest_);
}

/// Once, as long as it does not go on.
void PaulGenerator::report_jog_stopped() noexcept {
  const bool told = std::exchange(jog_told_, jog_.stopped());
  if (told || !jog_told_) return;
  tell({.kind = Kind::JogStopped,
        .time = clock_.stamp(),
        .tag = segment_.tag,
        .number = segment_.number,
        .axis = jog_.limit().kind == JogLimit::Kind::End ? jog_.limit().axis : -1});
}

void PaulGenerator::follow_jog() noexcept {
  const double time = sample_.reference.time;
  sample_.reference = jog_.reference();
  sample_.reference.time = time;
  sample_.sigma = jog_done_;
  sample_.rate = jog_.granted() * clock_.rate();
  sample_.limit = limit_number(jog_.limit());
  if (sample_.limit == 0 && clock_.override_share() < 1) sample_.limit = 21;
}

}  // namespace rob::motion
