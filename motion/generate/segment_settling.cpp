#include <algorithm>
#include <limits>

#include "motion/generate/segment_generator.h"
#include "motion/space/cycle_instant.h"

/// Member functions of SegmentGenerator that wait until the measured robot is in position.
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

/// The reference has come to rest at `instant`, and stays there until look_at_position() ends it.
void SegmentGenerator::begin_settling(double instant) noexcept {
  latest_ = std::max(latest_, instant);
  segment_.no_length = segment_.dwell = true;
  segment_.profile = {};
  segment_.duration = 0;
  dwell_end_ = std::numeric_limits<double>::infinity();
  settle_by_ = instant + segment_.settle.time;
}

/// The robot may be off the path that is commanded here, in a PRESS; what counts is where the
/// axes are told to be.
void SegmentGenerator::look_at_position() noexcept {
  const auto error = [&](const SettleWindow& window, const JointVector& from) {
    return position_error(robot_, window, view_.measured, from);
  };
  using Kind = PositionError::Kind;
  const PositionError off = error(segment_.settle, view_.reference);
  const bool slow = error(slowly(segment_.settle, period_), measured_before_).kind == Kind::None;
  if (off.kind == Kind::None && slow) {
    segment_.settle = {};
    dwell_end_ = stamp_;
    return pass(segment_.number, stamp_);
  }
  if (stamp_ < settle_by_ - kSameInstant) return;
  faulted_ = true;
  tell({.kind = MotionEvent::Kind::Unsettled,
        .time = stamp_,
        .tag = segment_.tag,
        .number = segment_.number,
        .off = off});
}

/// Whether it stands after what is not in position yet: what settles now, or will once the motion
/// under way has been made exact.
bool SegmentGenerator::awaits_position(const Effect& effect) const noexcept {
  if (segment_.settle.present()) return true;
  const SegmentDescriptor* const next = next_segment();
  const bool stop = next != nullptr && next->no_length && !next->dwell;
  return stop && next->settle.present() && effect.after >= segment_.number;
}

}  // namespace rob::motion
