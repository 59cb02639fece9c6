#pragma once

#include <cstddef>
#include <vector>

#include "motion/ahead/path_listener.h"
#include "motion/ahead/path_ring.h"
#include "motion/ahead/piece.h"
#include "motion/ahead/speed_plan.h"

namespace rob::motion {

/// Writes pieces into the PathRing: first as drafts, which it publishes once all is known that acts
/// together with them, and says how fast they may be.
///
/// Where the mean that bounds the jerk is one of σ, its place and its speed come from all that the
/// guide has passed in its time. There each piece bounds σ' and σ'' by the greatest slopes and
/// bends of all within reach (SpeedPlan), which holds for the mean, too; what could reach beyond
/// the end of what is known waits. Where no more fits into the ring before that is known, drafts
/// are slowed until it is.
///
/// m, rad, s. Belongs to the planner's thread.
class PieceWriter {
 public:
  /// s: so long before it would have to brake a corner is made of what is known.
  static constexpr double kSoon = 0.1;
  /// s: so long before the guide would stand short of a target it is led there (motion.md: decision
  /// point).
  static constexpr double kLastChance = 0.05;
  /// m: places that are nearer to each other are one.
  static constexpr double kSamePlace = 1e-9;
  static constexpr double kAny = Piece::kAny;

  explicit PieceWriter(PathRing& ring) : ring_(ring) {}

  /// From here on it receives all pieces that are planned.
  void tell(PathListener& listener) { listener_ = &listener; }

  // Runs, from one standstill to the next.
  /// The mean that makes the references of a run.
  struct Mean {
    double time = 0;        ///< s, whole periods
    bool of_sigma = false;  ///< else of the axes
    bool alone = false;     ///< the run is one straight leg
    bool pauses = false;    ///< its guide pauses
  };
  /// One begins; its mean is known before its first piece. The drafts of the one before have a mean
  /// of their own: they are published.
  void begin_run();
  void set_mean(const Mean& mean) { mean_ = mean; }
  /// The run comes to rest here, and goes on.
  void rest_on_the_way();
  void end_run();
  /// Drafts are not path any more, and nothing lies ahead of the guide.
  void drop();

  // The leg whose pieces come.
  struct Tail {
    double end = 0;         ///< σ at its end
    double held = 0;        ///< m before its end that the corner out of it may yet calm
    double control = kAny;  ///< σ'' with which the guide can slow down there, were it straight
  };
  void begin_leg(const Tail& tail) { tail_ = tail; }
  /// No corner will calm it.
  void let_go() { tail_.held = 0; }
  double held() const noexcept { return tail_.held; }

  // Pieces.
  std::size_t room() const noexcept;
  void write(std::vector<Piece>& pieces);
  /// σ at the end of the last one.
  double known() const noexcept { return known_; }
  /// From σ to σ the axes give this share, around a corner whose mean would leave its zone: in the
  /// drafts of its run, and in what is written from here on.
  void calm_down(double from, double to, double share);
  /// σ up to which they do.
  double calm_end() const noexcept { return calm_.end; }

  // Publishing.
  /// Publishes what can be; `share`: the override. Whether there was anything.
  bool work(double share);
  bool more_to_publish() { return ready() != ring_.end(); }
  /// Nothing more fits, and no draft can be published: they are made so slow that half of them can,
  /// or the first. False where the guide makes room.
  bool narrow();
  /// Whether the guide stands at the end of what is known, or would `time` after braking so hard;
  /// where it brakes along the path already: whether it will stand so soon.
  bool guide_within(double time, double deceleration) const;

 private:
  bool extends_last(const Piece& piece) const;
  PathRing::Index ready();
  PathRing::Index sure_to(double sigma);
  void split(PathRing::Index at, double sigma) noexcept;
  void publish(bool anew);
  void bound_speeds(PathRing::Index until);
  void pass_back(PathRing::Index ready, bool anew);
  double top_square(const Piece& piece) const noexcept;

  struct Calm {
    double end = 0;
    double share = 1;
  };

  PathRing& ring_;
  PathListener* listener_ = nullptr;
  Mean mean_;
  Tail tail_;
  Calm calm_;
  double known_ = 0;
  PathRing::Index end_ = 0;  ///< of the pieces written; those from ring_.end() on are drafts
  double published_ = 0;     ///< σ at the end of those before
  double share_ = 1;         ///< the override that the squares are for
  SpeedPlan speeds_;         ///< of the run, where the mean is of σ
};

}  // namespace rob::motion
