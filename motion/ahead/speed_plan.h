#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <limits>
#include <vector>

#include "motion/ahead/piece.h"

namespace rob::motion {

/// The demand of one piece, or the greatest of some. m, rad, s; of axes that there are not: 0.
struct Extent {
  using Axes = Eigen::Array<double, kMaxJoints, 1>;
  /// The index of Piece::torque, whose limit is 1. No arm has so many axes.
  static constexpr int kTorque = kMaxJoints - 1;

  Axes slopes = Axes::Zero();    ///< |dq/dσ|
  Axes bends = Axes::Zero();     ///< |d²q/dσ²|
  Axes swings = Axes::Zero();    ///< what the jerk makes of both: Piece::swings
  double fastest = Piece::kAny;  ///< σ' that it admits
  int fastest_axis = -1;         ///< that sets it

  /// Takes the greater demand of both.
  void take(const Extent& its) noexcept;
};

/// How fast a run is driven whose references are a mean of σ over T, and what each of its pieces
/// has to leave to the others for that.
///
/// The mean is on one piece while the guide is on another, so that each piece keeps to the greatest
/// slopes and bends of all that lie within reach. How far that is follows from a speed c(σ) that
/// the guide keeps everywhere: of all instants up to T away it is at most so far away in the mean.
/// Any c will do that the guide does keep; here it is what accelerating and braking leave, found in
/// rounds, since what is within reach slows in its turn.
///
/// m, rad, s.
class SpeedPlan {
 public:
  /// The part of a run that has been planned for good: only its last part matters to what follows.
  struct Stretch {
    double begin = 0;   ///< σ
    double length = 0;  ///< above 0
    double pace = 0;    ///< σ' that is asked for
    double top = 0;     ///< σ' at most, whatever lies around it, and whatever the override
    Extent own;
    Extent::Axes jolts = Extent::Axes::Zero();  ///< |d³q/dσ³|
    Extent::Axes acceleration;                  ///< 1 of axes that there are not
    double rate = 0;                            ///< c: σ' at most
    Extent most;                                ///< of all within reach
    std::size_t first = 0;                      ///< stretch within reach
    std::size_t last = 0;
  };

  /// A run begins, with that σ'²; it has not come to its end.
  void begin(double square = 0);
  void add(const Piece& piece);
  /// No stretch that is not fixed is faster than that.
  void limit(double rate) noexcept;
  /// It comes to rest where it ends now.
  void end_at_rest() noexcept;

  /// Plans what is not fixed for a mean over `average`. Path that follows an end that is no rest
  /// may be as fast as it likes.
  void plan(double average);
  /// As planned, s for what is not fixed, at override 1.
  double time();
  /// The same of σ'² at the beginning of the stretch `at` of those that are not fixed.
  double square(std::size_t at) const noexcept { return squares_[fixed_ + at]; }

  /// How many stretches are not fixed, and how many of them, from the first on, have all within
  /// reach known.
  std::size_t open() const noexcept { return stretches_.size() - fixed_; }
  std::size_t ready() const noexcept { return ready_; }
  /// So much has come since it was planned that it pays to plan anew.
  bool grown() const noexcept { return rests_ || 4 * open() > 5 * planned_; }
  /// A stretch of those that are not fixed.
  const Stretch& stretch(std::size_t at) const noexcept { return stretches_[fixed_ + at]; }
  /// The first `count` are as planned for good. A stretch within their reach keeps its c, too.
  void fix(std::size_t count);

 private:
  /// The bounds of a stretch that a pass keeps.
  struct Bound {
    Extent extent;
    double square = 0;  ///< σ'² at most
  };
  /// The assumptions about path that was not known yet.
  struct Promise {
    double rate = Piece::kAny;  ///< σ' at most
    double until = 0;           ///< σ
  };
  void bound_by_own(double average);
  void pass();
  double control(std::size_t at, double square) const noexcept;
  double peak(std::size_t at) const noexcept;
  void take_rates(double more) noexcept;
  void spread(double average);
  void lay_out_times();
  void find_reach(double average);
  /// Stretches that are looked for again and again, each time farther on.
  struct Cursors {
    std::size_t before = 0, after = 0;  ///< at a time
    std::size_t first = 0, last = 0;    ///< at a place
  };
  double place_integral(double time, std::size_t& at) const noexcept;
  void go_to(double place, std::size_t& at) const noexcept;
  void build_rates();
  void build_extents(double average);
  double greatest_rate(std::size_t first, std::size_t last) const noexcept;
  Extent greatest(std::size_t first, std::size_t last) const noexcept;
  void promise(std::size_t fixed) noexcept;
  void trim();

  std::vector<Stretch> stretches_;
  std::size_t fixed_ = 0;  ///< of them, from the first on
  std::size_t ready_ = 0;
  bool rests_ = false;  ///< the last one ends at rest
  double entry_ = 0;    ///< σ'² at the end of the fixed ones
  Promise promise_;

  // While planning.
  bool stale_ = true;
  std::size_t planned_ = 0;  ///< how many were not fixed then
  double average_ = 0;
  std::vector<Bound> bounds_;
  std::vector<double> squares_;    ///< where each begins, and where the last ends
  std::vector<double> times_;      ///< at c, the same
  std::vector<double> integrals_;  ///< of the place over that time, the same
  std::size_t leaves_ = 1;         ///< of both trees
  std::vector<double> rates_;
  std::vector<Extent> extents_;
};

}  // namespace rob::motion
