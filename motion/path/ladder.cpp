#include "motion/path/ladder.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "motion/path/way_cost.h"

namespace rob::motion {

namespace {

constexpr double kNever = std::numeric_limits<double>::infinity();

/// rad or m: who turns farther in one step may have come to another branch.
constexpr double kOneStep = 0.35;

}  // namespace

std::vector<Ladder::Hold> Ladder::climb(const JointVector& start) const {
  constexpr int kSide = 72;  // of a turn: one turn to either side
  constexpr int kJump = 6;   // [choice] 30° from rung to rung are more than any robot would like
  constexpr int kFiner = 8;
  std::vector<Hold> holds(places_.size(), Hold{choice_.first(start), {}});
  holds.front().q = start;
  double apart = choice_.apart();
  holds = way(holds, {apart, kSide, kJump});
  for (int finer = 0; finer < 2; ++finer) {
    apart /= kFiner;
    holds = way(holds, {apart, kFiner, 3 * kFiner});
  }
  return holds;
}

/// One pass: values around a middle on each rung, which the pass before has left, and the best way
/// through them.
std::vector<Ladder::Hold> Ladder::way(const std::vector<Hold>& middles, const Grid& grid) const {
  std::vector<Rung> all(1, Rung(static_cast<std::size_t>(2 * grid.side + 1)));
  State& start = all.front()[static_cast<std::size_t>(grid.side)];
  start.value = middles.front().value;
  start.q = middles.front().q;
  while (all.size() < middles.size()) {
    Rung next = rung(all.size(), middles[all.size()], all.back(), grid);
    if (!join(all.back(), next, grid)) break;
    all.push_back(std::move(next));
  }
  const auto less = [](const State& a, const State& b) {
    return (a.q.size() > 0 ? a.sum : kNever) < (b.q.size() > 0 ? b.sum : kNever);
  };
  auto best = std::min_element(all.back().begin(), all.back().end(), less) - all.back().begin();
  std::vector<Hold> holds(all.size());
  for (std::size_t k = all.size(); k-- > 0;) {
    const State& state = all[k][static_cast<std::size_t>(best)];
    holds[k] = {state.value, state.q};
    best = state.from;
  }
  return holds;
}

/// The values that can be reached: where the axes are known in the middle from there, else from
/// the same values of the rung before.
Ladder::Rung Ladder::rung(std::size_t at, const Hold& middle, const Rung& before,
                          const Grid& grid) const {
  Rung next(before.size());
  for (int j = -grid.side; j <= grid.side; ++j) {
    const auto i = static_cast<std::size_t>(j + grid.side);
    next[i].value = middle.value + j * grid.apart;
    if (middle.q.size() == 0 && before[i].q.size() > 0)
      reach(places_[at - 1], before[i], places_[at], next[i], 3);
  }
  if (middle.q.size() > 0) next[static_cast<std::size_t>(grid.side)].q = middle.q;
  const int last = 2 * grid.side;
  for (int i = 0; i < last; ++i) spread(at, i, 1, next);
  for (int i = last; i > 0; --i) spread(at, i, -1, next);
  for (State& state : next)
    if (state.q.size() > 0) state.toll = limit_cost(robot_, state.q);
  return next;
}

/// To a neighbour on the rung that is not reached yet.
void Ladder::spread(std::size_t at, int from, int step, Rung& rung) const {
  const State& here = rung[static_cast<std::size_t>(from)];
  State& next = rung[static_cast<std::size_t>(from + step)];
  if (here.q.size() > 0 && next.q.size() == 0) reach(places_[at], here, places_[at], next, 2);
}

/// Steps too far for one branch to be sure of are halved.
bool Ladder::reach(double s_from, const State& from, double s, State& to, int halvings) const {
  if (const auto q = choice_.axes(s, to.value, from.q);
      q && (*q - from.q).cwiseAbs().maxCoeff() <= kOneStep) {
    if (axes_within(robot_, *q)) to.q = *q;
    return to.q.size() > 0;
  }
  if (halvings == 0) return false;
  const double middle = (s_from + s) / 2;
  State between;
  between.value = (from.value + to.value) / 2;
  return reach(s_from, from, middle, between, halvings - 1) &&
         reach(middle, between, s, to, halvings - 1);
}

/// The best way to each value; whether there is any.
bool Ladder::join(const Rung& before, Rung& rung, const Grid& grid) const {
  const int last = 2 * grid.side;
  bool any = false;
  for (int i = 0; i <= last; ++i) {
    State& to = rung[static_cast<std::size_t>(i)];
    to.sum = kNever;
    if (to.q.size() == 0) continue;
    for (int k = std::max(0, i - grid.jump); k <= std::min(last, i + grid.jump); ++k) {
      const State& from = before[static_cast<std::size_t>(k)];
      if (from.q.size() == 0 || !(from.sum < kNever)) continue;
      const double sum = from.sum + way_cost(robot_, from.q, to.q) * rungs();
      if (!(sum < to.sum)) continue;
      to.sum = sum;
      to.from = k;
    }
    to.sum += share_ * to.toll;
    any = any || to.sum < kNever;
    if (!(to.sum < kNever)) to.q.resize(0);
  }
  return any;
}

}  // namespace rob::motion
