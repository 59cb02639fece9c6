#include "runtime/files/points_file.h"

#include <fmt/chrono.h>
#include <fmt/format.h>
#include <sys/stat.h>

#include <algorithm>
#include <cerrno>
#include <ctime>
#include <numbers>
#include <utility>

#include "lang/machine/robot_signature.h"
#include "lang/text/ascii.h"
#include "lang/values/number_text.h"
#include "runtime/files/atomic_file.h"
#include "runtime/files/files.h"
#include "runtime/files/point_digits.h"
#include "runtime/words/codes.h"
#include "runtime/words/pose_values.h"
#include "runtime/words/signature.h"
#include "runtime/words/units.h"

namespace rob::runtime {

namespace {

bool is_there(const std::string& file) {
  struct stat status {};
  return ::lstat(file.c_str(), &status) == 0 || errno != ENOENT;
}

std::string pose_text(const lang::PoseValue& pose, const PointDigits& digits) {
  const auto& [p, q] = pose;
  std::string text = "POSE(";
  for (const double length : {p.x, p.y, p.z}) {
    const double mm = rounded_to(lang::from_si(length, lang::kLength), digits.length);
    text += lang::number_text(mm, lang::kLength) + ", ";
  }
  const lang::FixedAngles angles = rounded_angles(q, digits.angle);
  return text + fmt::format("{}, {}, {})", lang::number_text(angles.a, lang::kAngle),
                            lang::number_text(angles.b, lang::kAngle),
                            lang::number_text(angles.c, lang::kAngle));
}

/// With a blank before it; empty where there are none.
std::string joints_text(const std::vector<double>& joints, const lang::RobotSignature& robot,
                        const PointDigits& digits) {
  std::string text;
  for (std::size_t i = 0; i < joints.size(); ++i) {
    const lang::Dimension dimension = robot.axes[i].dimension;
    const double value = lang::from_si(joints[i], dimension);
    const double kept = digits.joints.empty() ? value : rounded_within(value, digits.joints.at(i));
    text += (i == 0 ? " JOINTS(" : ", ") + lang::number_text(kept, dimension);
  }
  return joints.empty() ? text : text + ")";
}

/// The robot by its name and, where that is known, by its geometry: where some joints bring it, as
/// exactly as can be.
std::string robot_line(const motion::RobotModel& robot) {
  std::string line = fmt::format("ROBOT \"{}\"", robot.name);
  if (robot.kinematics == nullptr) return line;
  std::vector<double> joints;
  // [choice] all different, and no right angle among them: then every length and sign shows.
  for (const motion::Axis& axis : robot.axes) {
    const auto number = static_cast<double>(joints.size() + 1);
    joints.push_back(axis.kind == motion::AxisKind::Linear
                         ? number * 100 / kMillimetresPerMetre
                         : number * 17 * (std::numbers::pi / 180));  // as literals are read
  }
  const Eigen::Map<const Eigen::VectorXd> q(joints.data(), robot.axis_count());
  return line + joints_text(joints, signature_of(robot), {}) + " " +
         pose_text(to_lang(robot.kinematics->forward(q)), {});
}

std::string line_of(const Points::Point& point, const lang::RobotSignature& robot,
                    const PointDigits& digits) {
  std::string line = fmt::format("{} = {}{}", point.value.name, pose_text(point.value.pose, digits),
                                 joints_text(point.joints, robot, digits));
  const std::string& frame = point.value.frame;
  line += fmt::format(" IN {}", frame.empty() ? "world" : frame);
  if (!point.joints.empty()) {
    line += fmt::format(" TOOL {}", point.tool.empty() ? "none" : point.tool);
  }
  return line + fmt::format(" TAUGHT \"{}\"", point.taught);
}

std::string with(const Points::Remarks& remarks, const std::string& line) {
  return fmt::format("{}{}{}{}\n", remarks.above, line, remarks.behind.empty() ? "" : "  ",
                     remarks.behind);
}

std::string now() {
  return fmt::format("{:%Y-%m-%d %H:%M:%S} UTC", fmt::gmtime(std::time(nullptr)));
}

auto find(Points& points, std::string_view name) {
  return std::ranges::find_if(points.points, [&](const Points::Point& one) {
    return lang::same_word(one.value.name, name);
  });
}

}  // namespace

lang::PointTable Points::table() const {
  lang::PointTable table;
  for (const Point& point : points) {
    table.points.push_back(point.value);
    table.points.back().joints = point.joints;
    table.points.back().with_tool = !point.tool.empty();
  }
  return table;
}

std::string points_file_of(const std::string& program_file) {
  constexpr std::string_view kProgram = ".rob";
  const bool program = program_file.ends_with(kProgram);
  return program_file.substr(0, program_file.size() - (program ? kProgram.size() : 0)) + ".points";
}

std::string point_text(const Points::Point& point, const motion::RobotModel& robot) {
  return line_of(point, signature_of(robot), digits_of(robot));
}

/// Then the file is any robot's.
static bool is_empty(const Points& points) {
  return points.points.empty() && points.below.empty() && points.robot.above.empty() &&
         points.robot.behind.empty();
}

std::string points_text(const Points& points, const motion::RobotModel& robot) {
  const lang::RobotSignature signature = signature_of(robot);
  const PointDigits digits = digits_of(robot);
  std::vector<const Points::Point*> sorted;
  for (const Points::Point& point : points.points) sorted.push_back(&point);
  std::ranges::sort(sorted, {},
                    [](const Points::Point* point) { return lang::to_upper(point->value.name); });
  std::string text = with(points.robot, robot_line(robot));
  for (const Points::Point* const point : sorted) {
    text += with(point->remarks, line_of(*point, signature, digits));
  }
  return text + points.below;
}

Points load_points(const std::string& file, const motion::RobotModel& robot) {
  if (!is_there(file)) return {};
  const std::string text = read_file(file, kMostPointsBytes);
  Points points = parse_points(text, robot);
  if (!points.diagnostics.has_errors()) return points;
  std::string messages = fmt::format("the points in '{}' cannot be used", file);
  for (const lang::Diagnostic& found : points.diagnostics.all()) {
    messages += fmt::format("\n{}", lang::render(found, file, text));
  }
  while (messages.ends_with('\n')) messages.pop_back();
  throw FileError(messages);
}

std::optional<lang::Refusal> PointsFile::keep(const lang::TaughtPoint& point) {
  Points::Point taught;
  taught.value = {std::string(point.name), std::string(point.frame), point.pose};
  taught.tool = point.tool;
  taught.joints = point.joints;
  taught.taught = now();
  try {
    change([&](Points& points) {
      const auto old = find(points, point.name);
      if (old == points.points.end()) {
        points.points.push_back(std::move(taught));
      } else {
        taught.remarks = std::move(old->remarks);
        *old = std::move(taught);
      }
      return true;
    });
  } catch (const FileError& error) {
    return lang::Refusal{code::kPointNotKept,
                         fmt::format("{} cannot be kept: {}", point.name, error.what()),
                         "the points file is as it was"};
  }
  return std::nullopt;
}

bool PointsFile::rename(std::string_view name, const std::string& new_name) {
  return change([&](Points& points) {
    const auto old = find(points, name);
    if (old == points.points.end()) return false;
    const auto other = find(points, new_name);
    if (other != points.points.end() && other != old)
      throw FileError(fmt::format("there is a point {} already", new_name));
    old->value.name = new_name;
    return true;
  });
}

bool PointsFile::forget(std::string_view name) {
  return change([&](Points& points) {
    const auto old = find(points, name);
    if (old == points.points.end()) return false;
    points.points.erase(old);
    return true;
  });
}

bool PointsFile::change(const std::function<bool(Points&)>& edit) {
  const std::lock_guard lock(mutex_);
  std::string before = is_there(file_) ? read_file(file_, kMostPointsBytes) : "";
  Points points = load_points(file_, robot_);
  if (!edit(points)) return false;
  std::string after = is_empty(points) ? "" : points_text(points, robot_);
  save_file(file_, after);
  changes_.push_back({std::move(before), std::move(after)});
  return true;
}

bool PointsFile::undo() {
  const std::lock_guard lock(mutex_);
  if (changes_.empty()) return false;
  if (!is_there(file_) || read_file(file_, kMostPointsBytes) != changes_.back().after)
    throw FileError(fmt::format("'{}' has been changed by others since", file_));
  const std::string& before = changes_.back().before;
  save_file(file_, before);
  changes_.pop_back();
  return true;
}

void PointsFile::move_to(std::string file) {
  const std::lock_guard lock(mutex_);
  file_ = std::move(file);
  changes_.clear();
}

}  // namespace rob::runtime
