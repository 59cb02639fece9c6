#include "runtime/run/run_journal.h"

#include <fmt/format.h>

#include <cmath>
#include <utility>

#include "runtime/words/codes.h"
#include "runtime/words/units.h"

namespace rob::runtime {

using motion::Effect;
using motion::MotionEvent;

RunJournal::RunJournal(const motion::RobotModel& robot, ProgramLog& log, SignalNames names)
    : robot_(robot), log_(log), names_(std::move(names)), joints_(robot.start) {}

std::int64_t RunJournal::add_event(double time, const char* kind, int line, std::string text) {
  events_.push_back({time, kind, line, std::move(text), shown_joints(robot_, joints_)});
  return events_.count() - 1;
}

void RunJournal::warn(double time, int line, const Words& words) {
  add_event(time, "warning", line, words.message);
  note(line, words);
}

void RunJournal::note(int line, const Words& words) {
  log_.found(
      {lang::Severity::Warning, words.code, lang::tagged_place(line), words.message, words.help});
}

void RunJournal::take_output(const MotionEvent& event) {
  const Effect& effect = event.effect;
  const bool analog = effect.kind == Effect::Kind::Analog;
  if (analog) {
    add_analog(event);
  } else {
    add_digital(event, effect.kind == Effect::Kind::Pulse || effect.value);
  }
  if (!effect.safe) return;
  add_event(event.time, "safe", static_cast<int>(event.tag),
            fmt::format("{} takes its SAFE value", analog ? names_.analog_output(effect.channel)
                                                          : names_.output(effect.channel)));
}

void RunJournal::add_signal(SignalChange change) {
  if (signal_listener_) signal_listener_(change);
  signals_.push_back(std::move(change));
}

void RunJournal::add_digital(const MotionEvent& event, bool value) {
  add_signal({.time = event.time,
              .name = names_.output(event.effect.channel),
              .value = value,
              .line = static_cast<int>(event.tag)});
}

void RunJournal::add_analog(const MotionEvent& event) {
  constexpr double kSame = 1e-9;  // V: what rounding can add at the end of a SCALE
  const int line = static_cast<int>(event.tag);
  const int channel = event.effect.channel;
  const double volts = motion::within_analog_range(event.effect.volts);
  const std::string name = names_.analog_output(channel);
  const SignalNames::Quantity carried = names_.quantity(channel, volts);
  add_signal({.time = event.time,
              .name = name,
              .number = carried.number,
              .unit = carried.unit,
              .line = line});
  if (std::abs(event.effect.volts - volts) <= kSame) return;
  warn(event.time, line,
       {code::kAnalogCut,
        fmt::format("{}: {} is beyond what the channel carries; it is set to {}", name,
                    names_.quantity(channel, event.effect.volts).text, carried.text),
        "keep the value within its SCALE, or give the signal a wider one"});
}

void RunJournal::fail(double time, const char* kind, Words words, int line) {
  add_event(time, kind, line, words.message);
  if (error_) return;
  error_ = Problem{std::move(words.code), "", lang::tagged_place(line), std::move(words.message),
                   std::move(words.help)};
}

void RunJournal::interrupt() { interrupted_ = interrupted_ || !failed(); }

void RunJournal::put_into(RunResult& result) {
  if (interrupted_) {
    result.status = "interrupted";
    result.exit_code = ExitCode::Interrupted;
  }
  if (error_) {
    result.status = "fault";
    result.exit_code = ExitCode::Fault;
    result.error = std::move(error_);
  }
  result.output_count = output_.count();
  result.output = output_.take();
  result.signals_count = signals_.count();
  result.signals = signals_.take();
  result.events_count = events_.count();
  result.events = events_.take();
  result.findings = log_.findings();
  result.findings_left_out = log_.findings_left_out();
}

}  // namespace rob::runtime
