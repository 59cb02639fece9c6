#pragma once

#include <functional>
#include <optional>
#include <string>

#include "runtime/run/controller.h"
#include "runtime/words/messages.h"

namespace rob::runtime {

/// Takes what motion reports of a robot at a prompt, and puts it into words as it comes.
class LiveReports {
 public:
  /// All are called from drain(), in motion order; each may be empty.
  struct Listener {
    std::function<void(const std::string& text)> print;  ///< of PRINT
    std::function<void(const std::string& text)> tell;   ///< for people
    std::function<void(const Note& note)> consult;       ///< HALT, ASK, the answer
    std::function<void(int line, const Words& words)> fault;
    std::function<void(const Snapshot& snapshot)> snapshot;
    /// Lines for files and devices; s of the run.
    std::function<void(const Note& note, double time)> keep;
    std::function<void()> drained;
    /// A program has ended, and something of it could not be kept.
    std::function<void(const std::string& why)> not_kept;
  };

  LiveReports(Controller& controller, Listener listener)
      : controller_(controller), listener_(std::move(listener)) {}

  void drain();
  /// The state of the last cycle; none before the first.
  const std::optional<Snapshot>& last() const { return last_; }
  /// As the last cycle says.
  bool moves() const;
  /// s of the run, of the last cycle.
  double time() const { return last_ ? last_->sample.reference.time : 0; }
  /// "gantry idle (0, 0, 0)": robot, state, position in mm and deg.
  std::string state_text() const;
  /// The line under way or done last; 0 before the first.
  int line() const { return line_; }

 private:
  void take(const motion::MotionEvent& event);
  void take_note(const Note& note, double time);
  void fail(int line, const Words& words);
  void note_planned(const motion::MotionEvent& event);
  void tell_stand();
  void tell_jog_stopped(const motion::MotionEvent& event);
  void forget_stopped_jog();
  void tell(const std::string& text) {
    if (listener_.tell) listener_.tell(text);
  }

  Controller& controller_;
  Listener listener_;
  struct JogStopped {
    int axis = -1;
    motion::JointVector place;
  };

  std::optional<Snapshot> last_;
  std::optional<JogStopped> jog_stopped_;  ///< and the axes still stand there
  int line_ = 0;
  bool jogging_ = false;  ///< that a jog ends is no news
  bool failed_ = false;   ///< where the robot comes to rest must still be reported
};

}  // namespace rob::runtime
