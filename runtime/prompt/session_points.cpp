#include "runtime/prompt/session_points.h"

#include <algorithm>
#include <filesystem>
#include <system_error>
#include <utility>

#include "runtime/files/files.h"
#include "runtime/files/text_lines.h"
#include "runtime/prompt/session_text.h"

namespace rob::runtime {

namespace {

/// ROBOT "gantry" …; comments and blank lines may come before. Empty where there is no such line.
std::string named_in_first_line(std::string_view text) {
  while (!text.empty()) {
    const std::string_view line = take_line(text);
    const std::size_t word = line.find_first_not_of(" \t\r");
    if (word == std::string_view::npos || line.substr(word).starts_with("//")) continue;
    const std::size_t name = line.find('"') + 1;
    const bool robot = find_word(line, "ROBOT") == word && name > 0;
    return robot ? std::string(line.substr(name, line.find('"', name) - name)) : "";
  }
  return "";
}

}  // namespace

std::string points_at_prompt(const std::string& name, const std::string& robot) {
  if (name.empty()) return "";
  namespace fs = std::filesystem;
  std::string part = robot;
  std::ranges::replace(part, '/', '_');
  const fs::path own = fs::path(name).replace_extension(part + ".points");
  std::error_code none;
  if (fs::exists(own, none) || !fs::is_regular_file(name, none)) return own.string();
  return named_in_first_line(read_file(name, kMostPointsBytes)) == robot ? name : own.string();
}

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
