#include "runtime/prompt/live_reports.h"
#include "runtime/words/force_words.h"
#include "runtime/words/units.h"

#include <fmt/format.h>

namespace rob::runtime {

using motion::Effect;
using motion::MotionEvent;

void LiveReports::drain() {
  const bool over =
      controller_.motion().over();  // before looking: all that came before is then seen
  Channels& channels = controller_.channels();
  Snapshot snapshot;
  while (channels.snapshots.take(snapshot)) {
    const MotionEvent* event = nullptr;
    while ((event = channels.events.front()) != nullptr &&
           event->time <= snapshot.sample.reference.time) {
      take(*event);
      channels.events.pop();
    }
    last_ = snapshot;
    if (listener_.snapshot) listener_.snapshot(snapshot);
  }
  MotionEvent event;
  while (channels.events.take(event)) take(event);
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

void LiveReports::take(const MotionEvent& event) {
  using Kind = MotionEvent::Kind;
  const motion::RobotModel& robot = controller_.robot();
  const int line = static_cast<int>(event.tag);
  switch (event.kind) {
    case Kind::SegmentStarted:
      if (const auto planned = controller_.log().take_planned(event.number))
        jogging_ = planned->jog->present();
      line_ = line;
      return;
    case Kind::EffectDue:
      if (event.effect.kind == Effect::Kind::Note)
        take_note(controller_.log().take_note(event.effect.id));
      return;
    case Kind::Hit:
      return jogging_ ? void() : tell(fmt::format("line {}: hit", line));
    case Kind::JogStopped:
      return tell(text_for_stopped_jog(event.axis, robot));
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

void LiveReports::take_note(const Note& note) {
  if (note.kind != Note::Kind::Print) {
    if (listener_.consult) listener_.consult(note);
  } else if (listener_.print) {
    listener_.print(note.text);
  }
}

}  // namespace rob::runtime
