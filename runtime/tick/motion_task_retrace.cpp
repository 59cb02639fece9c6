#include "runtime/tick/motion_task.h"

/// Member functions of MotionTask that drive the axes back along the way that they came, and
/// forward to where they left their path, before the program goes on.
namespace rob::runtime {

using motion::MotionEvent;
using motion::MotionState;

namespace {

bool stands(const motion::GeneratorSample& sample) noexcept {
  return (sample.state == MotionState::Idle || sample.state == MotionState::Held) &&
         sample.reference.qd.isZero(0);
}

}  // namespace

void MotionTask::take_way_back() noexcept {
  if (!channels_.way_back.asked.exchange(false)) return;
  const bool may =
      !handling() && !safe_ && !press_.active() && (retrace_.away() || stands(program_.current));
  if (may && retrace_.back(std::min(path_share(), 1.0))) return;
  tell({.kind = MotionEvent::Kind::NoWayBack, .time = now_});
  channels_.way_back.under_way.store(false, std::memory_order_release);
}

/// Whether a hold is the way back's affair.
bool MotionTask::pause_on_way_back(bool asked) noexcept {
  if (!retrace_.away() || channels_.stop_requested.load(std::memory_order_relaxed)) return false;
  if (channels_.way_back.hold_asked.exchange(false) && retrace_.moving()) retrace_.halt();
  if (!asked && paused_ && !retrace_.returns()) retrace_.forth(std::min(path_share(), 1.0));
  return paused_;
}

/// The path waits meanwhile. Where none is under way the next one begins where the axes come to
/// stand.
void MotionTask::follow_way_back(double time) noexcept {
  if (!retrace_.away()) return;
  const bool moved = retrace_.moving();
  if (moved && channels_.stop_requested.load(std::memory_order_relaxed)) retrace_.halt();
  retrace_.pass(time);
  motion::GeneratorSample& sample = program_.current;
  if (retrace_.away()) sample.reference = retrace_.reference(sample.reference.time);
  channels_.way_back.away.store(retrace_.away(), std::memory_order_relaxed);
  if (retrace_.moving()) {
    sample.state = MotionState::Running;
    return;
  }
  if (moved && retrace_.away())
    tell({.kind = MotionEvent::Kind::WentBack,
          .time = sample.reference.time,
          .tag = retrace_.tag()});
  if (retrace_.away() && sample.state == MotionState::Idle) {
    retrace_.stay();
    program_.generator.stand_at(sample.reference.q);
    channels_.joints.store(sample.reference.q);
    channels_.way_back.away.store(false, std::memory_order_relaxed);
    channels_.way_back.moved.store(true, std::memory_order_release);
  }
  channels_.way_back.under_way.store(false, std::memory_order_release);
}

}  // namespace rob::runtime
