#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <utility>

#include "motion/generate/motion_event.h"
#include "motion/robots/robot_model.h"
#include "runtime/command/program_log.h"
#include "runtime/run/kept_ends.h"
#include "runtime/run/run_result.h"
#include "runtime/run/signal_names.h"
#include "runtime/words/words.h"

namespace rob::runtime {

/// The events of a run, its output and the changes of its outputs as they come, and how it ends.
class RunJournal {
 public:
  RunJournal(const motion::RobotModel& robot, ProgramLog& log, SignalNames names);

  /// Calls it for each change of an output; empty: nobody.
  void tell_signals(std::function<void(const SignalChange&)> listener) {
    signal_listener_ = std::move(listener);
  }
  /// Where the references are when what follows happens.
  void stand_at(const motion::JointVector& q) { joints_ = q; }

  /// `line`: a lang::line_tag(). Returns the number of the event.
  std::int64_t add_event(double time, const char* kind, int line, std::string text);
  /// Null if it is no longer kept.
  RunEvent* find_event(std::int64_t number) { return events_.find(number); }
  /// A finding that is an event, too.
  void warn(double time, int line, const Words& words);
  /// A finding that is none.
  void note(int line, const Words& words);
  void print(std::string text) { output_.push_back(std::move(text)); }
  /// An output that an effect sets.
  void take_output(const motion::MotionEvent& event);
  void end_pulse(const motion::MotionEvent& event) { add_digital(event, false); }

  /// If there are several, mend the first.
  void fail(double time, const char* kind, Words words, int line);
  /// Somebody stops the run.
  void interrupt();
  bool failed() const { return error_.has_value(); }

  /// After the run.
  void put_into(RunResult& result);

 private:
  void add_signal(SignalChange change);
  void add_digital(const motion::MotionEvent& event, bool value);
  void add_analog(const motion::MotionEvent& event);

  const motion::RobotModel& robot_;
  ProgramLog& log_;
  SignalNames names_;
  motion::JointVector joints_;
  KeptEnds<std::string> output_;
  KeptEnds<SignalChange> signals_;
  std::function<void(const SignalChange&)> signal_listener_;
  KeptEnds<RunEvent> events_;
  std::optional<Problem> error_;
  bool interrupted_ = false;
};

}  // namespace rob::runtime
