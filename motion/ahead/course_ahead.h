#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "motion/ahead/path_intake.h"
#include "motion/ahead/path_ring.h"
#include "motion/ahead/path_turn.h"
#include "motion/ahead/rehearsal.h"
#include "motion/robots/robot_model.h"

namespace rob::motion {

/// Looks ahead from a leg: what follows it, as far as it is known, and whether a stop or a corner
/// leads into it. Where the mean that bounds the jerk is one of σ, the faster one does, which a
/// rehearsal finds.
///
/// `next`: the index of the item that follows the leg in question. `window`: s of the mean of the
/// run.
class CourseAhead {
 public:
  CourseAhead(const RobotModel& robot, const PathIntake& intake, const PathRing& ring)
      : robot_(robot), intake_(intake), ring_(ring), rehearsal_(robot) {}

  /// A run begins; its first leg does at rest.
  void begin_run();
  /// The corner that was found to pay has taken so much of the leg after it, m.
  void enter(double taken);
  /// m of the current leg that the corner into it has taken; none: it begins at rest.
  std::optional<double> into() const noexcept { return into_; }
  /// The motions that were looked at will not come.
  void forget() { rehearsal_.forget(); }

  bool averages_sigma(double window) const noexcept {
    return robot_.tool_coordinates && window > 0;
  }

  /// The corner into `out`, item `at`; none where a stop is as fast, or all that is possible.
  /// `from_rest`: `in` begins at rest, and nothing of it has been sent.
  std::optional<Turn> corner(const ShapedLeg& in, const ShapedLeg& out, std::size_t at,
                             double window, bool from_rest) const;
  /// Whether item `at` ends at rest, as far as it is known what comes after it.
  bool ends_at_rest(const SegmentDescriptor& segment, std::size_t at) const;

  /// Whether it is known already that a run begins and ends with this leg.
  bool stands_after(const ShapedLeg& leg, std::size_t next, double window) const;
  /// The next item, if it is a straight leg that comes to rest at both of its ends.
  std::optional<ShapedLeg> next_alone(const ShapedLeg& leg);

  // Where the mean is of σ.
  /// How the run is driven that begins with that leg.
  Rehearsal::Beginning beginning(const ShapedLeg& leg, std::size_t next, double window) {
    return rehearsal_.beginning(course_from(leg, next, window));
  }
  /// Whether the corner out of the current leg is faster than a stop.
  bool pays(const ShapedLeg& leg, const Turn& turn, double window);
  /// Whether the first items, a curve that begins at σ, take longer than `legs` with stops between
  /// them.
  bool sooner_apart(std::size_t items, const std::vector<PathItem>& legs, double sigma);

 private:
  ShapedLeg shape(const PathItem& item, double begin) const {
    return shaped_leg(robot_, item, begin);
  }
  bool goes_on_behind(const ShapedLeg& leg, std::size_t at, double window) const;
  double share_of(const ShapedLeg& leg, std::size_t at) const;
  bool stands_alone(const ShapedLeg& leg, std::size_t next, double window);
  Course course_from(const ShapedLeg& leg, std::size_t next, double window);
  bool extend(Course& course, const PathItem& item, bool last);

  const RobotModel& robot_;
  const PathIntake& intake_;
  const PathRing& ring_;
  Rehearsal rehearsal_;
  std::optional<double> into_;
  double entry_ = 0;  ///< σ'² there, as was reckoned
};

}  // namespace rob::motion
