#include "motion/ahead/run_mean.h"

#include <algorithm>

#include "motion/ahead/mean_shift.h"
#include "motion/ahead/merge_rules.h"

namespace rob::motion {

namespace {

bool is_curve(const PathItem& item) { return item.stretch && !item.stretch->axes.nodes().empty(); }

/// Passed in a few periods, or the part of a motion before a curve.
bool is_short(const RobotModel& robot, const PathItem& item) {
  if (!has_way(item.segment)) return false;
  if (item.stretch && item.stretch->goes_on) return true;
  const ShapedLeg leg = shaped_leg(robot, item.segment, 0);
  return leg.length() < few_periods(robot) * greatest_rate(robot, leg, leg.at(0));
}

/// The first curve of a run that goes on with these; null if something else comes first.
const PathItem* first_curve(const RobotModel& robot, const std::deque<PathItem>& items) {
  for (const PathItem& item : items) {
    if (is_curve(item)) return &item;
    if (item.segment.from_rest || !is_short(robot, item)) return nullptr;
  }
  return nullptr;
}

ShapedLeg shaped_item(const RobotModel& robot, const PathItem& item, double begin) {
  ShapedLeg leg = shaped_leg(robot, item.segment, begin);
  leg.stretch = item.stretch;
  return leg;
}

}  // namespace

bool awaits_curve(const RobotModel& robot, const std::deque<PathItem>& items) {
  if (items.front().segment.ahead.window == 0 || robot.tool_coordinates) return false;
  if (items.size() >= kMostBeforeCurve) return false;
  return std::all_of(items.begin(), items.end(), [&](const PathItem& item) {
    const bool stands = item.segment.from_rest && &item != &items.front();
    return !is_curve(item) && !stands && is_short(robot, item);
  });
}

double share_for_bends(const RobotModel& robot, const ShapedLeg& leg,
                       const std::deque<PathItem>& next) {
  const double window = leg.segment.ahead.window;
  if (window == 0 || robot.tool_coordinates) return 1;
  if (leg.merged()) return share_for_mean(robot, leg.segment.ahead);
  const bool leads = is_short(robot, {leg.segment, leg.stretch});
  if (const PathItem* const curve = leads ? first_curve(robot, next) : nullptr)
    return share_for_mean(robot, curve->segment.ahead);
  if (next.size() < 2) return 1;
  const SegmentDescriptor& second = next[0].segment;
  if (!has_way(second) || !has_way(next[1].segment) || second.from_rest) return 1;
  const ShapedLeg middle = shaped_item(robot, next[0], leg.end());
  const ShapedLeg last = shaped_item(robot, next[1], middle.end());
  return std::max(bend_share(robot, leg, middle, window), bend_share(robot, middle, last, window));
}

bool needs_shorter_mean(const RobotModel& robot, double window, const std::deque<PathItem>& items) {
  constexpr double kSame = 1.01;  // [choice]
  if (window == 0 || robot.tool_coordinates || items.empty()) return false;
  const PathItem* item = &items.front();
  if (!is_curve(*item) && item->stretch && item->stretch->goes_on && items.size() > 1)
    item = &items[1];
  if (!is_curve(*item)) return false;
  const LegBounds& bounds = item->segment.ahead;
  return window > kSame * bounds.window * share_for_mean(robot, bounds);
}

}  // namespace rob::motion
