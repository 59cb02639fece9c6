#include "runtime/prompt/session_points.h"

#include <utility>

namespace rob::runtime {

SessionPoints::Change SessionPoints::take_change(const Points& points,
                                                 const motion::RobotModel& robot) {
  Change change;
  std::map<std::string, std::string> present;
  for (const Points::Point& point : points.points) {
    if (!point.value.frame.empty()) continue;
    std::string line = point_text(point, robot);
    const auto old = declared_.find(point.value.name);
    if (old == declared_.end() || old->second != line)
      change.declares += (change.declares.empty() ? "POINT " : "\nPOINT ") + point.value.name;
    present.emplace(point.value.name, std::move(line));
  }
  for (const auto& [name, line] : declared_) {
    if (!present.contains(name)) change.gone.push_back(name);
  }
  declared_ = std::move(present);
  return change;
}

}  // namespace rob::runtime
