#include "runtime/run/run_recorder.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "lang/values/percent_text.h"
#include "runtime/run/drain.h"
#include "runtime/words/force_words.h"
#include "runtime/words/units.h"

namespace rob::runtime {

using motion::Effect;
using motion::MotionEvent;

RunRecorder::RunRecorder(const motion::RobotModel& robot, double override_share, Channels& channels,
                         ProgramLog& log, SignalNames names, Listener listener)
    : robot_(robot),
      channels_(channels),
      log_(log),
      listener_(std::move(listener)),
      journal_(robot, log, std::move(names)),
      plan_(robot, override_share),
      meter_(*robot.kinematics),
      references_(*robot.kinematics),
      path_(*robot.kinematics, robot.start),
      slow_(robot),
      peaks_(robot),
      reached_(robot.start) {
  journal_.tell_signals(listener_.signal);
  result_.robot = robot.name;
  result_.law = motion::law_name(robot.law);
}

void RunRecorder::drain() {
  Intervention intervention;
  while (channels_.interventions.take(intervention)) take(intervention);
  drain_in_order(
      channels_, [&](const MotionEvent& event) { take(event); },
      [&](const Snapshot& snapshot) { take(snapshot); });
  ServoNotice notice;
  while (channels_.notices.take(notice)) take(notice);
}

void RunRecorder::take(const Snapshot& snapshot) {
  meter_.measured(snapshot.measured, snapshot.pressed);
  if (!plan_.comes_timed()) references_.measured(snapshot.sample.reference.q, snapshot.pressed);
  take_misses(false);
  const double way = path_.reference(snapshot.sample.reference.q);
  if (running_) line_of(*running_).way += way * kMillimetresPerMetre;
  if (!plan_.comes_timed()) slow_.take(snapshot.sample, way);
  peaks_.take(snapshot.sample.reference);
  result_.worst_saturation = std::max(result_.worst_saturation, snapshot.saturation);
  if (early_) locate(snapshot);
  last_ = snapshot;
  journal_.stand_at(snapshot.sample.reference.q);
  if (listener_.snapshot) listener_.snapshot(snapshot);
}

void RunRecorder::take(const MotionEvent& event) {
  switch (event.kind) {
    case MotionEvent::Kind::SegmentStarted:
      begin_segment(event);
      break;
    case MotionEvent::Kind::DecisionPoint:
      plan_.take_decision(event, running(), running_line());
      break;
    case MotionEvent::Kind::EffectDue:
      take_effect(event);
      break;
    case MotionEvent::Kind::ActionDue:
      if (event.effect.after > 0)
        --result_.dropped_effects;  // a path event is one of the program's
      journal_.take_output(event);
      break;
    case MotionEvent::Kind::PulseOver:
      journal_.end_pulse(event);
      break;
    case MotionEvent::Kind::LateDecision:
      ++result_.starved;
      journal_.add_event(event.time, "late-decision", static_cast<int>(event.tag),
                         "the next motion was not known in time; the target was made exact");
      break;
    case MotionEvent::Kind::LeadMissed:
      journal_.add_event(event.time, "lead", static_cast<int>(event.tag),
                         text_for_missed_lead(event.value));
      break;
    case MotionEvent::Kind::LeadCut:
      journal_.note(static_cast<int>(event.tag), words_for_cut_lead(event.value));
      break;
    case MotionEvent::Kind::Hit:
    case MotionEvent::Kind::Braking:
      begin_early_end(event);
      break;
    case MotionEvent::Kind::Rest:
      rest(event);
      break;
    case MotionEvent::Kind::EffectDropped:
    case MotionEvent::Kind::WentBack:  // at a prompt only
    case MotionEvent::Kind::NoWayBack:
      break;
    case MotionEvent::Kind::JogStopped:
      journal_.add_event(
          event.time, "limit", static_cast<int>(event.tag),
          text_for_stopped_jog(event.axis, event.value, robot_, channels_.jog_bodies.load().get()));
      break;
    case MotionEvent::Kind::Overrun:
      fail(event.time, "overrun", words_for_overrun(event.value));
      break;
    case MotionEvent::Kind::Fault:
      fail(event.time, "fault", words_for_not_finite(event.axis, robot_));
      break;
    case MotionEvent::Kind::PaceFailed:
      journal_.fail(event.time, "fault", words_for_no_pace(), static_cast<int>(event.tag));
      break;
    case MotionEvent::Kind::Unsettled:
      journal_.fail(event.time, "fault", words_for_unsettled(event.off, robot_),
                    static_cast<int>(event.tag));
      break;
    case MotionEvent::Kind::Handling:
      begin_handler(event);
      break;
    case MotionEvent::Kind::HandlerOver:
      end_handler(event);
      break;
    case MotionEvent::Kind::Held:
    case MotionEvent::Kind::Finished:
      stand_still(event);
      break;
  }
}

void RunRecorder::take(const ServoNotice& notice) {
  const Words words = words_for(notice.finding, robot_, channels_.of_machine(notice.finding));
  if (notice.finding.verdict == motion::FollowingFinding::Verdict::Stop) {
    fail(notice.time, "fault", words);
  } else {
    journal_.warn(notice.time, line(), words);
  }
}

void RunRecorder::begin_segment(const MotionEvent& event) {
  const std::optional<LoggedSegment> planned = log_.take_planned(event.number);
  if (!planned) return;  // a stop that the generator made by itself belongs to the line before
  if (planned->from_rest && running_) plan_.add_stop(*running_, line_of(*running_));
  end_segment(event.time, &*planned);
  programmed(*planned);

  slow_.begin(*planned);
  LineTotal& line = line_of(*planned);
  running_ = RunningMotion{*planned, from_, event.time};
  if (listener_.begin) listener_.begin(*running_, event.time);
  if (!planned->further && line.count++ == 0) line.starts = event.time;
  plan_.begin(*running_, event.time, line);
}

void RunRecorder::begin_early_end(const MotionEvent& event) {
  const bool hit = event.kind == MotionEvent::Kind::Hit;
  const std::int64_t number =
      journal_.add_event(event.time, hit ? "hit" : "brake", static_cast<int>(event.tag), "");
  using Ended = LineTotal::Ended;
  early_ = EarlyEnd{number, hit ? Ended::Hit : Ended::Brake, event.time, {}, {}};
}

/// The motion has ended, early or not; its target and its corner count only if it was not.
void RunRecorder::rest(const MotionEvent& event) {
  if (!early_) return end_jog(event.time);
  early_->rest = event.time;
  if (!running_) return;
  line_of(*running_).ended = early_->ended;
  running_->cut = true;
}

/// The first snapshot after the trip shows where it was, the first one at rest where it led.
void RunRecorder::locate(const Snapshot& snapshot) {
  const motion::JointVector& q = snapshot.sample.reference.q;
  if (early_->from.size() == 0) early_->from = q;
  if (!early_->rest) return;
  const motion::Kinematics& tool = *robot_.kinematics;
  const Eigen::Vector3d tip = running_ ? running_->tip : Eigen::Vector3d::Zero();
  const double way =
      (place_of(tip, tool.forward(q)) - place_of(tip, tool.forward(early_->from))).norm();
  if (RunEvent* const event = journal_.find_event(early_->event))
    event->text =
        fmt::format("at rest {} s and {} mm later", shown(*early_->rest - early_->tripped, 3),
                    shown(way * kMillimetresPerMetre, 3));
  reached_ = q;
  early_.reset();
}

void RunRecorder::stand_still(const MotionEvent& event) {
  result_.measured = event.time;
  if (event.kind == MotionEvent::Kind::Held) {  // neither point nor corner has been reached
    if (running_) {
      LineTotal& line = line_of(*running_);
      line.measured += event.time - running_->started;
      line.ended = journal_.failed() ? LineTotal::Ended::Fault : LineTotal::Ended::Brake;
    }
    return;
  }
  end_segment(event.time, nullptr);
  end_corner();
}

void RunRecorder::end_segment(double time, const LoggedSegment* next) {
  end_corner();
  if (!running_) return;
  if (listener_.end) listener_.end(*running_, running_->cut);
  LineTotal& line = line_of(*running_);
  line.measured += time - running_->started;
  if (running_->jog->present()) {
    plan_.add_jog(time - running_->started, line);
    running_->cut = true;
  }
  if (running_->cut) return running_.reset();
  plan_.add_corner(*running_, next, line);
  if (next != nullptr && next->stop) line.exact = true;
  if (next == nullptr && line.count == 1) line.decides.reset();  // nothing follows it
  behind_ = running_;
  running_.reset();
}

void RunRecorder::end_corner() {
  if (!behind_) return;
  if (!behind_->stop) {
    meter_.leave(behind_->number, behind_->tag);
    references_.leave(behind_->number, behind_->tag);
  }
  behind_.reset();
}

/// Adds the misses of the corners that the tool has passed; `all`: the run is over.
void RunRecorder::take_misses(bool all) {
  const auto line = [&](const CornerMeter::Miss& miss) -> LineTotal& {
    return result_.lines.of(static_cast<int>(miss.tag));
  };
  while (const auto miss = meter_.take(all))
    line(*miss).miss_measured.raise_to(miss->least * kMillimetresPerMetre);
  while (const auto miss = references_.take(all))
    plan_.add_miss(line(*miss), miss->least * kMillimetresPerMetre);
}

void RunRecorder::take_effect(const MotionEvent& event) {
  using Kind = Effect::Kind;
  const Kind kind = event.effect.kind;
  if (kind == Kind::Arm || kind == Kind::Disarm || kind == Kind::Report) return;
  --result_.dropped_effects;
  // Inputs are the machine's, simulated or not.
  if (kind == Kind::Override) return change_override(event.time, event.effect.share);
  if (kind == Kind::Load) return;
  if (kind == Kind::Simulate || kind == Kind::SimulateAnalog) return;
  if (kind == Kind::SimulateGo || kind == Kind::SimulateAnswer) return;
  if (kind != Kind::Note) return journal_.take_output(event);
  take_note(event, log_.take_note(event.effect.id));
}

void RunRecorder::change_override(double time, double share) {
  plan_.change_override(time, share, running(), running_line());
}

void RunRecorder::begin_handler(const MotionEvent& event) {
  journal_.add_event(event.time, "when", static_cast<int>(event.tag), "its handler begins");
  interrupted_.emplace(Interrupted{event.time, static_cast<int>(event.tag),
                                   std::exchange(running_, std::nullopt),
                                   std::exchange(behind_, std::nullopt), reached_, path_});
  if (last_) reached_ = last_->sample.reference.q;
}

/// The interrupted motion goes on as though no time had passed, or has come to its end.
void RunRecorder::end_handler(const MotionEvent& event) {
  if (!interrupted_) return;
  const bool left = event.value != 0;
  end_segment(event.time, nullptr);
  end_corner();
  journal_.add_event(event.time, "when", interrupted_->line,
                     left ? "its handler has ended the motion" : "its handler ends");
  running_ = interrupted_->running;
  behind_ = interrupted_->behind;
  const double pause = event.time - interrupted_->time;
  if (running_) {
    running_->started += pause;
    running_->ends += pause;
    running_->cut = left;
    if (left) line_of(*running_).ended = LineTotal::Ended::Brake;
  }
  if (!left) {
    reached_ = interrupted_->reached;
    path_ = interrupted_->path;
  } else if (last_) {
    reached_ = last_->sample.reference.q;
  }
  interrupted_.reset();
}

/// The target that is programmed from here on: a further point, or rates.
void RunRecorder::programmed(const LoggedSegment& planned) {
  if (planned.jog->present()) return path_.unprogrammed(planned.tip);
  if (path_.is_unprogrammed() && last_) reached_ = last_->sample.reference.q;
  from_ = std::exchange(reached_, planned.target);
  meter_.watch(planned.number, planned.target, planned.tip);
  if (!plan_.comes_timed()) references_.watch(planned.number, planned.target, planned.tip);
  const bool on_line = planned.leg != nullptr && planned.leg->line.has_value();
  path_.programmed({planned.path, from_, planned.target, planned.duration}, on_line, planned.tip);
}

/// One that has come to rest where nothing follows.
void RunRecorder::end_jog(double time) {
  if (!running_ || !running_->jog->present()) return;
  running_->cut = true;
  end_segment(time, nullptr);
}

void RunRecorder::take_note(const MotionEvent& event, Note note) {
  const int line = static_cast<int>(event.tag);
  switch (note.kind) {
    case Note::Kind::Print:
      if (listener_.print) listener_.print(note.text);
      if (listener_.said) listener_.said(note.text, event.time, line);
      journal_.print(std::move(note.text));
      return;
    case Note::Kind::Write:
    case Note::Kind::Persist:
    case Note::Kind::Send:
    case Note::Kind::Line:
      if (listener_.write) listener_.write(note, event.time);
      return;
    case Note::Kind::Halt:
    case Note::Kind::Ask:
      if (listener_.consult) listener_.consult(note, line);
      journal_.add_event(event.time, note.kind == Note::Kind::Ask ? "ask" : "halt", line,
                         note.text);
      return;
    case Note::Kind::Answer:
      if (listener_.consult) listener_.consult(note, line);
      journal_.add_event(event.time, "answer", line, note.text);
      return;
  }
}

void RunRecorder::take(const Intervention& intervention) {
  const double time = intervention.time;
  switch (intervention.kind) {
    case Intervention::Kind::Hold:
      journal_.add_event(time, "hold", line(), "the signal script holds the robot");
      return;
    case Intervention::Kind::GoOn:
      journal_.add_event(time, "go", line(), "the signal script lets the robot go on");
      return;
    case Intervention::Kind::Override:
      journal_.add_event(time, "override", line(),
                         fmt::format("the signal script sets the override to {}",
                                     lang::percent_text(intervention.share)));
      return change_override(time, intervention.share);
    case Intervention::Kind::Stop:
      journal_.add_event(time, "stop", line(), "the signal script stops the robot");
      return journal_.interrupt();
    case Intervention::Kind::Forgotten:
      return fail(time, "fault", words_for_endless_hold());
  }
}

/// Where the robot has come to rest. After a fault the axes may be anywhere beside their
/// references.
void RunRecorder::take_stand() {
  const motion::JointVector& reference = last_ ? last_->sample.reference.q : robot_.start;
  const motion::JointVector& measured = last_ ? last_->measured : robot_.start;
  motion::JointVector q = reference;
  for (int i = 0; i < robot_.axis_count(); ++i) {
    const motion::Axis& axis = axis_of(robot_, i);
    if (result_.status != "done" && stands_beside(axis, measured[i], reference[i]))
      q[i] = measured[i];
  }
  result_.final_joints = shown_joints(robot_, q);
  result_.final_measured = shown_joints(robot_, measured);
  result_.final_reference = shown_joints(robot_, reference);
  result_.final_pose = shown_pose(robot_.kinematics->forward(q));
  result_.stands = stand_text(robot_, measured, reference);
}

RunResult RunRecorder::finish() {
  take_misses(true);
  result_.dropped_effects += log_.effects();
  journal_.put_into(result_);
  result_.lost_rows = channels_.lost.load();
  // An instant that is a whole number of periods must not become one cycle more by rounding.
  constexpr double kRounding = 1e-7;
  result_.cycles =
      static_cast<std::int64_t>(std::ceil(result_.measured / robot_.reference_period - kRounding));
  result_.planned = plan_.duration();
  result_.deviation = std::max(plan_.greatest_miss(), path_.deviation() * kMillimetresPerMetre);
  result_.slow_places = slow_.finish();
  result_.peaks = peaks_.peaks();
  take_stand();
  return std::move(result_);
}

}  // namespace rob::runtime
