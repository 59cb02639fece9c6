#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <utility>

#include "motion/robots/robot_model.h"
#include "runtime/command/program_log.h"
#include "runtime/run/corner_meter.h"
#include "runtime/run/path_meter.h"
#include "runtime/run/peak_meter.h"
#include "runtime/run/run_journal.h"
#include "runtime/run/run_plan.h"
#include "runtime/run/run_result.h"
#include "runtime/run/signal_names.h"
#include "runtime/run/slow_places.h"
#include "runtime/tick/channels.h"
#include "runtime/words/messages.h"

namespace rob::runtime {

/// Watches a run and makes its RunResult: per line what was planned (RunPlan) and what was
/// measured, every effect, event (RunJournal) and peak. It reads the channels, in one thread that
/// has no deadline.
class RunRecorder {
 public:
  /// All are called from drain(), in motion order; each may be empty.
  struct Listener {
    std::function<void(const std::string& text)> print;
    std::function<void(const Snapshot& snapshot)> snapshot;
    /// HALT or ASK waits for the operator; and that it does no more.
    std::function<void(const Note& note, int line)> consult{};
    /// A line of WRITE, a value to be kept, what is sent to a device or simulated of it.
    std::function<void(const Note& note, double time)> write{};
    /// A motion begins: s.
    std::function<void(const LoggedSegment& motion, double time)> begin{};
    /// It is over; early: it has not come to its end.
    std::function<void(const LoggedSegment& motion, bool early)> end{};
    /// An output has changed; a PRINT of a line has come.
    std::function<void(const SignalChange& change)> signal{};
    std::function<void(const std::string& text, double time, int line)> said{};
  };

  RunRecorder(const motion::RobotModel& robot, double override_share, Channels& channels,
              ProgramLog& log, SignalNames names, Listener listener);

  /// Before the run: what was foretold of its lines, by LineTotals::expect().
  void expect(LineTotals lines) { result_.lines = std::move(lines); }
  /// Takes everything that has come up the channels.
  void drain();
  /// The line that runs now; 0 before the first.
  int line() const { return running_ ? static_cast<int>(running_->tag) : 0; }
  motion::MotionState state() const {
    return last_ ? last_->sample.state : motion::MotionState::Idle;
  }
  /// The time of the last snapshot, s.
  double time() const { return last_ ? last_->sample.reference.time : 0; }
  /// After the last drain(): closes the books. The caller adds what the program did wrong.
  RunResult finish();

 private:
  /// A motion that brakes, until it is known where it came to rest.
  struct EarlyEnd {
    std::int64_t event;  ///< its number
    LineTotal::Ended ended;
    double tripped;            ///< s
    motion::JointVector from;  ///< where it was then; empty until it is known
    std::optional<double> rest;
  };
  /// The motion that a handler has interrupted.
  struct Interrupted {
    double time;  ///< s
    int line;     ///< of the WHEN
    std::optional<RunningMotion> running;
    std::optional<RunningMotion> behind;
    motion::JointVector reached;
    PathMeter path;
  };

  void take(const motion::MotionEvent& event);
  void take(const ServoNotice& notice);
  void take(const Intervention& intervention);
  void take(const Snapshot& snapshot);
  void begin_segment(const motion::MotionEvent& event);
  void end_segment(double time, const LoggedSegment* next);
  void programmed(const LoggedSegment& planned);
  void end_corner();
  void take_misses(bool all);
  void begin_early_end(const motion::MotionEvent& event);
  void rest(const motion::MotionEvent& event);
  void end_jog(double time);
  void locate(const Snapshot& snapshot);
  void stand_still(const motion::MotionEvent& event);
  void begin_handler(const motion::MotionEvent& event);
  void end_handler(const motion::MotionEvent& event);
  void take_effect(const motion::MotionEvent& event);
  void take_note(const motion::MotionEvent& event, Note note);
  void change_override(double time, double share);
  void take_stand();
  /// The clock of the motion that runs.
  void fail(double time, const char* kind, Words words) {
    journal_.fail(time, kind, std::move(words), line());
  }
  LineTotal& line_of(const LoggedSegment& segment) {
    return result_.lines.of(static_cast<int>(segment.tag));
  }
  LineTotal* running_line() { return running_ ? &line_of(*running_) : nullptr; }
  RunningMotion* running() { return running_ ? &*running_ : nullptr; }

  const motion::RobotModel& robot_;
  Channels& channels_;
  ProgramLog& log_;
  Listener listener_;
  RunJournal journal_;
  RunPlan plan_;
  CornerMeter meter_;
  CornerMeter references_;  ///< the same of the references; by law
  PathMeter path_;
  SlowPlaces slow_;
  PeakMeter peaks_;
  RunResult result_;
  std::optional<RunningMotion> running_;
  std::optional<RunningMotion> behind_;  ///< the one before, whose corner running_ makes
  motion::JointVector from_;             ///< where the leg that was programmed last begins
  motion::JointVector reached_;          ///< the last programmed point
  std::optional<EarlyEnd> early_;
  std::optional<Interrupted> interrupted_;
  std::optional<Snapshot> last_;
};

}  // namespace rob::runtime
