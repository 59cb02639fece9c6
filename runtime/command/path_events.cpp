#include "runtime/command/path_events.h"

#include <algorithm>
#include <utility>

#include "motion/plan/feasibility.h"

namespace rob::runtime {

namespace {

bool lies_on(double place, double way) {
  return way > 0 && place >= -motion::kLimitTolerance && place <= way + motion::kLimitTolerance;
}

}  // namespace

std::optional<Words> lay_events(Commanded& commanded) {
  motion::SegmentDescriptor& segment = commanded.segment;
  const double way = commanded.way;
  segment.on_the_way.clear();
  for (const OnTheWay& one : commanded.events) {
    const double distance = one.place.distance;
    const double place = one.place.before ? way - distance : distance;
    if (!lies_on(place, way)) return words_at(one.place.written, words_for_place(distance, way));
    if (segment.on_the_way.full())
      return words_at(one.place.written, words_for_many_places(segment.on_the_way.kMost));
    motion::PathEvent event{.share = place / way, .lead = one.place.lead, .effect = one.effect};
    if (const motion::ToolPath* const path = commanded.along.get())
      event.share = (path->at_share(event.share) - path->begin()) / (path->end() - path->begin());
    event.effect.after = segment.number;
    segment.on_the_way.push_back(event);
  }
  return std::nullopt;
}

std::optional<Words> share_out(std::vector<OnTheWay> events, std::deque<Commanded>& path) {
  double whole = 0;
  for (const Commanded& one : path) whole += one.way;
  for (OnTheWay& event : events) {
    const double asked = event.place.distance;
    double place = event.place.before ? whole - asked : asked;
    if (!lies_on(place, whole)) return words_at(event.place.written, words_for_place(asked, whole));
    Commanded* on = nullptr;  // the first one that reaches as far, else the last
    for (Commanded& one : path) {
      if (!(one.way > 0)) continue;
      if (on != nullptr) place -= on->way;
      on = &one;
      if (place <= one.way) break;
    }
    event.place.before = false;
    event.place.distance = std::clamp(place, 0.0, on->way);
    on->events.push_back(event);
  }
  return std::nullopt;
}

}  // namespace rob::runtime
