#include "runtime/pictures/path_view.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "runtime/words/units.h"

namespace rob::runtime {

namespace {

using Stretches = std::vector<ToolWay::Stretch>;

/// A field that has room for the ways and for a tenth around them; at least 1 mm.
PathView fitted(PathView view, const Stretches& stretches) {
  constexpr double kEndless = std::numeric_limits<double>::infinity();
  view.left = view.bottom = kEndless;
  view.right = view.top = -kEndless;
  for (const ToolWay::Stretch& stretch : stretches)
    for (const Eigen::Vector3d& point : stretch.corners) {
      const auto [across, up] = view.seen(point);
      view.left = std::min(view.left, across);
      view.right = std::max(view.right, across);
      view.bottom = std::min(view.bottom, up);
      view.top = std::max(view.top, up);
    }
  if (stretches.empty()) view.left = view.right = view.bottom = view.top = 0;
  const double room = std::max({view.width(), view.height(), 1.0}) / 10;
  view.left -= room;
  view.right += room;
  view.bottom -= room;
  view.top += room;
  return view;
}

bool leaves_its_height(const Stretches& stretches) {
  constexpr double kFlat = 1e-5;  // m [choice] what a picture shows
  return std::ranges::any_of(stretches, [&](const ToolWay::Stretch& stretch) {
    return std::ranges::any_of(stretch.corners, [&](const Eigen::Vector3d& point) {
      return std::abs(point.z() - stretches.front().corners.front().z()) > kFlat;
    });
  });
}

}  // namespace

std::pair<double, double> PathView::seen(const Eigen::Vector3d& place) const {
  return {place.x() * kMillimetresPerMetre, place[up] * kMillimetresPerMetre};
}

std::pair<double, double> PathView::middle_of(const std::vector<Eigen::Vector3d>& points) const {
  double rest = 0;
  for (std::size_t i = 1; i < points.size(); ++i) rest += (points[i] - points[i - 1]).norm() / 2;
  for (std::size_t i = 1; i < points.size(); ++i) {
    const Eigen::Vector3d way = points[i] - points[i - 1];
    if (rest <= way.norm() && rest > 0) return seen(points[i - 1] + way * (rest / way.norm()));
    rest -= way.norm();
  }
  return seen(points.back());
}

double PathView::grid_step() const {
  constexpr double kLines = 8;  // [choice]
  const double rough = std::max(width(), height()) / kLines;
  const double power = std::pow(10, std::floor(std::log10(rough)));
  for (const double factor : {1.0, 2.0, 5.0})
    if (rough <= factor * power) return factor * power;
  return 10 * power;
}

std::vector<PathView> views_of(const motion::RobotModel& robot, const Stretches& stretches) {
  std::vector<PathView> views = {fitted({"plan", "x", "y", 1}, stretches)};
  if (robot.tool_coordinates || leaves_its_height(stretches))
    views.push_back(fitted({"side", "x", "z", 2}, stretches));
  return views;
}

}  // namespace rob::runtime
