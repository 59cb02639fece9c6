#include "runtime/command/commanded_progress.h"

#include <algorithm>

namespace rob::runtime {

void CommandedProgress::follow(const motion::SegmentDescriptor& segment) {
  exact_ = segment.ends_at_rest();
  jogging_ = segment.jog->present();
  const bool mark = segment.dwell && segment.duration == 0 && !segment.settle.present();
  if (!mark) awaited_ = segment.number;
}

std::uint32_t CommandedProgress::awaited() const {
  return std::min(awaited_, links_.planner.last_number());
}

bool CommandedProgress::effects_have_acted() const {
  return links_.progress.effects_done.load(std::memory_order_acquire) >= effects_.pushed();
}

bool CommandedProgress::changes_have_acted() const {
  return links_.progress.effects_done.load(std::memory_order_acquire) >= effects_.changing();
}

bool CommandedProgress::stands() const {
  return links_.progress.settled.load(std::memory_order_acquire) >= awaited();
}

bool CommandedProgress::has_acted() const { return stands() && effects_have_acted(); }

/// The point has come once the generator names it.
bool CommandedProgress::decided() const {
  return links_.progress.decidable.load(std::memory_order_acquire) >= awaited() && !interrupted();
}

/// At standstill outputs that were set before act first, so that what they change is read; in a
/// corner it acts after the decision point.
bool CommandedProgress::observable() const {
  if (!decided()) return false;
  const bool standing = exact_ || links_.progress.standing.load(std::memory_order_relaxed);
  return !standing || changes_have_acted();
}

bool CommandedProgress::interrupted() const {
  const motion::Rest* const next = links_.progress.rests.front();
  return next != nullptr && next->by != nullptr;
}

bool CommandedProgress::take_rest(motion::Rest& rest) {
  return !interrupted() && links_.progress.rests.take(rest);
}

}  // namespace rob::runtime
