#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "motion/ahead/course_ahead.h"
#include "motion/ahead/leg_writer.h"
#include "motion/ahead/path_intake.h"
#include "motion/ahead/path_listener.h"
#include "motion/ahead/path_ring.h"
#include "motion/ahead/path_turn.h"
#include "motion/ahead/piece_writer.h"
#include "motion/plan/look_ahead_buffer.h"
#include "motion/robots/robot_model.h"

namespace rob::motion {

/// Makes the path of look-ahead motion out of what the LookAheadBuffer holds (PathIntake), and says
/// how fast it may be run (PieceWriter): between the program and the tick, in neither.
///
/// From one standstill to the next all motions are one path. A corner is made when the motion
/// after the next one is known, too, so that both corners of a leg get their share of it; or when
/// the guide comes near. A leg whose corner is not made yet is published only as far as no
/// corner can use it. Where nothing follows, or what follows begins at rest, the leg is completed
/// to its target; so it is, late, where nothing is known and the guide is about to stand short of
/// it.
///
/// Where the mean that bounds the jerk is one of σ a corner is made only where it is faster than a
/// stop (CourseAhead).
///
/// m, rad, s.
class PathPlanner {
 public:
  /// `single`: how many motions on the path may be ahead that are not merged with others.
  PathPlanner(const RobotModel& robot, LookAheadBuffer& buffer, PathRing& ring, std::size_t single);
  PathPlanner(const RobotModel& robot, LookAheadBuffer& buffer, PathRing& ring)
      : PathPlanner(robot, buffer, ring, ring.leg_capacity()) {}

  /// Does all that can be done now; whether there was anything.
  bool work();
  /// From here on it receives all pieces that are planned.
  void tell(PathListener& listener) { pieces_.tell(listener); }

 private:
  static constexpr double kAny = Piece::kAny;

  void fetch() { intake_.fetch(!open_); }
  void drop();
  bool advance();

  // Runs.
  bool begin_run();
  void begin_on_arm(ShapedLeg& leg);
  void stand_alone(ShapedLeg& leg);
  bool gives_up_curve();
  bool averages_sigma() const noexcept { return ahead_.averages_sigma(window_); }
  double mean_time() const noexcept { return whole_periods(robot_, window_); }

  // The open leg.
  void open(const ShapedLeg& leg);
  double longest_turn(const ShapedLeg& leg) const;
  bool join_next();
  bool join(const SegmentDescriptor& next);
  bool decide_alone();
  bool give_up_corner();
  bool complete();
  bool go_on();
  bool come_to_rest();
  bool awaits_room();
  bool overlap_next();
  void round_corner();
  bool calm_corner();
  bool send(double goal);
  double next_end(double goal) const;

  const RobotModel& robot_;
  PathRing& ring_;
  LegWriter legs_;
  PathIntake intake_;
  CourseAhead ahead_;
  PieceWriter pieces_;
  std::optional<ShapedLeg> open_;  ///< its corner is not made yet, or not yet written
  bool completing_ = false;        ///< it goes to its target, and comes to rest there
  std::optional<Turn> turn_;       ///< out of it, into
  std::optional<ShapedLeg> next_;
  double before_ = kAny;  ///< m: ShapedLeg::before of what follows the open leg
  bool sent_ = false;     ///< all of the open leg that can be known has been published
  double brakes_ = kAny;  ///< σ'' with which the guide can slow down at its end, were it straight
  double window_ = 0;     ///< s of the mean of the current run
  bool alone_ = false;    ///< the current run is one straight leg
  bool pauses_ = false;   ///< and its guide pauses; more such legs may follow it (Overlap)
  double wait_ = 0;       ///< s before the open leg: Overlap
  std::vector<Piece> scratch_;
};

}  // namespace rob::motion
