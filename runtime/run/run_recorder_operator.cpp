#include <fmt/format.h>

#include <utility>

#include "lang/values/percent_text.h"
#include "runtime/run/run_recorder.h"

/// Member functions of RunRecorder for the operator, and for a signal script in the operator's
/// place.
namespace rob::runtime {

using motion::MotionEvent;

void RunRecorder::take_note(const MotionEvent& event, Note note) {
  const int line = static_cast<int>(event.tag);
  switch (note.kind) {
    case Note::Kind::Print:
      if (listener_.print) listener_.print(note.text);
      output_.push_back(std::move(note.text));
      return;
    case Note::Kind::Halt:
    case Note::Kind::Ask:
      if (listener_.consult) listener_.consult(note, line);
      add_event(event.time, note.kind == Note::Kind::Ask ? "ask" : "halt", line, note.text);
      return;
    case Note::Kind::Answer:
      if (listener_.consult) listener_.consult(note, line);
      add_event(event.time, "answer", line, note.text);
      return;
  }
}

void RunRecorder::take(const Intervention& intervention) {
  const double time = intervention.time;
  switch (intervention.kind) {
    case Intervention::Kind::Hold:
      return add_event(time, "hold", line(), "the signal script holds the robot");
    case Intervention::Kind::GoOn:
      return add_event(time, "go", line(), "the signal script lets the robot go on");
    case Intervention::Kind::Override:
      add_event(time, "override", line(),
                fmt::format("the signal script sets the override to {}",
                            lang::percent_text(intervention.share)));
      return change_override(time, intervention.share);
    case Intervention::Kind::Stop:
      add_event(time, "stop", line(), "the signal script stops the robot");
      if (result_.error) return;
      result_.status = "interrupted";
      result_.exit_code = ExitCode::Interrupted;
      return;
    case Intervention::Kind::Forgotten:
      return fail(time, "fault", words_for_endless_hold());
  }
}

}  // namespace rob::runtime
