#pragma once

#include <cstddef>
#include <cstdint>
#include <deque>
#include <optional>
#include <vector>

#include "motion/ahead/leg_writer.h"
#include "motion/ahead/path_listener.h"
#include "motion/ahead/path_merger.h"
#include "motion/ahead/path_ring.h"
#include "motion/ahead/path_turn.h"
#include "motion/ahead/rehearsal.h"
#include "motion/ahead/speed_plan.h"
#include "motion/plan/look_ahead_buffer.h"
#include "motion/robots/robot_model.h"

namespace rob::motion {

/// Makes the path of look-ahead motion out of what the LookAheadBuffer holds, and says how fast it
/// may be run: between the program and the tick, in neither.
///
/// From one standstill to the next all motions are one path. A corner is made when the motion
/// behind the next one is known, too, so that both corners of a leg get their share of it; or when
/// the guide comes near. Of a leg whose corner is not made yet only that part is published which no
/// corner can use. Where nothing follows, or what follows begins at rest, the leg is completed to
/// its target; so it is, late, where nothing is known and the guide is about to stand short of it.
///
/// Where the mean that bounds the jerk is one of σ, its place and its speed come from all that the
/// guide has passed in its time. There each piece bounds σ' and σ'' by the greatest slopes and
/// bends of all within reach (SpeedPlan), which holds for the mean, too; what could reach beyond
/// the end of what is known waits. Where no more fits into the ring before that is known, drafts
/// are slowed until it is. There, too, a corner is made only where it is faster than a stop
/// (Rehearsal).
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
  /// From here on it is told of what is planned.
  void tell(PathListener& listener) { listener_ = &listener; }

 private:
  /// s: so long before the guide would stand short of a target it is led there (motion.md: decision
  /// point).
  static constexpr double kLastChance = 0.05;
  /// s: so long before it would have to brake a corner is made of what is known.
  static constexpr double kSoon = 0.1;
  /// On an arm so many items at most are looked at to choose between a corner and a stop.
  static constexpr std::size_t kMostLegs = 8;
  /// The same of the parts of a curve. [choice] 40 mm of chords of 0.01 mm
  static constexpr std::size_t kMostParts = 64;
  /// m: places that are nearer to each other are one.
  static constexpr double kRounding = 1e-9;
  static constexpr double kAny = Piece::kAny;

  void drop();
  std::size_t most_pending() const;
  void fetch();
  bool advance();
  bool begin_run();
  ShapedLeg shape(const PathItem& item, double begin) const;
  bool nothing_comes() const;
  bool begins_with_curve() const;
  bool curve_grows();
  std::size_t parts_of_curve() const;
  std::vector<PathItem> legs_of(std::size_t items) const;
  bool gives_up_curve();
  bool stands_after(const ShapedLeg& leg) const;
  void begin_on_arm(ShapedLeg& leg);
  Course course_from(const ShapedLeg& leg);
  bool extend(Course& course, const PathItem& next);
  bool pays();
  bool stands_alone(const ShapedLeg& leg);
  std::optional<ShapedLeg> next_alone(const ShapedLeg& leg);
  bool awaits_room();
  bool overlap_next();
  const PathItem* coming(std::size_t at) const;
  void stand_alone(ShapedLeg& leg);
  void open(const ShapedLeg& leg);
  bool join_next();
  bool decide_alone();
  bool give_up_corner();
  bool go_on();
  std::optional<Turn> corner(const ShapedLeg& leg, const ShapedLeg& next, bool from_rest) const;
  bool goes_on_behind(const ShapedLeg& next) const;
  bool ends_at_rest(const SegmentDescriptor& next) const;
  double share_of_next(const ShapedLeg& next) const;
  bool guide_within(double time, double deceleration) const;
  /// σ'' with which the guide can slow down at the end of the open leg, were it straight.
  double brakes_at_end() const { return greatest_control(*open_, open_->at(open_->length())); }
  double longest_turn(const ShapedLeg& leg) const;
  bool send(double goal);
  double next_end(double goal) const;
  void write(std::vector<Piece>& pieces);
  bool extends_last(const Piece& piece) const;
  void publish(bool anew);
  PathRing::Index ready();
  bool more_to_publish() { return ready() != ring_.end(); }
  bool narrow();
  bool calm_corner();
  void split(PathRing::Index at, double sigma) noexcept;
  void bound_speeds(PathRing::Index until);
  void pass_back(PathRing::Index ready, bool anew);
  double top_square(const Piece& piece) const noexcept;
  double mean_time() const noexcept;
  std::size_t room() const noexcept;

  /// Around a corner whose mean would leave its zone: σ up to which the axes give this share.
  struct Calm {
    double end = 0;
    double share = 1;
  };
  bool averages_sigma() const noexcept { return robot_.tool_coordinates && window_ > 0; }

  const RobotModel& robot_;
  LookAheadBuffer& buffer_;
  PathRing& ring_;
  PathListener* listener_ = nullptr;
  LegWriter legs_;
  PathMerger merger_;
  std::deque<PathItem> pending_;
  std::optional<ShapedLeg> open_;  ///< its corner is not made yet, or not yet written
  bool completing_ = false;        ///< it goes to its target, and comes to rest there
  std::optional<Turn> turn_;       ///< out of it, into
  std::optional<ShapedLeg> next_;
  double before_ = kAny;     ///< m: ShapedLeg::before of what follows the open leg
  bool sent_ = false;        ///< all of the open leg that can be known has been published
  double known_ = 0;         ///< σ at the end of the last piece
  double window_ = 0;        ///< s of the mean of the present run
  bool alone_ = false;       ///< the present run is one straight leg
  bool pauses_ = false;      ///< and its guide pauses; more such legs may follow it (Overlap)
  double wait_ = 0;          ///< s before the open leg: Overlap
  PathRing::Index end_ = 0;  ///< of the pieces written; those from ring_.end() on are drafts
  double published_ = 0;     ///< σ at the end of those before
  double held_ = 0;          ///< m before the open leg's end that its corner may yet calm
  Calm calm_;
  double share_ = 1;  ///< the override that the squares are for
  SpeedPlan speeds_;  ///< of the run, where the mean is of σ
  Rehearsal rehearsal_;
  std::optional<double> into_;     ///< m of the open leg that the corner into it has taken
  double entry_ = 0;               ///< σ'² there, as was reckoned
  std::uint64_t grows_until_ = 0;  ///< PathRing::periods up to which a curve counts as growing
  std::size_t grown_ = 0;          ///< legs that it has taken since then
  std::vector<Piece> scratch_;
};

}  // namespace rob::motion
