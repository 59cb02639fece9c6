#include "runtime/tick/motion_task.h"

#include <limits>

#include "motion/space/cycle_instant.h"

namespace rob::runtime {

using motion::Effect;
using motion::FollowingFinding;
using motion::MotionEvent;
using motion::MotionState;

namespace {

constexpr double kLongestSettling = 1;  // s [choice] for an axis that does not come to rest

}  // namespace

MotionTask::MotionTask(const motion::RobotModel& robot, motion::TrajectoryGenerator& generator,
                       motion::TrajectoryGenerator& handlers, double override_share,
                       Channels& channels, const std::vector<SimulationRule>& script,
                       std::size_t recorded)
    : channels_(channels),
      period_(robot.reference_period),
      tracks_(generator, handlers, channels, robot.start),
      outputs_(channels),
      inputs_(robot, script, outputs_, history_, channels),
      speed_(robot, override_share, tracks_, channels),
      effects_(outputs_, inputs_, speed_, channels),
      retracing_(robot, recorded, speed_, channels),
      pressing_(robot, channels),
      force_watch_(robot.force.limit),
      stopping_(robot, tracks_, retracing_, effects_, channels) {
  generator.keep_to(channels.jog_room);
  handlers.keep_to(channels.jog_room);
}

void MotionTask::cycle(std::int64_t number, double lateness) noexcept {
  if (over()) return;
  now_ = motion::cycle_instant(number, period_);
  channels_.jog_room.look(now_);
  take_samples();
  speed_.relieve_drives(now_, history_.saturation());
  inputs_.latch(now_);
  supervise_force();
  take_requests();
  effects_.take_immediate(now_, stopping_.faulted());
  tracks_.look(inputs_.view(now_, tracks_.reference().q));
  release_actions();
  if (!started_) tracks_.advance(number);
  started_ = true;
  collect_events();
  publish();
  retracing_.record(tracks_.reference().q);
  release_events();
  effects_.end_pulses(now_, now_);
  if (done()) over_.store(true, std::memory_order_release);
  channels_.cycle.store(number, std::memory_order_relaxed);
  channels_.joints.store(tracks_.reference().q);
  tracks_.report_settled();
  if (over()) return;
  lead(number + 1);
  lateness_ = lateness;
}

/// Hands out the reference of cycle `number`, the one after the current one.
void MotionTask::lead(std::int64_t number) noexcept {
  const double stamp = motion::cycle_instant(number, period_);
  tracks_.advance(number);
  retracing_.follow(tracks_.program(), stamp - now_);
  pressing_.follow(tracks_, inputs_.wrench(), stopping_.held(), now_);
  collect_events();
  if (stopping_.off_path()) pressing_.leave_off();
  stopping_.lead(stamp);
  channels_.references.push(tracks_.reference());
  tracks_.report_progress();
}

void MotionTask::take_samples() noexcept {
  while (const ServoSample* const sample = channels_.samples.front()) {
    history_.take(*sample);
    inputs_.take(*sample);
    stopping_.take(*sample, now_);
    channels_.samples.pop();
  }
}

void MotionTask::supervise_force() noexcept {
  const ForceGauge& gauge = inputs_.gauge();
  if (gauge.zeroed() || pressing_.active())
    stopping_.take_finding(now_, judge_sensor(gauge, now_), now_);
  if (stopping_.faulted()) return;
  const bool braking = tracks_.active().current.state == MotionState::Stopping;
  const FollowingFinding finding = force_watch_.judge(inputs_.wrench(), braking);
  if (finding.verdict == FollowingFinding::Verdict::None) return;
  stopping_.take_finding(now_, finding, now_);
  pressing_.back_off();
}

void MotionTask::take_requests() noexcept {
  take_interventions();
  if (channels_.stop.hold.load(std::memory_order_relaxed)) stopping_.hold(now_);
  if (channels_.stop.brake.load(std::memory_order_relaxed)) stopping_.brake(now_);
  const bool no_way_back = tracks_.handling() || stopping_.for_good() || pressing_.active();
  retracing_.take_request(tracks_.program().current, no_way_back, now_);
  stopping_.pause(channels_.pause.update());
  const double share = channels_.override_asked.exchange(0, std::memory_order_relaxed);
  if (share != 0) speed_.set_override(share);
  const motion::JointVector& q = tracks_.reference().q;
  tracks_.take_after_handler(pressing_.on_path(q), now_, handlers_barred());
}

/// A signal script in the place of somebody who watches the run.
void MotionTask::take_interventions() noexcept {
  using Kind = Intervention::Kind;
  ScriptedOperator& scripted = inputs_.scripted_operator();
  const ScriptedOperator::Request asked = scripted.take();
  if (stopping_.for_good()) return;
  const auto tell_of = [&](Kind kind, double share = 1) {
    channels_.interventions.push({now_, kind, share});
  };
  if (asked.share > 0) {
    speed_.set_override(asked.share);
    tell_of(Kind::Override, asked.share);
  }
  if (asked.hold) {
    channels_.pause.set(*asked.hold);
    tell_of(*asked.hold ? Kind::Hold : Kind::GoOn);
  }
  const bool forgotten = asked.hold && scripted.holds_for_ever();
  if (!asked.stop && !forgotten) return;
  tell_of(asked.stop ? Kind::Stop : Kind::Forgotten);
  channels_.stop.hold.store(true, std::memory_order_relaxed);
}

/// A handler on the way back would not know where the path was left.
bool MotionTask::handlers_barred() const noexcept {
  return channels_.handlers_barred.load() || retracing_.away();
}

void MotionTask::collect_events() noexcept {
  MotionEvent event;
  for (Track* const track : tracks_.both()) {
    while (track->generator.take_event(event)) {
      if (stopping_.off_path()) continue;
      track->pending.push(event);
      if (event.kind == MotionEvent::Kind::Overrun && track == &tracks_.active())
        stopping_.lose_touch(now_);
    }
  }
}

/// Anything that WHENs have done in this cycle comes before what is due in it by the clock.
void MotionTask::release_actions() noexcept {
  MotionEvent event;
  for (Track* const track : tracks_.both()) {
    while (track->generator.take_event(event)) {
      if (event.kind == MotionEvent::Kind::ActionDue) {
        release(*track, event);
      } else {
        track->pending.push(event);
      }
    }
  }
}

void MotionTask::release_events() noexcept {
  while (Track* const track = tracks_.next_due(now_)) {
    release(*track, *track->pending.front());
    track->pending.pop();
  }
}

void MotionTask::release(Track& track, MotionEvent event) noexcept {
  if (tracks_.is_handlers(track)) event.number += kHandlerNumbers;
  switch (event.kind) {
    case MotionEvent::Kind::SegmentStarted:
      begin_motion(track, event);
      break;
    case MotionEvent::Kind::EffectDue:
      if (!release_effect(track, event)) return;
      break;
    case MotionEvent::Kind::ActionDue:
      if (stopping_.faulted() || !carry_out(event.effect)) return;
      break;
    case MotionEvent::Kind::EffectDropped:
      if (event.effect.kind == Effect::Kind::Report)
        channels_.reports.push({event.effect.id, true});
      track.progress.effects_done.fetch_add(1, std::memory_order_release);
      return;  // the report counts what has not acted
    case MotionEvent::Kind::Rest:
      return tracks_.hand_over_rest(track, event, now_, handlers_barred());
    case MotionEvent::Kind::Overrun:
    case MotionEvent::Kind::Fault:
    case MotionEvent::Kind::PaceFailed:
    case MotionEvent::Kind::Unsettled:
      if (&track != &tracks_.active()) return;
      stopping_.fail(now_);
      break;
    case MotionEvent::Kind::Finished:
      finished_ = true;
      break;
    case MotionEvent::Kind::Held:
      if (&track != &tracks_.active()) return;  // the other one's axes do not stand yet
      if (stopping_.pausing()) return;
      finished_ = true;
      // Nobody will be there to end them.
      effects_.end_pulses(std::numeric_limits<double>::infinity(), now_);
      break;
    default:
      break;
  }
  channels_.tell(event);
}

void MotionTask::begin_motion(const Track& track, const MotionEvent& event) noexcept {
  const bool moves = event.value != 0;
  if (moves) retracing_.begin_motion(event.tag, event.time < now_ - motion::kSameInstant);
  if (tracks_.is_handlers(track) || !channels_.hold_points.holds(event.tag, event.number)) return;
  channels_.pause.set(true);
  if (moves) retracing_.hold_at_motion();
}

/// Whether it has acted.
bool MotionTask::release_effect(Track& track, MotionEvent& event) noexcept {
  if (stopping_.faulted()) return false;  // a fault drops what comes after it
  const bool acts = carry_out(event.effect);
  track.progress.effects_done.fetch_add(1, std::memory_order_release);
  event.time = now_;  // it acts in this cycle, and the event says so
  return acts;
}

/// False where the effect is on an output that keeps its SAFE value.
bool MotionTask::carry_out(const Effect& effect) noexcept {
  if (effects_.locked(effect)) return false;
  effects_.act(effect, now_);
  return true;
}

void MotionTask::publish() noexcept {
  const double saturation = history_.take_saturation();
  if (channels_.snapshots.full()) {
    channels_.lost.fetch_add(1, std::memory_order_relaxed);
    return;
  }
  Snapshot& snapshot = *channels_.snapshots.slot();
  snapshot.sample = tracks_.active().current;
  snapshot.saturation = saturation;
  snapshot.lateness = lateness_;
  snapshot.override_share = speed_.share();
  snapshot.wrench = inputs_.wrench();
  snapshot.pressed = pressing_.way();
  if (pressing_.active() && !tracks_.handling() && !stopping_.held())
    snapshot.sample.state = MotionState::Pressing;
  if (tracks_.handling()) snapshot.sample.piece += kHandlerNumbers;
  history_.put_into(snapshot);
  channels_.snapshots.push();
}

bool MotionTask::done() noexcept {
  return finished_ && !outputs_.pulsing() && !retracing_.moving() && !pressing_.backing_off() &&
         machine_settled();
}

/// A machine that follows its references later, by what it reports. A way back to the references is
/// waited for, since it always ends; there is none after a last stop.
bool MotionTask::machine_settled() noexcept {
  const ServoHistory::Seen* const newest = history_.newest();
  if (newest == nullptr) return true;
  const bool joining = newest->joining && !stopping_.off_path();
  if (!finished_at_ || joining) finished_at_ = now_;
  return !joining && (newest->settled || now_ - *finished_at_ > kLongestSettling);
}

}  // namespace rob::runtime
