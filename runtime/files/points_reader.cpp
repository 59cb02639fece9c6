#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <map>
#include <utility>

#include "lang/machine/robot_signature.h"
#include "lang/text/ascii.h"
#include "lang/text/source_text.h"
#include "lang/values/number_text.h"
#include "lang/values/units.h"
#include "runtime/files/line_reader.h"
#include "runtime/files/points_file.h"
#include "runtime/files/text_lines.h"
#include "runtime/words/codes.h"
#include "runtime/words/pose_values.h"
#include "runtime/words/signature.h"
#include "runtime/words/units.h"

/// The reader of points files.
namespace rob::runtime {

namespace {

using lang::TokenKind;

constexpr std::size_t kMostPoints = 10'000;  // [choice] far more than anybody teaches
constexpr std::size_t kMostName = 64;        // bytes [choice]
// How far the axes may lead beside a pose. A file is rounded to 0.001 mm and 0.0001 deg, at most
// half of that beside each number. The pose is then off by sqrt(3) * 0.5 um = 0.9 um, a linear axis
// by 0.5 um, a rotary one by 0.00005 deg = 8.7e-7 rad: 0.9 um at the end of a lever of 1 m. The
// levers of all axes together would have to be more than 100 m long to come to 0.1 mm. In the same
// way three angles and ten axes turn by 0.0007 deg at most. [choice] other robots are off by more.
constexpr double kSamePlace = 1e-4;  // m
constexpr double kSameTurn = 0.1 / kDegreesPerRadian;
constexpr std::string_view kText = "a text between quotes";

class PointsReader : LineReader {
 public:
  PointsReader(Points& points, std::string_view text, const motion::RobotModel& robot)
      : LineReader(text, points.diagnostics, code::kPointLine,
                   "mend the line, or take it out and TEACH the point again"),
        points_(points),
        kinematics_(robot.kinematics.get()),
        robot_(signature_of(robot)) {}

  /// The first line names the robot; the points of another one are of no use.
  void read() {
    read_lines([&] {
      if (robot_line_ != 0) {
        point();
        return true;
      }
      robot_line_ = token_.place.line;
      return robot();
    });
  }
  /// After read(), of a file without errors: the comments, which are no tokens.
  void take_remarks(std::string_view text);

 private:
  bool robot();
  void point();
  std::string point_name();
  lang::PoseValue pose();
  std::vector<double> joints();
  double quantity(lang::Dimension dimension);
  std::string name_or(std::string_view nothing);

  /// The first line says to which pose JOINTS bring the flange.
  void compare_geometry(const lang::Place& place);
  /// JOINTS lead to another pose than the point's: the robot has another geometry, though the name
  /// is the same, or somebody has changed the pose. In a frame, or with a tool, nothing is known.
  void compare(const Points::Point& point, const lang::Place& place);
  /// Where the joints bring the flange, if that is not `pose`.
  std::optional<lang::PoseValue> elsewhere(const std::vector<double>& joints,
                                           const lang::PoseValue& pose) const;

