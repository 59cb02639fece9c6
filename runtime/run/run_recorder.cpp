#include "runtime/run/run_recorder.h"
#include "runtime/words/force_words.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "runtime/words/codes.h"
#include "runtime/words/units.h"

namespace rob::runtime {

using motion::Effect;
using motion::MotionEvent;

RunRecorder::RunRecorder(const motion::RobotModel& robot, double override_share, Channels& channels,
                         ProgramLog& log, SignalNames names, Listener listener)
    : robot_(robot),
      override_share_(std::min(override_share, 1.0)),
      channels_(channels),
      log_(log),
      names_(std::move(names)),
      listener_(std::move(listener)),
      meter_(*robot.kinematics),
      references_(*robot.kinematics),
      path_(*robot.kinematics, robot.start),
      slow_(robot),
      peaks_(robot),
      reached_(robot.start) {
  result_.robot = robot.name;
  result_.law = motion::law_name(robot.law);
}

void RunRecorder::drain() {
  Intervention intervention;
  while (channels_.interventions.take(intervention)) take(intervention);
  while (const Snapshot* const snapshot = channels_.snapshots.front()) {
    const MotionEvent* event = nullptr;
    while ((event = channels_.events.front()) != nullptr &&
           event->time <= snapshot->sample.reference.time) {
      take(*event);
      channels_.events.pop();
    }
    take(*snapshot);
    channels_.snapshots.pop();
  }
  MotionEvent event;
  while (channels_.events.take(event)) take(event);
  ServoNotice notice;
  while (channels_.notices.take(notice)) take(notice);
}

void RunRecorder::take(const Snapshot& snapshot) {
  meter_.measured(snapshot.measured, snapshot.pressed);
  if (!comes_timed()) references_.measured(snapshot.sample.reference.q, snapshot.pressed);
  take_misses(false);
  const double way = path_.reference(snapshot.sample.reference.q);
  if (running_) line_of(*running_).way += way * kMillimetresPerMetre;
  if (!comes_timed()) slow_.take(snapshot.sample, way);
  peaks_.take(snapshot.sample.reference);
  result_.worst_saturation = std::max(result_.worst_saturation, snapshot.saturation);
  if (early_) locate(snapshot);
  last_ = snapshot;
  if (listener_.snapshot) listener_.snapshot(snapshot);
}

void RunRecorder::take(const MotionEvent& event) {
  switch (event.kind) {
    case MotionEvent::Kind::SegmentStarted:
      begin_segment(event);
      break;
    case MotionEvent::Kind::DecisionPoint:
      take_decision(event);
      break;
    case MotionEvent::Kind::EffectDue:
      take_effect(event);
      break;
    case MotionEvent::Kind::ActionDue:
      if (event.effect.after > 0)
        --result_.dropped_effects;  // a path event is one of the program's
      take_output(event);
      break;
    case MotionEvent::Kind::PulseOver:
      add_output(event, false);
      break;
    case MotionEvent::Kind::LateDecision:
      ++result_.starved;
      add_event(event.time, "late-decision", static_cast<int>(event.tag),
                "the next motion was not known in time; the target was made exact");
      break;
    case MotionEvent::Kind::LeadMissed:
      add_event(event.time, "lead", static_cast<int>(event.tag), text_for_missed_lead(event.value));
      break;
    case MotionEvent::Kind::LeadCut: {
      const Words words = words_for_cut_lead(event.value);
      log_.found({lang::Severity::Warning, words.code,
                  lang::tagged_place(static_cast<int>(event.tag)), words.message, words.help});
      break;
    }
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
      stop_jog(event);
      break;
    case MotionEvent::Kind::Overrun:
      fail(event.time, "overrun", words_for_overrun(event.value));
      break;
    case MotionEvent::Kind::Fault:
      fail(event.time, "fault", words_for_not_finite(event.axis, robot_));
      break;
    case MotionEvent::Kind::PaceFailed:
      fail(event.time, "fault", words_for_no_pace(), static_cast<int>(event.tag));
      break;
    case MotionEvent::Kind::Unsettled:
      fail(event.time, "fault", words_for_unsettled(event.off, robot_),
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
    add_event(notice.time, "warning", line(), words.message);
    log_.found({lang::Severity::Warning, words.code, lang::tagged_place(line()), words.message,
                words.help});
  }
}

void RunRecorder::begin_segment(const MotionEvent& event) {
  const std::optional<LoggedSegment> planned = log_.take_planned(event.number);
  if (!planned) return;  // a stop that the generator made by itself belongs to the line before
  if (planned->from_rest) count_stop();
  end_segment(event.time, &*planned);
  programmed(*planned);

  slow_.begin(*planned);
  LineTotal& line = line_of(*planned);
  running_ = Running{*planned, from_, event.time};
  if (!planned->further && line.count++ == 0) line.starts = event.time;
  plan(*planned, event, line);
}

void RunRecorder::begin_early_end(const MotionEvent& event) {
  const bool hit = event.kind == MotionEvent::Kind::Hit;
  add_event(event.time, hit ? "hit" : "brake", static_cast<int>(event.tag), "");
  using Ended = LineTotal::Ended;
  early_ = EarlyEnd{events_.count() - 1, hit ? Ended::Hit : Ended::Brake, event.time, {}, {}};
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
  if (RunEvent* const event = events_.find(early_->event))
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
      line.ended = result_.error ? LineTotal::Ended::Fault : LineTotal::Ended::Brake;
    }
    return;
  }
  end_segment(event.time, nullptr);
  end_corner();
}

