#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "motion/ahead/path_turn.h"
#include "motion/ahead/speed_plan.h"

namespace rob::motion {

/// How far apart the ends of pieces may be: finer near places where the speed is low.
struct Grading {
  double begin = 0;    ///< m from the leg's beginning: where it is slow
  double end = 0;      ///< the same at its end
  double first = 0;    ///< m that a piece may have at least, there
  double last = 0;     ///< at its end
  double longest = 0;  ///< m that it may have at most

  /// The length of the piece that begins there.
  double length_at(double way) const noexcept;
};

/// `into`, `out`: m that the corners at its ends take of it, 0 where the path goes straight on;
/// none: it comes to rest there.
Grading grading_of(const RobotModel& robot, const ShapedLeg& leg, std::optional<double> into,
                   std::optional<double> out, double average);

/// Where the polynomial of a leg ends that `way` lies on, m from its beginning.
double next_border(const ShapedLeg& leg, double way);

/// Where the next piece that begins at `way` ends: at the next node of the leg's path, at the
/// latest.
double next_cut(const ShapedLeg& leg, const Grading& grading, double way, double goal);

/// Legs one after the other, and the corners between them: one less.
struct Course {
  std::vector<ShapedLeg> legs;
  std::vector<Turn> turns;
  bool whole = false;           ///< after the last leg all stands
  std::optional<double> taken;  ///< m of the first leg, by the corner into it; none: from rest
  double square = 0;            ///< σ'² there
};

/// Works out the time that runs of the legs of a course would take, on an arm.
class Rehearsal {
 public:
  explicit Rehearsal(const RobotModel& robot) : robot_(robot) {}

  /// s of whole periods.
  double mean_time(double window) const noexcept;

  /// The corner between two legs that takes so much of each at most; none where only a stop will
  /// do.
  std::optional<Turn> turn(const ShapedLeg& in, const ShapedLeg& out, double longest);
  /// The motions that were looked at will not come.
  void forget() { seen_.clear(); }

  /// How the first leg, which begins at rest, is best driven.
  struct Beginning {
    bool stands = false;  ///< it comes to rest at its end
    double share = 1;     ///< of its accelerations, and of its mean's time
  };
  Beginning beginning(const Course& course);

  /// s of the whole course from rest to rest, with the best mean.
  double together(const Course& course) { return run(course, 0, course.legs.size() - 1).time; }
  /// s of a leg from rest to rest.
  double apart(const ShapedLeg& leg) { return alone(leg).time; }

  /// Whether the corner out of the first leg is faster than a stop there, with a mean that stays as
  /// it is.
  bool pays(const Course& course, double window);
  /// σ'² right after that corner, as it was reckoned.
  double square_after() const noexcept { return square_after_; }

 private:
  struct Best {
    double share = 1;
    double time = 0;  ///< s from rest to rest
  };
  /// The results that are needed again with the next motions: of a leg, and of the corner out of
  /// it.
  struct Seen {
    std::uint32_t number = 0;  ///< of its motion
    double length = 0;         ///< m
    std::optional<Best> alone;
    std::optional<Turn> turn;
  };
  Seen& seen(const ShapedLeg& leg);
  Best tried_alone(const ShapedLeg& leg);
  Best run(const Course& course, std::size_t first, std::size_t last);
  Best alone(const ShapedLeg& leg);
  double settled(double guided, double average) const noexcept;
  double each_alone(const Course& course, std::size_t first);
  double any(const Course& course, std::size_t first);
  double guided(const Course& course, std::size_t first, std::size_t last, double window);
  ShapedLeg driven(const ShapedLeg& leg, double window) const;
  void lay(const ShapedLeg& leg, std::optional<double> into, std::optional<double> out,
           double average);

  const RobotModel& robot_;
  SpeedPlan plan_;
  std::vector<Piece> pieces_;
  double square_after_ = 0;
  std::vector<Seen> seen_;
};

}  // namespace rob::motion
