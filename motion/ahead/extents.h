#pragma once

#include <Eigen/Core>
#include <bit>
#include <cstddef>
#include <limits>
#include <vector>

#include "motion/ahead/path_ring.h"
#include "motion/space/joint_vector.h"

namespace rob::motion {

/// What one piece, or the greatest of some, asks for. m, rad, s; of axes that there are not: 0.
struct Extent {
  using Axes = Eigen::Array<double, kMaxJoints, 1>;

  Axes slopes = Axes::Zero();  ///< |dq/dσ|
  Axes bends = Axes::Zero();   ///< |d²q/dσ²|
  Axes swings = Axes::Zero();  ///< what the jerk makes of both: Piece::swings
  double asked = 0;            ///< σ'
  double fastest = std::numeric_limits<double>::infinity();  ///< that the axes and their jerk admit
  int fastest_axis = -1;

  /// The greatest of both; of two that are as fast this one's axis stays.
  void take(const Extent& its) noexcept;
  bool same(const Extent& as) const noexcept;
};

/// The extents of the pieces in a PathRing, by the same slots, and the greatest of any that follow
/// each other: a binary tree over the slots, each node the greatest of its two. Both writing one
/// and asking for many take some steps for each doubling of their number.
///
/// Of pieces that are to be asked for, all have to be written, and begin one behind the other. The
/// constructor alone takes memory, for no fewer pieces than it is told.
class Extents {
 public:
  using Index = PathRing::Index;

  explicit Extents(std::size_t pieces)
      : places_(std::bit_ceil(pieces)), nodes_(2 * places_.size()), asked_(nodes_.size()) {}

  /// `begin`: σ at its beginning; `run`: the first piece of its run.
  void write(Index at, double begin, Index run, const Extent& extent) noexcept;
  /// No more is asked for there.
  void limit_asked(Index at, double asked) noexcept;
  const Extent& of(Index at) const noexcept { return nodes_[leaf(at)]; }
  Index run(Index at) const noexcept { return places_[slot(at)].run; }

  /// From `lowest` to `at`: the last that begins before σ; `lowest` where none does.
  Index last_before(double sigma, Index lowest, Index at) const noexcept;
  /// From `at` on, before `end` and in its run: the one behind which none begins up to σ.
  Index last_up_to(double sigma, Index at, Index end) const noexcept;
  /// Of first … last, those included, at most as many as there are slots.
  double greatest_asked(Index first, Index last) const noexcept;
  Extent greatest(Index first, Index last) const noexcept;

 private:
  struct Place {
    double begin = 0;
    Index run = 0;
  };
  std::size_t slot(Index at) const noexcept {
    return static_cast<std::size_t>(at) & (places_.size() - 1);
  }
  std::size_t leaf(Index at) const noexcept { return places_.size() + slot(at); }
  void renew_above(std::size_t leaf) noexcept;
  template <typename Take>
  void cover(Index first, Index last, Take&& take) const noexcept;

  std::vector<Place> places_;
  std::vector<Extent> nodes_;  ///< 1: the root; 2k, 2k + 1: below k
  std::vector<double> asked_;  ///< of nodes_, which is looked at more often
};

}  // namespace rob::motion
