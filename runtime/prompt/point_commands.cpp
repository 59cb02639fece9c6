#include "runtime/prompt/point_commands.h"

#include <fmt/format.h>

#include "runtime/files/files.h"
#include "runtime/prompt/session.h"
#include "runtime/words/pose_values.h"
#include "runtime/words/units.h"

namespace rob::runtime::command {

namespace {

/// The file in which points are kept; null, and that is reported, if there is none.
PointsFile* kept_points(Session& session) {
  PointsFile* const points = session.robot().points();
  if (points == nullptr || session.points_file().empty()) {
    session.fail("points are not kept at this prompt", ":load a program, its points are with it");
    return nullptr;
  }
  return points;
}

bool is_name(const std::string& word) {
  return !word.empty() && lang::begins_word(word.front()) &&
         std::ranges::all_of(word, lang::in_word);
}

/// Where the flange is at the point, in the world; none if only its frame's program knows.
std::optional<motion::Pose> place_of(const Points::Point& point, const motion::RobotModel& robot) {
  if (!point.joints.empty()) {
    const Eigen::Map<const Eigen::VectorXd> q(point.joints.data(), robot.axis_count());
    return robot.kinematics->forward(q);
  }
  if (point.value.frame.empty()) return to_motion(point.value.pose);
  return std::nullopt;
}

void show(Session& session, const Points::Point& point, const motion::Pose& here) {
  const motion::RobotModel& robot = session.robot().robot();
  std::string text = point_text(point, robot);
  text = text.substr(0, text.find(" TAUGHT"));
  const auto place = place_of(point, robot);
  if (place) {
    const double distance = (place->position - here.position).norm() * kMillimetresPerMetre;
    text += fmt::format("  {} mm from here", shown(distance, 1));
  }
  session.screen().result(text + "\n");
}

void undo_points(Session& session) {
  PointsFile* const points = kept_points(session);
  if (points == nullptr || !session.stands(":points undo")) return;
  if (!points->undo()) return session.fail("no change of a point is left to take back");
  session.take_points();
}

}  // namespace

void teach(Session& session, const Words& words) {
  if (words.size() != 1 || !is_name(words[0]))
    return session.fail(":teach takes the name of a point", ":teach pick", ExitCode::Usage);
  session.teach(words[0]);
}

void points(Session& session, const Words& words) {
  if (!words.empty() && words[0] == "undo") return undo_points(session);
  if (!words.empty()) return session.fail(":points takes nothing, or undo", "", ExitCode::Usage);
  if (kept_points(session) == nullptr) return;
  const motion::RobotModel& robot = session.robot().robot();
  const auto& last = session.robot().reports().last();
  const motion::Pose here = robot.kinematics->forward(last ? last->measured : robot.start);
  const Points all = load_points(session.points_file(), robot);
  for (const Points::Point& point : all.points) show(session, point, here);
  if (all.points.empty()) session.screen().message("no point has been taught\n");
}

void rename(Session& session, const Words& words) {
  if (words.size() != 2 || !is_name(words[1]))
    return session.fail(":rename takes a point and its new name", "", ExitCode::Usage);
  PointsFile* const points = kept_points(session);
  if (points == nullptr || !session.stands(":rename")) return;
  ProgramText& program = session.workshop().program;
  if (program.has_name(words[1]))
    return session.fail(fmt::format("the program in memory has the name {} already", words[1]));
  if (!session.rename_point(words[0], words[1]))
    return session.fail(fmt::format("there is no point {}", words[0]), ":points lists them");
  program.rename({words[0], words[1]});
  session.screen().message(fmt::format("{} is {} now; :undo takes it back\n", words[0], words[1]));
}

void forget(Session& session, const Words& words) {
  if (words.size() != 1)
    return session.fail(":forget takes the name of a point", "", ExitCode::Usage);
  PointsFile* const points = kept_points(session);
  if (points == nullptr || !session.stands(":forget")) return;
  if (!points->forget(words[0]))
    return session.fail(fmt::format("there is no point {}", words[0]), ":points lists them");
  session.take_points();
  session.screen().message(fmt::format("{} is forgotten; :points undo brings it back\n", words[0]));
}

}  // namespace rob::runtime::command
