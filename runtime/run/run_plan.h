#pragma once

#include <cstdint>
#include <map>

#include "motion/generate/motion_event.h"
#include "motion/robots/robot_model.h"
#include "runtime/command/program_log.h"
#include "runtime/run/line_totals.h"

namespace rob::runtime {

/// A motion under way. Times in s.
struct RunningMotion : LoggedSegment {
  motion::JointVector from;
  double started = 0;
  double ends = 0;   ///< as planned, where motions come timed
  bool cut = false;  ///< it came to rest before its target
};

/// The plan of the motions of a run. Under Paul's law a motion is queued with its time.
/// Under the look-ahead law the times come with the whole path: the plan is what was foretold of
/// the run (run.cpp), the miss at a corner is that of the references, and motion itself reports
/// when its decision points come.
class RunPlan {
 public:
  /// `override_share`: 1 is the programmed speed.
  RunPlan(const motion::RobotModel& robot, double override_share);

  bool comes_timed() const { return robot_.law == motion::Law::Paul; }
  /// The motion begins at `time`, s.
  void begin(RunningMotion& motion, double time, LineTotal& line);
  /// The successor of a motion must be known now. It may come before the motion begins.
  void take_decision(const motion::MotionEvent& event, const RunningMotion* running,
                     LineTotal* line);
  /// The motion has been made exact for the next one, which begins at rest.
  void add_stop(const RunningMotion& motion, LineTotal& line);
  /// The rest of the motion takes longer, or less, than was foretold when it began; null: none is
  /// under way.
  void change_override(double time, double share, RunningMotion* running, LineTotal* line);
  /// The references are all that there is of the plan of a jog; `duration`: what it took, s.
  void add_jog(double duration, LineTotal& line);
  /// The corner between the motion and the next one; null: nothing follows it.
  void add_corner(const RunningMotion& motion, const LoggedSegment* next, LineTotal& line);
  /// By how much the references miss a programmed point, mm.
  void add_miss(LineTotal& line, double miss);

  double duration() const { return duration_; }   ///< s
  double greatest_miss() const { return miss_; }  ///< mm

 private:
  void add_time(double time, LineTotal& line);

  const motion::RobotModel& robot_;
  double override_share_;                      ///< with the program's OVERRIDE, at most 1
  std::map<std::uint32_t, double> decisions_;  ///< s, by number, of motions that have not begun
  double duration_ = 0;
  double miss_ = 0;
};

}  // namespace rob::runtime
