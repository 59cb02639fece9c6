#include "lang/check/missing_points.h"

#include <algorithm>

namespace rob::lang {

void MissingPoints::teach(const Symbol& point, bool surely) {
  const auto found = states_.find(&point);
  if (found == states_.end()) return;
  found->second.taught = true;
  found->second.surely = found->second.surely || surely;
}

void MissingPoints::use(const Symbol& point) {
  const auto found = states_.find(&point);
  if (found == states_.end()) return;
  State& state = found->second;
  state.needed = state.needed || in_routines_ || !state.surely;
}

std::vector<MissingPoint> MissingPoints::found() const {
  std::vector<MissingPoint> missing;
  for (const auto& [point, state] : states_) {
    if (state.needed || !state.taught) missing.push_back({point->name, point->place});
  }
  std::ranges::sort(missing, [](const MissingPoint& a, const MissingPoint& b) {
    return comes_before(a.place, b.place);
  });
  return missing;
}

}  // namespace rob::lang
