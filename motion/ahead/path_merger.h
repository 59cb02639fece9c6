#pragma once

#include <memory>
#include <optional>
#include <utility>
#include <vector>

#include "motion/ahead/curve_axes.h"
#include "motion/ahead/leg_queue.h"
#include "motion/ahead/merge_rules.h"
#include "motion/ahead/path_item.h"
#include "motion/path/curve_fit.h"
#include "motion/plan/look_ahead_buffer.h"
#include "motion/robots/robot_model.h"

namespace rob::motion {

/// Takes the motions out of the LookAheadBuffer and makes smooth curves of those that crowd: legs
/// that are too short for the corners at their ends, or are passed in a few periods, as a program
/// of short chords has them. All others pass as they are.
///
/// A crowd of legs becomes one curve (CurveFit) within their zones. It begins and ends on the long
/// legs beside it, or where the path does. Its items join with continuous second derivatives, so
/// there is no corner between them.
///
/// Merged are straight motions of linear axes, and straight lines of an arm's tool along which it
/// does not turn, away from singular places. Where a mean of the axes bounds the jerk, it needs a
/// part of the zone and slows all of the run: there only many legs that crowd make a curve.
///
/// m, rad, s. Belongs to the planner's thread.
class PathMerger {
 public:
  /// `most_members`: motions that may begin in one item.
  PathMerger(const RobotModel& robot, LookAheadBuffer& buffer, std::size_t most_members);

  /// The next item; none where that depends on what is not known yet, or nothing is known.
  std::optional<PathItem> next();
  /// It has taken motions that it has not handed out yet.
  bool holds() const { return run_.has_value() || !queue_.empty(); }
  /// Legs that a curve under way has taken since this was asked last.
  std::size_t grown() { return run_ ? std::exchange(grown_, 0) : 0; }
  /// Makes do with what is known: next() waits for no more until it has handed out all of it.
  void flush() { queue_.flush(); }
  /// Forgets all that it holds; calls give_up(segment) for each motion.
  template <typename GiveUp>
  void drop(GiveUp&& give_up) {
    if (run_)
      for (const Member& member : run_->members) give_up(member.segment);
    for (const LegQueue::Waiting& waiting : queue_) give_up(waiting.segment);
    run_.reset();
    queue_.clear();
    before_.reset();
    queue_.wait();
  }

 private:
  /// One on a curve: the vertices of the polyline between which it lies.
  struct Member {
    SegmentDescriptor segment;
    std::size_t from = 0;
    std::size_t to = 0;
    double beyond = 0;  ///< m by which it goes on after the curve
    bool begins = true;
    std::shared_ptr<const PathStretch> part;  ///< of a tool's line: on which it lies
  };
  /// A curve under way.
  struct Run {
    explicit Run(const MergeRules::Knots& knots)
        : fit(knots.apart, knots.stiffness, knots.order), by_jerk(knots.order == 3) {}
    CurveFit fit;
    bool by_jerk;                  ///< LegQueue::rounds_by_jerk()
    std::vector<Member> members;   ///< not handed out yet
    std::optional<PathItem> head;  ///< what the first of them has before the curve, likewise
    std::size_t vertices = 1;
    double last_wanted = 0;  ///< m of the last leg, by the corner at its end if there were one
    double handed = 0;       ///< u up to which the curve has been handed out
    PathPoint end;           ///< what the axes do there, per unit of u; of an arm
  };
  double joined_half(const SegmentDescriptor& front) const;

  std::optional<PathItem> decide();
  PathItem hand_out();
  PathItem head_of_front(double length);
  void begin_run(double before);
  PathItem head_of_run();
  void place_events(double before, const CurvePart& part, double beyond,
                    SegmentDescriptor& segment) const;
  std::size_t most_unsettled() const;
  bool grow();
  void append_front();
  void end_on_front();
  std::size_t settled_members() const;
  std::optional<PathItem> settled();
  double end_of(const Member& member) const;
  PathItem item_of(std::size_t members);
  JointPath axes_of_arm(const CurvePart& part, const PathStretch& stretch, const LegBounds& like);

  const RobotModel& robot_;
  const MergeRules rules_;
  std::size_t most_members_;
  LegQueue queue_;
  /// The motion handed out last, if the path goes on after it, and what its corner wants, m.
  std::optional<SegmentDescriptor> before_;
  double before_wanted_ = 0;
  std::optional<Run> run_;
  std::size_t grown_ = 0;
};

}  // namespace rob::motion
