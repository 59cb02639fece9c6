#pragma once

#include <cstdint>

#include "motion/ahead/path_ring.h"
#include "motion/ahead/reachable.h"

namespace rob::motion {

/// The limit that holds the guide's speed.
struct GuideLimit {
  enum class Kind : std::uint8_t {
    None,
    Pace,          ///< what is asked for
    Override,      ///< the same, at an override below 1
    Speed,         ///< of an axis
    Acceleration,  ///< of an axis
    EndOfPath,     ///< what is known ends too soon
    Braking        ///< by request
  };
  Kind kind = Kind::None;
  int axis = -1;  ///< of Speed and Acceleration
};

/// The point that runs along the path, as fast as the programmed speed, the axes and what is known
/// of the path allow: at each instant with the greatest σ'' from which PathRing::square() can be
/// kept. σ'' is even until a bound is reached or a piece ends, so the way is a parabola of time,
/// part by part, and exact whatever the period.
///
/// On a straight leg that stands alone it can pause: σ'' does not change its sign before it has
/// been 0 for so long. Where the pause is the mean's time, σ'' and that of a mean's time ago differ
/// by no more than the greatest of either; without, by twice that. It speeds up only as far as it
/// can pause and then still brake (docs/motion.md).
///
/// m, s. Every call may be used in the tick.
class Guide {
 public:
  /// A stretch of even σ''.
  struct Part {
    double time = 0;  ///< s since the start of the run, of its beginning
    double sigma = 0;
    double rate = 0;
    double acceleration = 0;
  };
  /// In one step: a bound on the work of a tick, which no path reaches. [choice] three for each
  /// piece of a ring; each takes some 0.1 µs.
  static constexpr int kMostParts = 3 * 8192;

  /// The axes stand at `start`.
  Guide(PathRing& ring, const JointVector& start) noexcept
      : ring_(ring),
        place_{start, JointVector::Zero(start.size()), JointVector::Zero(start.size())} {}

  /// Goes on to `time`. Calls keep(part) for each part, in order.
  template <typename Keep>
  void step(double time, Keep&& keep) noexcept {
    for (int i = 0; i < kMostParts && time_ < time; ++i) keep(next_part(time));
    time_ = time;
    if (stands()) acceleration_ = 0;  // it has just come to rest
    update_place();
  }

  /// Comes to rest on the path as fast as the axes can, and stays there until release().
  void brake() noexcept { braking_ = true; }
  void release() noexcept { braking_ = false; }
  bool braking() const noexcept { return braking_; }
  /// The share of the programmed speed, 0 < share <= 2.
  void set_share(double share) noexcept { share_ = share; }
  double share() const noexcept { return share_; }
  /// σ' that is not exceeded at a share of 1, whatever the pieces ask for; above 0.
  void set_pace(double pace) noexcept { pace_ = pace; }

  bool stands() const noexcept { return rate_ == 0; }
  /// It stands where the path is meant to come to rest, until begin_run().
  bool at_run_end() const noexcept;
  /// It stands at the end of what is known of the path.
  bool at_path_end() const noexcept { return stands() && ring_.piece(index_) == nullptr; }
  /// `sigma`: where the run begins, which is elsewhere where path has been dropped before.
  /// It stands until `start`. `pause`, s: where not 0 each piece of the run is straight, and it
  /// comes to rest at the end of each.
  void begin_run(double sigma, double start, double pause) noexcept {
    begun_ = index_;
    sigma_ = sigma;
    start_ = start;
    pause_ = pause;
    gained_ = lost_ = -Piece::kAny;
  }
  /// The axes stand at q; the path goes on with piece `at`.
  void restart(PathRing::Index at, const JointVector& q) noexcept;

  bool pauses() const noexcept { return pause_ > 0; }

  double time() const noexcept { return time_; }
  double sigma() const noexcept { return sigma_; }
  double rate() const noexcept { return rate_; }
  double acceleration() const noexcept { return acceleration_; }
  const GuideLimit& limit() const noexcept { return limit_; }
  /// The index of the piece it is on, or will be on next.
  PathRing::Index index() const noexcept { return index_; }
  /// The axes: place, velocity and acceleration in time.
  const PathPoint& place() const noexcept { return place_; }

 private:
  /// σ'', and how far it holds.
  struct Choice {
    double control = 0;
    double way = 0;
    double end_rate = 0;
    GuideLimit limit;
    double until = Piece::kAny;  ///< it stands up to then
  };

  /// From `here` to the end of a piece, entered with σ'² = x.
  struct Stretch {
    PathPoint here;
    PathPoint end;
    double rest = 0;
    double x = 0;
  };

  bool blocked() const noexcept {
    return index_ > 0 && index_ != begun_ && ring_.run_end(index_ - 1);
  }
  Part next_part(double until) noexcept;
  double greatest_rate(const Piece& piece, GuideLimit& limit) const noexcept;
  Choice choose(const Piece& piece, double rest) const noexcept;
  double half_bent(const Piece& piece, const PathPoint& end) const noexcept;
  double brakes_on(const Piece& piece, const PathPoint& end, double top) const noexcept;
  Choice slow_down(const Piece& piece, const Stretch& on, const ControlRange& range,
                   double floor) const noexcept;
  Choice choose_alone(const Piece& piece, double rest) const noexcept;
  double peak_rate(double control, double rest) const noexcept;
  void update_place() noexcept;

  PathRing& ring_;
  PathRing::Index index_ = 0;
  PathRing::Index begun_ = 0;  ///< piece at which the current run has begun
  PathRing::Index first_ = 0;  ///< the first after the last restart
  double at_ = 0;              ///< σ since the beginning of the piece
  double time_ = 0;
  double sigma_ = 0;
  double rate_ = 0;
  double acceleration_ = 0;
  double share_ = 1;
  double pace_ = Piece::kAny;
  bool braking_ = false;
  double start_ = 0;              ///< s: of the current run
  double pause_ = 0;              ///< s between speeding up and braking
  double gained_ = -Piece::kAny;  ///< when it last sped up
  double lost_ = -Piece::kAny;    ///< when it last braked
  PathRing::Index lost_on_ = 0;   ///< and on which piece
  GuideLimit limit_;
  PathPoint place_;
};

}  // namespace rob::motion
