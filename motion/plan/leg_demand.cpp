#include "motion/plan/leg_demand.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>
#include <vector>

#include "motion/path/tool_line.h"

namespace rob::motion {

namespace {

/// [choice] an axis turns by at most 5° in a piece: between neighbours its rates hardly bend.
constexpr int kDemandParts = 8;

}  // namespace

LegDemand demand_along(const ToolPath& path, const JointPath& axes) {
  LegDemand demand;
  demand.path = &axes;
  const bool even = dynamic_cast<const ToolLine*>(&path) != nullptr;
  const bool stands = path.axes() != nullptr && path.way() <= kSamePose;  // the axes alone turn
  if (!even && !stands) demand.uneven = &path;
  demand.rates = greatest_rates(axes);
  demand.way = path.way();
  demand.turn = path.turn();
  demand.pace_way = path.greatest_speed();
  demand.pace_turn = path.greatest_turning();
  demand.farthest = path.way();
  demand.leaving = path.greatest_speed();
  demand.first_point = (path.first_point() - path.begin()) / (path.end() - path.begin());
  demand.last_point = (path.last_point() - path.begin()) / (path.end() - path.begin());
  return demand;
}

/// The greatest of the samples, and of parabolas through one and its neighbours.
JointVector greatest_rates(const JointPath& axes) {
  constexpr int kFine = 32;
  constexpr double kRounding = 1e-6;  // what parabolas leave
  JointVector greatest = JointVector::Zero(axes.nodes().front().q.size());
  JointVector a;
  JointVector b;
  axes.survey(kFine, [&](double /*s*/, const PathPoint& point) {
    const JointVector c = point.qd.cwiseAbs();
    greatest = greatest.cwiseMax(c);
    for (int i = 0; i < a.size(); ++i) {
      if (b[i] <= a[i] || b[i] < c[i]) continue;
      const double peak = b[i] + (a[i] - c[i]) * (a[i] - c[i]) / (8 * (2 * b[i] - a[i] - c[i]));
      greatest[i] = std::max(greatest[i], peak);
    }
    a = std::exchange(b, c);
  });
  return greatest * (1 + kRounding);
}

std::optional<Refusal> first_beyond(const RobotModel& robot, const JointPath& axes) {
  std::optional<Refusal> found;
  axes.survey(kDemandParts, [&](double s, const PathPoint& point) {
    for (int i = 0; i < robot.axis_count() && !found; ++i) {
      const Axis& axis = robot.axes[static_cast<std::size_t>(i)];
      const bool below = point.q[i] < axis.min - kLimitTolerance;
      if (!below && point.q[i] <= axis.max + kLimitTolerance) continue;
      found = Refusal{below ? Refusal::Kind::PathBelowMinimum : Refusal::Kind::PathAboveMaximum, i,
                      point.q[i], below ? axis.min : axis.max};
      found->at = s;
    }
  });
  return found;
}

Slowest slowest_place(const RobotModel& robot, const ToolPath& path, const JointPath& axes,
                      double asked) {
  struct Place {
    Slowest found;
    double rate, speed;  // what the axes allow, 1/s; of the tool, per unit of the parameter
  };
  std::vector<Place> places;
  double most = 0;  // of the tool
  axes.survey(kDemandParts, [&](double s, const PathPoint& point) {
    const ToolSpeed tool = speed_at(path, s);
    Place place{
        {s, -1, 1}, std::numeric_limits<double>::infinity(), tool.way + kPerRadian * tool.turn};
    for (int i = 0; i < robot.axis_count(); ++i) {
      const double rate = robot.axes[static_cast<std::size_t>(i)].v_max / std::abs(point.qd[i]);
      if (!(rate < place.rate)) continue;
      place.rate = rate;
      place.found.axis = i;
    }
    if (place.found.axis < 0 || !(place.speed > 0)) return;
    most = std::max(most, place.rate * place.speed);
    places.push_back(place);
  });
  Slowest slowest;
  for (Place& place : places) {
    const double wanted = std::min(asked * place.speed, most);
    place.found.share = place.rate * place.speed / wanted;
    if (place.found.share < slowest.share) slowest = place.found;
  }
  return slowest;
}

PaceCut pace_cut(const RobotModel& robot, const ToolPath& path, const JointPath& axes,
                 double asked) {
  constexpr double kStands = 1e-9;    // m, of the tip
  constexpr double kSame = 1 + 1e-5;  // the rates along a path are known to a millionth
  PaceCut cut;
  cut.asked = asked;
  double most = asked * kSame;
  std::optional<double> from;
  double to = 0;
  if (!(asked > 0)) return cut;
  axes.survey(kDemandParts, [&](double s, const PathPoint& point) {
    for (int i = 0; i < robot.axis_count(); ++i) {
      const double needed = std::abs(point.qd[i]) / robot.axes[static_cast<std::size_t>(i)].v_max;
      if (!(needed > asked * kSame)) continue;
      if (!from) from = s;
      to = s;
      if (needed <= most) continue;
      most = needed;
      cut.axis = i;
    }
  });
  if (!from) return cut;
  cut.turning = path.way() <= kStands;
  cut.way = cut.turning ? path.turn() : path.way();
  cut.from = path.share_at(*from) * cut.way;
  cut.to = path.share_at(to) * cut.way;
  return cut;
}

ProfileLimits profile_limits(const RobotModel& robot, const JointVector& straight, double change) {
  constexpr double kUnbounded = std::numeric_limits<double>::infinity();
  ProfileLimits limits{kUnbounded, kUnbounded, kUnbounded};
  for (int i = 0; i < robot.axis_count(); ++i) {
    const Axis& axis = robot.axes[static_cast<std::size_t>(i)];
    const double way = std::abs(straight[i]);
    limits.rate = std::min(limits.rate, axis.v_max / way);
    limits.acceleration = std::min(limits.acceleration, (axis.a_max - change * axis.v_max) / way);
    limits.jerk = std::min(limits.jerk, axis.j_max / way);
  }
  return limits;
}

ProfileLimits profile_limits(const RobotModel& robot, const JointPath& axes, double change) {
  const JointVector rates = greatest_rates(axes);
  ProfileLimits limits = profile_limits(robot, rates, change);
  axes.survey(kDemandParts, [&](double /*s*/, const PathPoint& point) {
    for (int i = 0; i < robot.axis_count(); ++i) {
      const Axis& axis = robot.axes[static_cast<std::size_t>(i)];
      const double left = axis.a_max - change * axis.v_max;
      limits.rate = std::min(limits.rate, std::sqrt(left / 2 / std::abs(point.qdd[i])));
    }
  });
  limits.acceleration /= 2;
  return limits;
}

double least_time(const RobotModel& robot, const JointPath& axes, double change, int& axis) {
  double least = 0;
  axes.survey(kDemandParts, [&](double /*s*/, const PathPoint& point) {
    for (int i = 0; i < robot.axis_count(); ++i) {
      // a·T² − b·T − c = 0
      const double a = robot.axes[static_cast<std::size_t>(i)].a_max;
      const double b = std::abs(point.qd[i]) * change;
      const double c = std::abs(point.qdd[i]);
      const double time = (b + std::sqrt(b * b + 4 * a * c)) / (2 * a);
      if (time <= least) continue;
      least = time;
      axis = i;
    }
  });
  return least;
}

double pace_time(const RobotModel& robot, const LegDemand& demand,
                 const MotionRequest& request) noexcept {
  switch (request.pace) {
    case MotionRequest::Pace::Unspecified:
      return 0;
    case MotionRequest::Pace::ToolSpeed:
      return demand.pace_way / request.pace_value;
    case MotionRequest::Pace::AngularSpeed:
      return demand.pace_turn / request.pace_value;
    case MotionRequest::Pace::Share:
      return named_axes_time(robot, demand, request.pace) / request.pace_value;
  }
  return 0;
}

double live_unit_time(const RobotModel& robot, const LegDemand& demand,
                      const MotionRequest& request) noexcept {
  MotionRequest unit;
  unit.pace = request.live;
  unit.pace_value = 1;
  return pace_time(robot, demand, unit);
}

double named_axes_time(const RobotModel& robot, const LegDemand& demand,
                       MotionRequest::Pace pace) noexcept {
  using Pace = MotionRequest::Pace;
  if (pace == Pace::Unspecified) return 0;
  double least = 0;
  for (int i = 0; i < robot.axis_count(); ++i) {
    const Axis& axis = robot.axes[static_cast<std::size_t>(i)];
    const bool named = pace == Pace::Share || demand.path != nullptr ||
                       (pace == Pace::ToolSpeed && axis.kind == AxisKind::Linear) ||
                       (pace == Pace::AngularSpeed && axis.kind == AxisKind::Rotary);
    if (named) least = std::max(least, demand.rates[i] / axis.v_max);
  }
  return least;
}

}  // namespace rob::motion
