#include "motion/ahead/extents.h"

#include <algorithm>

namespace rob::motion {

void Extent::take(const Extent& its) noexcept {
  slopes = slopes.max(its.slopes);
  bends = bends.max(its.bends);
  swings = swings.max(its.swings);
  asked = std::max(asked, its.asked);
  if (its.fastest >= fastest) return;
  fastest = its.fastest;
  fastest_axis = its.fastest_axis;
}

bool Extent::same(const Extent& as) const noexcept {
  return asked == as.asked && fastest == as.fastest && fastest_axis == as.fastest_axis &&
         (slopes == as.slopes).all() && (bends == as.bends).all() && (swings == as.swings).all();
}

void Extents::write(Index at, double begin, Index run, const Extent& extent) noexcept {
  places_[slot(at)] = {begin, run};
  nodes_[leaf(at)] = extent;
  asked_[leaf(at)] = extent.asked;
  renew_above(leaf(at));
}

void Extents::limit_asked(Index at, double asked) noexcept {
  Extent& extent = nodes_[leaf(at)];
  if (extent.asked <= asked) return;
  extent.asked = asked_[leaf(at)] = asked;
  renew_above(leaf(at));
}

void Extents::renew_above(std::size_t leaf) noexcept {
  for (std::size_t i = leaf / 2; i > 0; i /= 2) {
    Extent most = nodes_[2 * i];
    most.take(nodes_[2 * i + 1]);
    if (most.same(nodes_[i])) return;
    nodes_[i] = most;
    asked_[i] = most.asked;
  }
}

Extents::Index Extents::last_before(double sigma, Index lowest, Index at) const noexcept {
  Index high = at + 1;  // from there on none begins before σ
  while (lowest + 1 < high) {
    const Index middle = lowest + (high - lowest) / 2;
    (places_[slot(middle)].begin < sigma ? lowest : high) = middle;
  }
  return lowest;
}

Extents::Index Extents::last_up_to(double sigma, Index at, Index end) const noexcept {
  const Index its_run = run(at);
  while (at + 1 < end) {
    const Index middle = at + (end - at) / 2;
    const Place& place = places_[slot(middle)];
    (place.run == its_run && place.begin <= sigma ? at : end) = middle;
  }
  return at;
}

/// Nodes that together have these slots below them, and no others: from both ends upwards, where an
/// end is not all of what is above it, it alone.
template <typename Take>
void Extents::cover(Index first, Index last, Take&& take) const noexcept {
  const auto slots = [&](std::size_t from, std::size_t to) {
    for (; from < to; from /= 2, to /= 2) {
      if (from % 2 == 1) take(from++);
      if (to % 2 == 1) take(--to);
    }
  };
  if (slot(first) <= slot(last)) return slots(leaf(first), leaf(last) + 1);
  slots(leaf(first), nodes_.size());
  slots(places_.size(), leaf(last) + 1);
}

double Extents::greatest_asked(Index first, Index last) const noexcept {
  double most = 0;
  cover(first, last, [&](std::size_t node) { most = std::max(most, asked_[node]); });
  return most;
}

Extent Extents::greatest(Index first, Index last) const noexcept {
  Extent most;
  cover(first, last, [&](std::size_t node) { most.take(nodes_[node]); });
  return most;
}

}  // namespace rob::motion