void RunRecorder::end_segment(double time, const LoggedSegment* next) {
  end_corner();
  if (!running_) return;
  LineTotal& line = line_of(*running_);
  line.measured += time - running_->started;
  if (running_->jog->present()) plan_jog(time - running_->started);
  if (running_->cut) return running_.reset();
  plan_corner(next);
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
    add_planned_miss(line(*miss), miss->least * kMillimetresPerMetre);
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
  if (kind != Kind::Note) return take_output(event);
  take_note(event, log_.take_note(event.effect.id));
}

void RunRecorder::take_output(const MotionEvent& event) {
  const bool analog = event.effect.kind == Effect::Kind::Analog;
  if (analog) {
    add_analog(event);
  } else {
    add_output(event, event.effect.kind == Effect::Kind::Pulse || event.effect.value);
  }
  if (event.effect.safe) {
    add_event(
        event.time, "safe", static_cast<int>(event.tag),
        fmt::format("{} takes its SAFE value", analog ? names_.analog_output(event.effect.channel)
                                                      : names_.output(event.effect.channel)));
  }
}

void RunRecorder::add_output(const MotionEvent& event, bool value) {
  signals_.push_back({.time = event.time,
                      .name = names_.output(event.effect.channel),
                      .value = value,
                      .line = static_cast<int>(event.tag)});
}

void RunRecorder::add_analog(const MotionEvent& event) {
  constexpr double kSame = 1e-9;  // V: what rounding can add at the end of a SCALE
  const int line = static_cast<int>(event.tag);
  const int channel = event.effect.channel;
  const double volts = motion::within_analog_range(event.effect.volts);
  const std::string name = names_.analog_output(channel);
  const SignalNames::Quantity carried = names_.quantity(channel, volts);
  signals_.push_back({.time = event.time,
                      .name = name,
                      .number = carried.number,
                      .unit = carried.unit,
                      .line = line});
  if (std::abs(event.effect.volts - volts) <= kSame) return;
  const std::string text =
      fmt::format("{}: {} is beyond what the channel carries; it is set to {}", name,
                  names_.quantity(channel, event.effect.volts).text, carried.text);
  add_event(event.time, "warning", line, text);
  log_.found({lang::Severity::Warning, code::kAnalogCut, lang::tagged_place(line), text,
              "keep the value within its SCALE, or give the signal a wider one"});
}

void RunRecorder::add_event(double time, const char* kind, int line, std::string text) {
  events_.push_back({time, kind, line, std::move(text),
                     shown_joints(last_ ? last_->sample.reference.q : robot_.start)});
}

void RunRecorder::fail(double time, const char* kind, Words words, std::optional<int> line) {
  const int tag = line.value_or(this->line());
  add_event(time, kind, tag, words.message);
  if (result_.error) return;  // the first cause is the one to mend
  result_.status = "fault";
  result_.exit_code = ExitCode::Fault;
  result_.error = Problem{std::move(words.code), "", lang::tagged_place(tag),
                          std::move(words.message), std::move(words.help)};
}

std::vector<double> RunRecorder::shown_joints(const motion::JointVector& q) const {
  std::vector<double> shown;
  for (int i = 0; i < robot_.axis_count(); ++i) {
    shown.push_back(q[i] * shown_per_si(robot_.axes[static_cast<std::size_t>(i)].kind));
  }
  return shown;
}

/// Where the robot has come to rest. After a fault the axes may be anywhere beside their
/// references.
void RunRecorder::take_stand() {
  const motion::JointVector& reference = last_ ? last_->sample.reference.q : robot_.start;
  const motion::JointVector& measured = last_ ? last_->measured : robot_.start;
  motion::JointVector q = reference;
  for (int i = 0; i < robot_.axis_count(); ++i) {
    const motion::Axis& axis = robot_.axes[static_cast<std::size_t>(i)];
    if (result_.status != "done" && stands_beside(axis, measured[i], reference[i]))
      q[i] = measured[i];
  }
  result_.final_joints = shown_joints(q);
  result_.final_measured = shown_joints(measured);
  result_.final_reference = shown_joints(reference);
  result_.final_pose = shown_pose(robot_.kinematics->forward(q));
  result_.stands = stand_text(robot_, measured, reference);
}

RunResult RunRecorder::finish() {
  take_misses(true);
  result_.dropped_effects += log_.effects();
  result_.output_count = output_.count();
  result_.output = output_.take();
  result_.signals_count = signals_.count();
  result_.signals = signals_.take();
  result_.events_count = events_.count();
  result_.events = events_.take();
  result_.findings = log_.findings();
  result_.findings_left_out = log_.findings_left_out();
  result_.lost_rows = channels_.lost.load();
  // An instant that is a whole number of periods must not become one cycle more by rounding.
  constexpr double kRounding = 1e-7;
  result_.cycles =
      static_cast<std::int64_t>(std::ceil(result_.measured / robot_.reference_period - kRounding));
  result_.deviation = std::max(result_.deviation, path_.deviation() * kMillimetresPerMetre);
  result_.slow_places = slow_.finish();
  result_.peaks = peaks_.peaks();
  take_stand();
  return std::move(result_);
}

}  // namespace rob::runtime
