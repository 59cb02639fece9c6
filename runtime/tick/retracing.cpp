#include "runtime/tick/retracing.h"

#include <algorithm>

namespace rob::runtime {

using motion::MotionEvent;
using motion::MotionState;

namespace {

bool stands(const motion::GeneratorSample& sample) noexcept {
  return (sample.state == MotionState::Idle || sample.state == MotionState::Held) &&
         sample.reference.qd.isZero(0);
}

}  // namespace

Retracing::Retracing(const motion::RobotModel& robot, std::size_t recorded, const SpeedShare& speed,
                     Channels& channels)
    : speed_(speed), channels_(channels), retrace_(robot, recorded) {}

void Retracing::record(const motion::JointVector& q) noexcept {
  if (!away()) retrace_.add(q);
}

double Retracing::share() const noexcept { return std::min(speed_.share(), 1.0); }

void Retracing::take_request(const motion::GeneratorSample& program, bool barred,
                             double now) noexcept {
  if (!channels_.way_back.asked.exchange(false)) return;
  const bool may = !barred && (away() || stands(program));
  if (may && retrace_.back(share())) return;
  channels_.tell({.kind = MotionEvent::Kind::NoWayBack, .time = now});
  channels_.way_back.under_way.store(false, std::memory_order_release);
}

bool Retracing::pause(bool asked, bool paused) noexcept {
  if (!away() || channels_.stop_requested.load(std::memory_order_relaxed)) return false;
  if (channels_.way_back.hold_asked.exchange(false)) halt();
  if (!asked && paused && !retrace_.returns()) retrace_.forth(share());
  return paused;
}

void Retracing::halt() noexcept {
  if (moving()) retrace_.halt();
}

void Retracing::follow(Track& program, double time) noexcept {
  if (!away()) return;
  const bool moved = moving();
  if (channels_.stop_requested.load(std::memory_order_relaxed)) halt();
  retrace_.pass(time);
  motion::GeneratorSample& sample = program.current;
  if (away()) sample.reference = retrace_.reference(sample.reference.time);
  channels_.way_back.away.store(away(), std::memory_order_relaxed);
  if (moving()) {
    sample.state = MotionState::Running;
    return;
  }
  if (moved && away())
    channels_.tell({.kind = MotionEvent::Kind::WentBack,
                    .time = sample.reference.time,
                    .tag = retrace_.tag()});
  if (away() && sample.state == MotionState::Idle) stay(program);
  channels_.way_back.under_way.store(false, std::memory_order_release);
}

/// The way ends where the axes stand.
void Retracing::stay(Track& program) noexcept {
  const motion::JointVector& q = program.current.reference.q;
  retrace_.stay();
  program.generator.stand_at(q);
  channels_.joints.store(q);
  channels_.way_back.away.store(false, std::memory_order_relaxed);
  channels_.way_back.moved.store(true, std::memory_order_release);
}

}  // namespace rob::runtime
