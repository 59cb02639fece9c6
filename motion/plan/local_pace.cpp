#include "motion/plan/local_pace.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

namespace rob::motion {

namespace {

/// [choice] The share of an axis' acceleration that a steady rate may use; the rest changes the
/// rate.
constexpr double kSteady = 0.8;
/// [choice] The same of its jerk: changes of the rate on a bent path need as much.
constexpr double kSteadyJerk = 0.5;
/// [choice] How many places of each piece of the axes get a rate.
constexpr int kPlacesAPiece = 8;

/// The axes' derivatives at a place of the path, and the path's rate there, 1/s.
struct PacedPlace {
  double s = 0;
  PathPoint axes;
  double rate = 0;
};

/// |q_ss|·c² + |q_s|·change·c <= what is steady, and |q_s|·c <= v_max.
double steady_rate(const RobotModel& robot, const PathPoint& point, const PaceWish& wish) {
  double rate = wish.rate;
  for (int i = 0; i < robot.axis_count(); ++i) {
    const Axis& axis = robot.axes[static_cast<std::size_t>(i)];
    const double slope = std::abs(point.qd[i]);
    const double bend = std::abs(point.qdd[i]);
    rate = std::min(rate, wish.share * axis.v_max / slope);
    const double linear = slope * wish.change;
    const double steady = kSteady * axis.a_max;
    rate = std::min(rate, 2 * steady / (linear + std::sqrt(linear * linear + 4 * bend * steady)));
  }
  return rate;
}

/// |q_sss|·c³ <= what is steady, from place to place.
void keep_jerk(const RobotModel& robot, std::vector<PacedPlace>& places) {
  for (std::size_t k = 1; k < places.size(); ++k) {
    const JointVector bends = places[k].axes.qdd - places[k - 1].axes.qdd;
    for (int i = 0; i < robot.axis_count(); ++i) {
      const double third = std::abs(bends[i]) / (places[k].s - places[k - 1].s);
      const double most = kSteadyJerk * robot.axes[static_cast<std::size_t>(i)].j_max;
      const double rate = std::cbrt(most / third);
      places[k].rate = std::min(places[k].rate, rate);
      places[k - 1].rate = std::min(places[k - 1].rate, rate);
    }
  }
}

/// 1/s² by which a rate may change where the axes keep it.
double greatest_change(const RobotModel& robot, const PacedPlace& place, double change) {
  double most = std::numeric_limits<double>::infinity();
  for (int i = 0; i < robot.axis_count(); ++i) {
    const double slope = std::abs(place.axes.qd[i]);
    const double taken =
        std::abs(place.axes.qdd[i]) * place.rate * place.rate + slope * place.rate * change;
    const double left = robot.axes[static_cast<std::size_t>(i)].a_max - taken;
    most = std::min(most, std::max(left, 0.0) / slope);
  }
  return most;
}

/// s: a mean over this time keeps the jerk of an axis that goes from full acceleration to full
/// braking.
double mean_for(const RobotModel& robot) {
  double average = 8 * robot.reference_period;  // [choice] where jerk has no bound
  for (const Axis& axis : robot.axes)
    if (std::isfinite(axis.j_max)) average = std::max(average, 2 * axis.a_max / axis.j_max);
  return average;
}

/// The mean at a place contains the rates of all places within its time: none of them may be
/// faster than the slowest permits.
void spread(std::vector<PacedPlace>& places, double average) {
  const std::vector<PacedPlace> own = places;
  for (std::size_t k = 0; k < own.size(); ++k) {
    const double reach = own[k].rate * average;  // [choice] twice what an even rate reaches
    for (std::size_t i = k; i-- > 0 && own[k].s - own[i].s <= reach;)
      places[i].rate = std::min(places[i].rate, own[k].rate);
    for (std::size_t i = k + 1; i < own.size() && own[i].s - own[k].s <= reach; ++i)
      places[i].rate = std::min(places[i].rate, own[k].rate);
  }
}

/// From place to place the rate changes no faster than the axes can.
template <typename Places>
void follow_changes(const RobotModel& robot, double change, Places begin, Places end) {
  for (Places place = begin; place != end && place + 1 != end; ++place) {
    auto& next = *(place + 1);
    const double way = std::abs(next.s - place->s);
    const double most = greatest_change(robot, *place, change);
    next.rate = std::min(next.rate, std::sqrt(place->rate * place->rate + 2 * most * way));
  }
}

}  // namespace

std::optional<PaceLaw> local_pace(const RobotModel& robot, const JointPath& axes,
                                  const PaceWish& wish) {
  std::vector<PacedPlace> places;
  axes.survey(kPlacesAPiece, [&](double s, const PathPoint& point) {
    const double share = (s - axes.begin()) / (axes.end() - axes.begin());
    places.push_back({share, point, steady_rate(robot, point, wish)});
  });
  const auto moves = [](const PacedPlace& place) {
    return place.rate > 0 && std::isfinite(place.rate);
  };
  if (!std::all_of(places.begin(), places.end(), moves)) return std::nullopt;
  const double average = mean_for(robot);
  keep_jerk(robot, places);
  spread(places, average);
  follow_changes(robot, wish.change, places.begin(), places.end());
  follow_changes(robot, wish.change, places.rbegin(), places.rend());
  std::vector<PaceLaw::Place> paced;
  paced.reserve(places.size());
  for (const PacedPlace& place : places) paced.push_back({place.s, place.rate});
  return PaceLaw(paced, average);
}

}  // namespace rob::motion