  Points& points_;
  const motion::Kinematics* kinematics_;
  lang::RobotSignature robot_;
  std::uint32_t robot_line_ = 0;
  std::map<std::string, std::uint32_t> lines_;  ///< of the points read, by name in capitals
};

/// Where the comment of a line begins; its length if there is none. "//" in a text is none.
std::size_t comment_of(std::string_view line) {
  bool in_text = false;
  for (std::size_t i = 0; i < line.size(); ++i) {
    if (in_text && line[i] == '\\') {
      ++i;
    } else if (line[i] == '"') {
      in_text = !in_text;
    } else if (!in_text && line.substr(i).starts_with("//")) {
      return i;
    }
  }
  return line.size();
}

/// "(40 mm, 20 mm, 0 mm)"
std::string place_text(const lang::PoseValue& pose) {
  constexpr auto kLinear = motion::AxisKind::Linear;
  const auto& [x, y, z] = pose.position;
  return fmt::format("({}, {}, {})", shown(x, kLinear), shown(y, kLinear), shown(z, kLinear));
}

void PointsReader::take_remarks(std::string_view text) {
  std::map<std::uint32_t, Points::Remarks*> owners{{robot_line_, &points_.robot}};
  for (Points::Point& point : points_.points) {
    owners[lines_.at(lang::to_upper(point.value.name))] = &point.remarks;
  }
  constexpr std::string_view kMark = "\xEF\xBB\xBF";  // byte order
  if (text.starts_with(kMark)) text.remove_prefix(kMark.size());
  std::string above;
  for (std::uint32_t number = 1; !text.empty(); ++number) {
    std::string_view line = take_line(text);
    while (line.ends_with('\r') || line.ends_with(' ')) line.remove_suffix(1);
    const std::size_t comment = comment_of(line);
    if (const auto owner = owners.find(number); owner != owners.end()) {
      *owner->second = {std::exchange(above, ""), std::string(line.substr(comment))};
    } else if (line.find_first_not_of(" \t") >= comment) {
      above += fmt::format("{}\n", line);
    }
  }
  points_.below = above;
}

// robot = "ROBOT" STRING [ joints pose ]
bool PointsReader::robot() {
  take_word("ROBOT");
  const lang::Place place = token_.place;
  const std::string name = take_text(kText);
  if (name == robot_.name) {
    if (at_word("JOINTS")) compare_geometry(place);
    end_of_line();
    return true;
  }
  while (token_.kind != TokenKind::EndOfLine && token_.kind != TokenKind::EndOfFile) advance();
  points_.diagnostics.error(
      code::kPointsOfOther, place,
      fmt::format("these points were taught on the robot {}; the program is for {}",
                  lang::shortened(name), robot_.name),
      fmt::format("run the program with --robot {}, or move the file away and teach anew",
                  lang::shortened(name)));
  return false;
}

// point = IDENT "=" pose [ joints ] "IN" ( "world" | IDENT ) [ "TOOL" ( "none" | IDENT ) ] "TAUGHT"
//         STRING
void PointsReader::point() {
  const lang::Place place = token_.place;
  Points::Point point;
  point.value.name = point_name();
  take(TokenKind::Assign, "'='");
  point.value.pose = pose();
  if (at_word("JOINTS")) point.joints = joints();
  take_word("IN");
  point.value.frame = name_or("world");
  if (at_word("TOOL")) {
    advance();
    point.tool = name_or("none");
  }
  take_word("TAUGHT");
  point.taught = take_text(kText);
  end_of_line();
  compare(point, place);
  const auto [first, is_new] = lines_.emplace(lang::to_upper(point.value.name), place.line);
  if (!is_new) {
    fail(code::kPointTwice, place,
         fmt::format("{} stands in this file twice, first in line {}", point.value.name,
                     first->second),
         "take out the line that is not meant");
  }
  if (points_.points.size() == kMostPoints) {
    fail(code::kPointLine, place, fmt::format("a points file has at most {} points", kMostPoints),
         "take out those that the program does not need");
  }
  points_.points.push_back(std::move(point));
}

std::optional<lang::PoseValue> PointsReader::elsewhere(const std::vector<double>& joints,
                                                       const lang::PoseValue& pose) const {
  if (kinematics_ == nullptr) return std::nullopt;
  const Eigen::Map<const Eigen::VectorXd> q(joints.data(), kinematics_->axes());
  const lang::PoseValue there = to_lang(kinematics_->forward(q));
  using lang::pose_math::operator-;
  const bool same = lang::pose_math::length(there.position - pose.position) <= kSamePlace &&
                    lang::pose_math::turn(there, pose) <= kSameTurn;
  return same ? std::nullopt : std::optional(there);
}

void PointsReader::compare_geometry(const lang::Place& place) {
  const std::vector<double> at = joints();
  const auto there = elsewhere(at, pose());
  if (!there) return;
  points_.diagnostics.error(
      code::kPointsOfOther, place,
      fmt::format(
          "these points were taught on another geometry than that of this {}: the JOINTS here"
          " bring its flange to {}, not to their POSE",
          robot_.name, place_text(*there)),
      "run the program on that robot, or move the file away and teach anew");
}

void PointsReader::compare(const Points::Point& point, const lang::Place& place) {
  const bool bare = point.value.frame.empty() && point.tool.empty() && !point.joints.empty();
  const auto there = bare ? elsewhere(point.joints, point.value.pose) : std::nullopt;
  if (!there) return;
  fail(code::kPointsOfOther, place,
       fmt::format("the JOINTS of {} bring this {} to {}, which is not its POSE: it was"
                   " taught on one of another geometry, or changed by hand",
                   point.value.name, robot_.name, place_text(*there)),
       "TEACH the point again; where the POSE is right, leave out JOINTS(…) and TOOL");
}

std::string PointsReader::point_name() {
  if (token_.kind != TokenKind::Word || token_.text.size() > kMostName) {
    expected(fmt::format("the name of a point, of at most {} bytes,", kMostName));
  }
  std::string name(token_.text);
  advance();
  return name;
}

lang::PoseValue PointsReader::pose() {
  take_word("POSE");
  take(TokenKind::LeftParen, "'('");
  double numbers[6];
  for (int i = 0; i < 6; ++i) {
    if (i > 0) take(TokenKind::Comma, "','");
    numbers[i] = quantity(i < 3 ? lang::kLength : lang::kAngle);
  }
  take(TokenKind::RightParen, "')'");
  return {{numbers[0], numbers[1], numbers[2]},
          lang::pose_math::from_fixed({numbers[3], numbers[4], numbers[5]})};
}

std::vector<double> PointsReader::joints() {
  take_word("JOINTS");
  take(TokenKind::LeftParen, "'('");
  std::vector<double> joints;
  for (const lang::RobotSignature::Coordinate& axis : robot_.axes) {
    if (!joints.empty()) take(TokenKind::Comma, "','");
    joints.push_back(quantity(axis.dimension));
  }
  take(TokenKind::RightParen, "')'");
  return joints;
}

double PointsReader::quantity(lang::Dimension dimension) {
  const bool negative = token_.kind == TokenKind::Minus;
  if (negative) advance();
  const bool fits = token_.kind == TokenKind::Number && token_.number.dimension == dimension;
  if (!fits || !std::isfinite(token_.number.value)) {
    expected(dimension == lang::kLength ? "a length such as 20mm" : "an angle such as 90deg");
  }
  const double value = lang::to_si(token_.number.value, dimension);
  advance();
  return negative ? 0.0 - value : value;
}

/// Empty for `nothing`.
std::string PointsReader::name_or(std::string_view nothing) {
  if (token_.kind != TokenKind::Word || token_.text.size() > kMostName) {
    expected(fmt::format("a name, or {},", nothing));
  }
  std::string name(token_.text);
  advance();
  return lang::same_word(name, nothing) ? "" : name;
}

}  // namespace

Points parse_points(std::string_view text, const motion::RobotModel& robot) {
  Points points;
  if (!lang::check_source(text, points.diagnostics)) return points;
  PointsReader reader(points, text, robot);
  reader.read();
  if (!points.diagnostics.has_errors()) reader.take_remarks(text);
  return points;
}

}  // namespace rob::runtime
