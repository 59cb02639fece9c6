#include "runtime/tick/motion_task.h"

#include <algorithm>
#include <limits>
#include <utility>

#include "motion/space/cycle_instant.h"

namespace rob::runtime {

using motion::Effect;
using motion::FollowingFinding;
using motion::MotionEvent;

namespace {

constexpr double kMostShare = 2;  // of an override

// s. [choice] what a machine that follows later lags and reports behind; older measurements are
// those of a machine that does not answer
constexpr double kLongestLag = 0.3;
constexpr double kLongestSettling = 1;  // s [choice] for an axis that does not come to rest

constexpr double kInstantTolerance = 1e-9;  // s: an instant on the period's border is in it

motion::JointVector six(const motion::Wrench& wrench) noexcept {
  motion::JointVector values(6);
  values << wrench.force, wrench.torque;
  return values;
}

}  // namespace

MotionTask::MotionTask(const motion::RobotModel& robot, motion::TrajectoryGenerator& generator,
                       motion::TrajectoryGenerator& handlers, double override_share,
                       Channels& channels, const std::vector<SimulationRule>& script,
                       std::size_t recorded)
    : channels_(channels),
      program_{generator, channels.program},
      handlers_{handlers, channels.handler},
      robot_(robot),
      period_(robot.reference_period),
      scales_time_(robot.law == motion::Law::Paul),
      most_share_(scales_time_ ? 1 : kMostShare),
      override_share_(std::min(override_share, most_share_)),
      gauge_(robot),
      simulated_(script, channels.panel),
      relief_(robot.reference_period),
      retrace_(robot, recorded),
      last_stop_(robot),
      press_(robot) {
  if (override_share_ != 1) set_override(override_share_);
  program_.current.reference.q = robot.start;
}

void MotionTask::cycle(std::int64_t number, double lateness) noexcept {
  if (over()) return;
  now_ = motion::cycle_instant(number, period_);
  take_samples();
  relieve_drives();
  latch_inputs(now_);
  supervise_force();
  take_requests();
  take_after_handler();
  take_immediate();
  const motion::CycleView seen = view(now_);
  program_.generator.look(seen);
  if (handling()) handlers_.generator.look(seen);
  release_actions();
  if (!started_) advance(number);
  started_ = true;
  collect_events();
  publish(active_->current);
  if (!retrace_.away()) retrace_.add(active_->current.reference.q);
  release_events(now_);
  end_pulses(now_);
  const bool done = finished_ && !pulses_.any() && !retrace_.moving();
  if (done && backing_off_ == BackOff::None && machine_settled())
    over_.store(true, std::memory_order_release);
  channels_.cycle.store(number, std::memory_order_relaxed);
  channels_.joints.store(active_->current.reference.q);
  for (Track* const track : {&program_, &handlers_}) {
    if (track->current.state != motion::MotionState::Idle) continue;
    track->progress.settled.store(track->current.piece, std::memory_order_release);
  }
  if (over()) return;

  advance(number + 1);
  follow_way_back(motion::cycle_instant(number + 1, period_) - now_);
  follow_press();
  collect_events();
  follow_last_stop(motion::cycle_instant(number + 1, period_));
  lateness_ = lateness;
  channels_.references.push(active_->current.reference);
  for (Track* const track : {&program_, &handlers_}) {
    MotionProgress& progress = track->progress;
    progress.standing.store(track->current.state == motion::MotionState::Idle,
                            std::memory_order_relaxed);
    progress.decidable.store(track->generator.decidable(), std::memory_order_release);
  }
}

void MotionTask::advance(std::int64_t number) noexcept {
  program_.current = program_.generator.advance(number);
  handlers_.current = handlers_.generator.advance(number);
}

void MotionTask::take_samples() noexcept {
  while (const ServoSample* const next = channels_.samples.front()) {
    const ServoSample& sample = *next;
    history_[samples_++ % kHistory] = {sample.measured, sample.drive, sample.settled,
                                       sample.joining};
    saturation_ = std::max(saturation_, sample.saturation);
    machine_inputs_ = sample.inputs;
    machine_analog_inputs_ = sample.analog_inputs;
    gauge_.take(sample);
    if (sample.finding.verdict != FollowingFinding::Verdict::None)
      take_finding(sample.time, sample.finding);
    last_stop_.take(sample);
    channels_.samples.pop();
  }
}

/// A machine that follows its references later, by what it reports. A way back to the references is
/// waited for, since it always ends; there is none after a last stop.
bool MotionTask::machine_settled() noexcept {
  if (samples_ == 0) return true;
  const Seen& newest = history_[(samples_ - 1) % kHistory];
  const bool joining = newest.joining && !last_stop_.active();
  if (!finished_at_ || joining) finished_at_ = now_;
  return !joining && (newest.settled || now_ - *finished_at_ > kLongestSettling);
}

void MotionTask::prepare(double now) noexcept {
  machine_inputs_ = channels_.inputs.load(std::memory_order_relaxed);
  machine_analog_inputs_ = channels_.analog_inputs.load();
  latch_inputs(now);
}

void MotionTask::latch_inputs(double now) noexcept {
  WorldImage image{machine_inputs_, outputs_, machine_analog_inputs_, analog_outputs_, {}};
  if (const Seen* newest = seen_at(now)) image.wrench = gauge_.in_world(newest->measured.q);
  simulated_.latch(now, image);
  wrench_ = image.wrench;
  if (gauge_.feels() || simulated_.feels()) channels_.wrench.store(six(wrench_));
  channels_.inputs.store(image.inputs, std::memory_order_relaxed);
  channels_.analog_inputs.store(image.analog_inputs);
  channels_.simulations_done.store(simulated_.simulations_done(), std::memory_order_release);
}

void MotionTask::take_finding(double time, const FollowingFinding& finding) noexcept {
  const bool stop = finding.verdict == FollowingFinding::Verdict::Stop;
  if (stop && finding.cause == FollowingFinding::Cause::Overrun) last_stop_.lose_touch(now_);
  if (faulted_ || (warned_ && !stop)) return;
  channels_.notices.push({time, finding});
  warned_ = true;
  if (!stop) return;
  faulted_ = true;
  hold();
}

void MotionTask::take_requests() noexcept {
  take_interventions();
  if (channels_.stop.hold.load(std::memory_order_relaxed)) hold();
  if (channels_.stop.brake.load(std::memory_order_relaxed)) brake();
  take_way_back();
  pause(channels_.pause.update());
  const double share = channels_.override_asked.exchange(0, std::memory_order_relaxed);
  if (share != 0) set_override(share);
}

/// A fault, and a hold for good, go before.
void MotionTask::pause(bool asked) noexcept {
  if (safe_ || pause_on_way_back(asked) || asked == paused_) return;
  paused_ = asked;
  if (!asked) retrace_.go_on();
  for (const Track* const track : {&program_, &handlers_})
    asked ? track->generator.hold() : track->generator.resume();
}

void MotionTask::hold() noexcept {
  for (const Track* const track : {&program_, &handlers_}) {
    if (paused_ && !safe_) track->generator.resume();  // so that it tells anew that it stands
    track->generator.hold();
  }
  if (retrace_.moving()) retrace_.halt();
  take_safe_values();
}

/// From the reference that was handed out last; then without force.
void MotionTask::brake() noexcept {
  disables_ = true;
  if (last_stop_.braking()) return;
  hold();
  last_stop_.brake(active_->current.reference);
}

void MotionTask::follow_last_stop(double stamp) noexcept {
  if (last_stop_.active()) backing_off_ = BackOff::None;
  if (!last_stop_.lead(active_->current, stamp)) return;
  MotionEvent event;
  event.kind = MotionEvent::Kind::Held;
  event.time = last_stop_.rest();
  event.tag = active_->current.tag;
  active_->pending.push(event);
  if (disables_) channels_.drives_off.store(true, std::memory_order_relaxed);
}

motion::CycleView MotionTask::view(double now) const noexcept {
  const motion::JointVector& reference = active_->current.reference.q;
  motion::CycleView view{now,
                         reference,
                         reference,
                         channels_.inputs.load(std::memory_order_relaxed),
                         outputs_,
                         channels_.analog_inputs.load(),
                         analog_outputs_,
                         wrench_};
  if (const Seen* servo = seen_at(now)) {
    view.measured = servo->measured.q + servo->measured.qd * (now - servo->measured.time);
  }
  return view;
}

const MotionTask::Seen* MotionTask::seen_at(double stamp) const noexcept {
  const std::size_t kept = std::min(samples_, kHistory);
  const Seen* best = nullptr;
  for (std::size_t back = 1; back <= kept; ++back) {
    best = &history_[(samples_ - back) % kHistory];
    if (best->measured.time <= stamp + kInstantTolerance) break;
  }
  return best;
}

void MotionTask::publish(const motion::GeneratorSample& sample) noexcept {
  const double saturation = std::exchange(saturation_, 0);
  if (channels_.snapshots.full()) {
    channels_.lost.fetch_add(1, std::memory_order_relaxed);
    return;
  }
  Snapshot& snapshot = *channels_.snapshots.slot();
  snapshot.sample = sample;
  snapshot.measured = snapshot.drive = sample.reference.q;
  snapshot.saturation = saturation;
  snapshot.lateness = lateness_;
  snapshot.override_share = path_share();
  snapshot.wrench = wrench_;
  snapshot.pressed = press_.way();
  if (press_.active() && !handling() && !safe_ && !paused_)
    snapshot.sample.state = motion::MotionState::Pressing;
  if (handling()) snapshot.sample.piece += kHandlerNumbers;
  snapshot.drive.setZero();
  if (const Seen* servo = seen_at(sample.reference.time)) {
    // On the virtual clock both instants are the same; in real time the servo's is the nearer past.
    const double since = sample.reference.time - servo->measured.time;
    snapshot.measured = servo->measured.q;
    if (since < kLongestLag) snapshot.measured += servo->measured.qd * since;
    snapshot.drive = servo->drive;
  }
  channels_.snapshots.push();
}

void MotionTask::collect_events() noexcept {
  MotionEvent event;
  for (Track* const track : {&program_, &handlers_}) {
    while (track->generator.take_event(event)) {
      if (last_stop_.active()) continue;
      track->pending.push(event);
      if (event.kind == MotionEvent::Kind::Overrun && track == active_) last_stop_.lose_touch(now_);
    }
  }
}

/// What WHENs have done in this cycle comes before what is due in it by the clock.
void MotionTask::release_actions() noexcept {
  MotionEvent event;
  for (Track* const track : {&program_, &handlers_}) {
    while (track->generator.take_event(event)) {
      if (event.kind == MotionEvent::Kind::ActionDue) {
        release(*track, event, now_);
      } else {
        track->pending.push(event);
      }
    }
  }
}

void MotionTask::release_events(double until) noexcept {
  for (;;) {
    const MotionEvent* const first = program_.pending.front();
    const MotionEvent* const second = handlers_.pending.front();
    const bool programs = second == nullptr || (first != nullptr && first->time <= second->time);
    const MotionEvent* const next = programs ? first : second;
    if (next == nullptr || next->time > until + kInstantTolerance) return;
    Track& track = programs ? program_ : handlers_;
    release(track, *next, until);
    track.pending.pop();
  }
}

void MotionTask::release(Track& track, MotionEvent event, double cycle_time) noexcept {
  std::atomic<std::int64_t>& effects_done = track.progress.effects_done;
  if (&track == &handlers_) event.number += kHandlerNumbers;
  switch (event.kind) {
    case MotionEvent::Kind::SegmentStarted:
      if (event.value != 0) retrace_.mark(event.tag, event.time < now_ - kInstantTolerance);
      if (&track == &program_ && channels_.hold_points.holds(event.tag, event.number)) {
        channels_.pause.set(true);
        if (event.value != 0) retrace_.hold_at_mark();
      }
      break;
    case MotionEvent::Kind::EffectDue:
      if (faulted_) return;  // a fault drops what comes after it
      if (locked(event.effect)) {
        effects_done.fetch_add(1, std::memory_order_release);
        return;
      }
      act(event.effect, cycle_time);
      effects_done.fetch_add(1, std::memory_order_release);
      event.time = cycle_time;  // it acts in this cycle, and says so
      break;
    case MotionEvent::Kind::ActionDue:
      if (faulted_ || locked(event.effect)) return;
      act(event.effect, cycle_time);
      break;
    case MotionEvent::Kind::EffectDropped:
      if (event.effect.kind == Effect::Kind::Report) {
        channels_.reports.push({event.effect.id, true});
      }
      effects_done.fetch_add(1, std::memory_order_release);
      return;  // the report counts what has not acted
    case MotionEvent::Kind::Rest:
      return hand_over_rest(track, event);
    case MotionEvent::Kind::Overrun:
    case MotionEvent::Kind::Fault:
    case MotionEvent::Kind::PaceFailed:
    case MotionEvent::Kind::Unsettled:
      if (&track != active_) return;
      faulted_ = true;
      hold();
      break;
    case MotionEvent::Kind::Finished:
      finished_ = true;
      break;
    case MotionEvent::Kind::Held:
      if (&track != active_) return;  // the other one's axes do not stand yet
      if (paused_ && !safe_) return;  // it will go on
      finished_ = true;
      end_pulses(std::numeric_limits<double>::infinity());  // nobody will be there to end them
      break;
    default:
      break;
  }
  tell(event);
}

/// What the law cannot follow is the planner's affair, which has raised what comes from here on.
void MotionTask::set_override(double share) noexcept {
  override_share_ = std::min(share, most_share_);
  program_.generator.set_override(path_share());
  handlers_.generator.set_override(path_share());
}

double MotionTask::path_share() const noexcept {
  return relief_.share() < 1 ? std::min(override_share_, relief_.share()) : override_share_;
}

void MotionTask::relieve_drives() noexcept {
  const double before = path_share();
  const double asked = saturation_;
  const double rate = active_->current.rate;
  relief_.update(asked, scales_time_ || rate == 0 ? rate : path_share());
  if (path_share() != before) set_override(override_share_);
  if (relief_.share() == 1 || relieved_) return;
  relieved_ = true;
  using Cause = FollowingFinding::Cause;
  channels_.notices.push({now_, {FollowingFinding::Verdict::Warn, Cause::Saturated, -1, asked, 1}});
}

void MotionTask::tell(const MotionEvent& event) noexcept {
  if (!channels_.events.push(event)) channels_.lost.fetch_add(1, std::memory_order_relaxed);
}

}  // namespace rob::runtime
