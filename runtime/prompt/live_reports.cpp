#include "runtime/prompt/live_reports.h"

#include <fmt/format.h>

#include "runtime/run/drain.h"
#include "runtime/words/force_words.h"
#include "runtime/words/state_name.h"
#include "runtime/words/units.h"

namespace rob::runtime {

using motion::Effect;
using motion::MotionEvent;
using motion::MotionState;

void LiveReports::drain() {
  const bool over =
      controller_.motion().over();  // before looking: all that came before is then seen
  Channels& channels = controller_.channels();
  drain_in_order(
      channels, [&](const MotionEvent& event) { take(event); },
      [&](const Snapshot& snapshot) {
        last_ = snapshot;
        forget_stopped_jog();
        if (listener_.snapshot) listener_.snapshot(snapshot);
      });
  ServoNotice notice;
  while (channels.notices.take(notice)) {
    const Words words =
        words_for(notice.finding, controller_.robot(), channels.of_machine(notice.finding));
    const bool stops = notice.finding.verdict == motion::FollowingFinding::Verdict::Stop;
    if (stops) {
      fail(line_, words);
    } else {
      tell(fmt::format("warning: {}", words.message));
    }
  }
  if (failed_ && over) tell_stand();
  if (listener_.drained) listener_.drained();
}

void LiveReports::fail(int line, const Words& words) {
  failed_ = true;
  if (listener_.fault) listener_.fault(line, words);
}

void LiveReports::tell_stand() {
  failed_ = false;
  if (last_)
    tell(fmt::format("the robot stands at {}",
                     stand_text(controller_.robot(), last_->measured, last_->sample.reference.q)));
}

bool LiveReports::moves() const {
  return last_ && last_->sample.state != MotionState::Idle &&
         last_->sample.state != MotionState::Held;
}

std::string LiveReports::state_text() const {
  const motion::RobotModel& robot = controller_.robot();
  if (!last_) return robot.name;
  const MotionState state = last_->sample.state;
  const char* const name = controller_.motion().over()     ? "fault"
                           : state == MotionState::Running ? "moving"
                                                           : state_name(state);
  std::string text = fmt::format("{} {} (", robot.name, name);
  const char* comma = "";
  for (const double place : shown_joints(robot, last_->measured)) {
    text += comma + shown(place, 1);
    comma = ", ";
  }
  return text + ")";
}

/// Once, however often it is tried again there.
void LiveReports::tell_jog_stopped(const MotionEvent& event) {
  const bool again = jog_stopped_ && jog_stopped_->axis == event.axis;
  if (!again)
    tell(text_for_stopped_jog(event.axis, event.value, controller_.robot(),
                              controller_.channels().jog_bodies.load().get()));
  if (last_) jog_stopped_ = {event.axis, last_->sample.reference.q};
}

void LiveReports::forget_stopped_jog() {
  constexpr double kAway = 1e-3;  // m or rad [choice]
  if (jog_stopped_ &&
      (last_->sample.reference.q - jog_stopped_->place).lpNorm<Eigen::Infinity>() > kAway)
    jog_stopped_.reset();
}

void LiveReports::note_planned(const MotionEvent& event) {
  if (const auto planned = controller_.log().take_planned(event.number))
    jogging_ = planned->jog->present();
}

void LiveReports::take(const MotionEvent& event) {
  using Kind = MotionEvent::Kind;
  const motion::RobotModel& robot = controller_.robot();
  const int line = static_cast<int>(event.tag);
  switch (event.kind) {
    case Kind::SegmentStarted:
      note_planned(event);
      line_ = line;
      return;
    case Kind::EffectDue:
      if (event.effect.kind == Effect::Kind::Note)
        take_note(controller_.log().take_note(event.effect.id), event.time);
      return;
    case Kind::Hit:
      note_planned(event);  // one that is hit at its start has not been told as started
      return jogging_ ? void() : tell(fmt::format("line {}: hit", line));
    case Kind::JogStopped:
      return tell_jog_stopped(event);
    case Kind::WentBack:
      return tell(event.tag == 0
                      ? "back on the way that was recorded; outputs are as they were"
                      : fmt::format("back where line {} began; outputs are as they were", line));
    case Kind::NoWayBack:
      return tell("there is no way back from here: what is recorded begins here");
    case Kind::Overrun:
      return fail(line, words_for_overrun(event.value));
    case Kind::Fault:
      return fail(line, words_for_not_finite(event.axis, robot));
    case Kind::PaceFailed:
      return fail(line, words_for_no_pace());
    case Kind::Unsettled:
      return fail(line, words_for_unsettled(event.off, robot));
    default:
      return;
  }
}

void LiveReports::take_note(const Note& note, double time) {
  switch (note.kind) {
    case Note::Kind::Print:
      if (listener_.print) listener_.print(note.text);
      return;
    case Note::Kind::Halt:
    case Note::Kind::Ask:
    case Note::Kind::Answer:
      if (listener_.consult) listener_.consult(note);
      return;
    default:
      if (listener_.keep) listener_.keep(note, time);
  }
}

}  // namespace rob::runtime
