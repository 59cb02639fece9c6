#include "motion/path/free_path.h"

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include "base/unit_factors.h"
#include "motion/path/choice.h"
#include "motion/path/ladder.h"
#include "motion/path/way_cost.h"

namespace rob::motion {

namespace {

constexpr double kRungWay = 0.01;          // m
constexpr double kRungTurn = 5 * kDegree;  // rad

/// How many rungs long a path is.
double rungs_of(const ToolPath& path) {
  const double range = path.end() - path.begin();
  return std::max(path.greatest_speed() / kRungWay, path.greatest_turning() / kRungTurn) * range;
}

/// The value of a choice along a path.
ValueSpline chosen_along(const RobotModel& robot, const ToolPath& path, const Choice& choice,
                         const JointVector& start) {
  const double length = rungs_of(path);
  const double rungs = std::clamp(std::ceil(length), 1.0, static_cast<double>(kMostNodes));
  std::vector<double> places;
  for (double k = 0; k <= rungs; ++k)
    places.push_back(path.begin() + (path.end() - path.begin()) * (k / rungs));
  const auto holds = Ladder(robot, choice, places, std::min(length, 1.0)).climb(start);
  std::vector<double> values(places.size(), holds.back().value);
  for (std::size_t k = 0; k < holds.size(); ++k) values[k] = holds[k].value;
  return ValueSpline(std::move(places), std::move(values));
}

bool stays_within(const RobotModel& robot, const JointPath& axes) {
  constexpr int kParts = 8;
  bool within = true;
  axes.survey(kParts, [&](double /*s*/, const PathPoint& point) {
    within = within && axes_within(robot, point.q);
  });
  return within;
}

}  // namespace

TurnedPath::TurnedPath(const ToolPath& path, const FreeTurn& free, ValueSpline angle)
    : path_(path), free_(free), angle_(std::move(angle)) {
  constexpr double kInRung = 4;  // [choice] a spline bends little between its values
  parts_ = std::max(path.parts(), std::ceil(rungs_of(path)));
  const double looks = kInRung * parts_;
  const double step = (end() - begin()) / looks;
  for (double k = 0; k <= looks; ++k) {
    const double turning = speed_at(*this, begin() + k * step).turn;
    turn_ += turning * step * (k == 0 || k == looks ? 0.5 : 1);
    greatest_turning_ = std::max(greatest_turning_, turning);
  }
}

TurnedPath choose_turn(const RobotModel& robot, const ToolPath& path, const Pose& tip,
                       const FreeTurn& free, const JointVector& start) {
  const Choice choice = Choice::of_turn(robot, path, tip, free);
  return TurnedPath(path, free, chosen_along(robot, path, choice, start));
}

Followed follow_choosing(const RobotModel& robot, const ToolPath& path, const Pose& tip,
                         const JointVector& start, bool& chosen) {
  const bool spare = robot.kinematics->spare() >= 0;
  const auto keeping = [&] { return follow(robot, path, tip, start); };
  const auto good = [&](const Followed& way) {
    return !way.trouble && stays_within(robot, way.axes);
  };
  chosen = false;
  if (!spare) return keeping();
  const bool shorter = rungs_of(path) < 1;
  if (shorter)
    if (Followed kept = keeping(); good(kept)) return kept;
  const Choice choice = Choice::of_axis(robot, path, tip);
  const ValueSpline value = chosen_along(robot, path, choice, start);
  Followed made = follow(robot, path, tip, start, nullptr, nullptr, &value);
  chosen = true;
  if (shorter || good(made)) return made;
  if (Followed kept = keeping(); good(kept)) {
    chosen = false;
    return kept;
  }
  return made;
}

}  // namespace rob::motion
