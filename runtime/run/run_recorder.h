#pragma once

#include <cstdint>
#include <functional>
#include <map>
#include <optional>
#include <string>
#include <utility>

#include "motion/robots/robot_model.h"
#include "runtime/command/program_log.h"
#include "runtime/run/corner_meter.h"
#include "runtime/run/kept_ends.h"
#include "runtime/run/path_meter.h"
#include "runtime/run/peak_meter.h"
#include "runtime/run/run_result.h"
#include "runtime/run/signal_names.h"
#include "runtime/run/slow_places.h"
#include "runtime/tick/channels.h"
#include "runtime/words/messages.h"

namespace rob::runtime {

/// Watches a run and makes its RunResult: per line what was planned and what was measured, every
/// effect, event and peak. It reads the channels, in one thread that has no deadline.
class RunRecorder {
 public:
  /// All are called from drain(), in motion order; each may be empty.
  struct Listener {
    std::function<void(const std::string& text)> print;
    std::function<void(const Snapshot& snapshot)> snapshot;
    /// HALT or ASK waits for the operator; and that it does no more.
    std::function<void(const Note& note, int line)> consult{};
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
  /// After the last drain(): closes the books. The caller adds the error of the program.
  RunResult finish();

 private:
  struct Running : LoggedSegment {
    motion::JointVector from;
    double started = 0;
    double ends = 0;   ///< as planned, where motions come timed
    bool cut = false;  ///< it came to rest before its target
  };
  /// A motion that brakes, until it is known where it came to rest.
  struct EarlyEnd {
    std::int64_t event;  ///< its number
    LineTotal::Ended ended;
    double tripped;            ///< s
    motion::JointVector from;  ///< where it was then; empty until it is known
    std::optional<double> rest;
  };

  void take(const motion::MotionEvent& event);
  void begin_handler(const motion::MotionEvent& event);
  void end_handler(const motion::MotionEvent& event);
  void take(const ServoNotice& notice);
  void take(const Intervention& intervention);
  void take(const Snapshot& snapshot);
  void begin_segment(const motion::MotionEvent& event);
  void end_segment(double time, const LoggedSegment* next);
  // The planned motions (run_recorder_planned.cpp)
  bool comes_timed() const { return robot_.law == motion::Law::Paul; }
  void plan(const LoggedSegment& planned, const motion::MotionEvent& event, LineTotal& line);
  void take_decision(const motion::MotionEvent& event);
  void count_stop();
  void plan_jog(double duration);
  void plan_corner(const LoggedSegment* next);
  void take_misses(bool all);
  void add_planned_miss(LineTotal& line, double miss);
  void programmed(const LoggedSegment& planned);
  void end_jog(double time);
  void stop_jog(const motion::MotionEvent& event);
  void begin_early_end(const motion::MotionEvent& event);
  void rest(const motion::MotionEvent& event);
  void locate(const Snapshot& snapshot);
  void stand_still(const motion::MotionEvent& event);
  void end_corner();
  void take_effect(const motion::MotionEvent& event);
  void change_override(double time, double share);
  void take_note(const motion::MotionEvent& event, Note note);
  void take_output(const motion::MotionEvent& event);
  void add_output(const motion::MotionEvent& event, bool value);
  void add_analog(const motion::MotionEvent& event);
  /// mm or deg.
  std::vector<double> shown_joints(const motion::JointVector& q) const;
  void take_stand();
  void add_event(double time, const char* kind, int line, std::string text);
  /// `line`: its tag; none: that of the motion that runs.
  void fail(double time, const char* kind, Words words, std::optional<int> line = {});
  LineTotal& line_of(const LoggedSegment& segment) {
    return result_.lines.of(static_cast<int>(segment.tag));
  }

  const motion::RobotModel& robot_;
  double override_share_;  ///< with the program's OVERRIDE, at most 1
  Channels& channels_;
  ProgramLog& log_;
  SignalNames names_;
  Listener listener_;
  CornerMeter meter_;
  CornerMeter references_;                     ///< the same of the references; by law
  std::map<std::uint32_t, double> decisions_;  ///< s, by number, of motions that have not begun
  PathMeter path_;
  SlowPlaces slow_;
  PeakMeter peaks_;
  RunResult result_;
  KeptEnds<std::string> output_;
  KeptEnds<SignalChange> signals_;
  KeptEnds<RunEvent> events_;
  std::optional<Running> running_;
  std::optional<Running> behind_;  ///< the one before, whose corner running_ makes
  motion::JointVector from_;       ///< where the leg that was programmed last begins
  motion::JointVector reached_;    ///< the last programmed point
  std::optional<EarlyEnd> early_;
  /// The state that a handler has interrupted.
  struct Interrupted {
    double time;  ///< s
    int line;     ///< of the WHEN
    std::optional<Running> running;
    std::optional<Running> behind;
    motion::JointVector reached;
    PathMeter path;
  };
  std::optional<Interrupted> interrupted_;
  std::optional<Snapshot> last_;
};

}  // namespace rob::runtime
