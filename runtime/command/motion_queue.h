#pragma once

#include <cstddef>
#include <cstdint>
#include <deque>
#include <optional>

#include "lang/values/pose_math.h"
#include "runtime/command/commanded.h"
#include "runtime/command/commanded_progress.h"
#include "runtime/command/guard.h"
#include "runtime/command/loads.h"
#include "runtime/command/next_motion.h"
#include "runtime/command/settling.h"

namespace rob::runtime {

/// The motions, stops and dwells of a program on their way into the buffer, and how the last one
/// comes to rest. Those of a PATH are kept back until its end. Where a call answers `Later` there
/// is no room, or a jog has not reported where it has led.
class MotionQueue {
 public:
  MotionQueue(const RobotLinks& links, CommandedProgress& progress, const Guard& guard,
              NextMotion& next, Loads& loads)
      : links_(links),
        progress_(progress),
        guard_(guard),
        next_(next),
        loads_(loads),
        settling_(links.robot, links.log) {}

  /// Before the run: no handler will ask for take_after().
  void keep_nothing() { keeps_commanded_ = false; }
  /// While a program is foretold nothing waits for the measured robot.
  void leave_out_settling() { settling_.leave_out(); }

  bool full() const { return links_.buffer.full(); }
  std::size_t room() const { return links_.buffer.room(); }

  // After all else
  /// A motion, and a stop that makes its target exact if the command asks for it; there is room for
  /// both.
  void add_motion(int line, Commanded commanded);
  void add_brakable(Commanded commanded);
  void add(Commanded commanded);
  void add(const motion::SegmentDescriptor& segment, bool stop, bool further = false) {
    add(Commanded{segment, stop, further});
  }

  /// The last target exactly, and the robot is in position.
  lang::Reply stop(int line);
  /// The last target exactly, whether or not the robot has been measured there.
  lang::Reply make_exact(int line);
  /// stop(), then a dwell of so many seconds: one statement with those that follow until
  /// end_wait().
  lang::Reply dwell(int line, double seconds);
  /// dwell() as a whole statement.
  lang::Reply dwell_alone(int line, double seconds);
  void end_wait() { begun_ = false; }
  /// BRAKE. A motion that STOP, WAIT or UNTIL has brought to rest is not braked.
  lang::Reply brake();
  /// From here on brake() leaves alone all that was commanded so far.
  void bar_brake() { brakable_ = 0; }

  /// Whether it is known where the last motion leads: a jog must come to rest before.
  bool rested();
  /// How the last motion has ended, which was guarded or a jog, once it has.
  bool take_end(motion::Rest& rest);
  /// The last jog has ended there.
  void come_to_rest(const motion::JointVector& q);
  /// The axes stand at q, where all that was commanded has ended early.
  void restart_from(const motion::JointVector& q);
  /// Takes all that guarded or braked motions have reported.
  void forget_rests();
  /// A WHEN has ended all that was commanded.
  void drop();

  /// Tip of the tool that the last motion was for, seen from the flange, m.
  const lang::Vector3& moved_tip() const { return moved_tip_; }
  void move_tip(const lang::Vector3& tip) { moved_tip_ = tip; }

  // PATH
  void open_path();
  bool path_open() const { return path_.has_value(); }
  /// Its motions are kept back.
  bool collecting() const { return path_ && !path_->closed; }
  bool path_closed() const { return path_ && path_->closed; }
  std::deque<Commanded>& path_motions() { return path_->motions; }
  /// From here on send_path() sends them; true when all have been sent.
  void close_path() { path_->closed = true; }
  bool send_path();
  /// The part of the PATH that has not been queued is as though it had never been commanded.
  void drop_path();

  // After a handler that leaves the path
  /// The commands after this number that may not have begun; they are not kept any more.
  std::deque<Commanded> take_after(std::uint32_t number);
  /// The motions of the PATH are about to be planned anew.
  void reopen_path() { path_->before = links_.planner.mark(); }
  /// They cannot be.
  void forget_path() { path_.reset(); }
  /// Commands that have been planned anew: these, then those of the PATH.
  void add_again(std::deque<Commanded> commanded);

 private:
  struct Path {
    motion::MotionPlanner::Mark before;
    // As they were before it:
    bool exact;
    std::uint32_t brakable;
    lang::Vector3 moved_tip;
    std::deque<Commanded> motions{};  ///< that are not in the buffer yet
    bool closed = false;
  };

  bool take_jog_rest(motion::Rest& rest);
  /// The next command comes after this one.
  void follow(const motion::SegmentDescriptor& segment);
  /// Into the buffer, in which there is room.
  void send(Commanded commanded);
  void remember(Commanded commanded);
  /// A segment that makes the last target exact and waits until the robot is in position; none
  /// where it is.
  std::optional<motion::SegmentDescriptor> settled_stop(int line);

  const RobotLinks& links_;
  CommandedProgress& progress_;
  const Guard& guard_;
  NextMotion& next_;
  Loads& loads_;
  Settling settling_;
  lang::Vector3 moved_tip_;
  std::uint32_t sent_ = 0;      ///< number of the last segment in the buffer
  std::uint32_t brakable_ = 0;  ///< number of the last motion; 0 where a barrier stands after it
  bool braking_ = false;        ///< the generator has been asked to brake
  bool begun_ = false;          ///< the current statement has queued its first segment
  std::optional<Path> path_;
  std::deque<Commanded> commanded_;  ///< the last ones, at least all that are in the buffer
  bool keeps_commanded_ = true;
};

}  // namespace rob::runtime
