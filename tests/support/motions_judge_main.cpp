// Runs random programs of all kinds of motions through a built `rob` and judges their traces.
//
//   motions_judge ROB ROBOT [N [SEED]] [--law LAW]    ROBOT: a built-in one, or a file of three
//   axes motions_judge ROB ROBOT --show SEED               prints one program and its signal script

#include <algorithm>
#include <cinttypes>
#include <cstdint>
#include <cstdio>
#include <exception>
#include <fstream>
#include <iterator>
#include <limits>
#include <stdexcept>
#include <string>
#include <vector>

#include "motion/robots/robot_file.h"
#include "motion/robots/robot_library.h"
#include "tests/support/motions_judge.h"
#include "tests/support/scratch_folder.h"

namespace {

using namespace rob::test;
using Kind = MotionRobot::Kind;

AxisBounds bounds_of(const rob::motion::Axis& axis, bool look_ahead) {
  const bool linear = axis.kind == rob::motion::AxisKind::Linear;
  const double unit = linear ? 1e3 : 180 / 3.14159265358979323846;
  // Paul's law bounds no jerk but its own.
  const double j =
      look_ahead && axis.j_max > 0 ? axis.j_max * unit : std::numeric_limits<double>::infinity();
  return {axis.min * unit, axis.max * unit, axis.v_max * unit, axis.a_max * unit, j};
}

/// Where and how fast an arm is to work: in front of it, within reach of a tool that hangs down.
struct Work {
  const char* robot;
  double least[3], most[3];  // mm
  double reach;
  double turn;  // deg: c of a tool that hangs down and turns with the arm
  int least_speed, most_speed;
};
constexpr Work kArms[] = {
    {"irb120", {280, -120, 250}, {400, 120, 370}, 120, 180, 20, 400},
    {"lwa4p", {360, -100, 180}, {470, 100, 290}, 100, 180, 20, 300},
    {"pc104", {680, -200, 450}, {880, 200, 650}, 200, 0, 20, 500},
    {"puma560", {440, -260, -160}, {600, 0, 0}, 150, 180, 20, 400},
    {"ums7", {500, -150, 420}, {680, 150, 580}, 150, 180, 20, 400},
};

/// A robot without its cell, so that there is nothing to meet for a tool that is led anywhere, and
/// no output that acts on an input: the name, or a file in `folder`.
std::string without_cell(const std::string& name, const ScratchFolder& folder) {
  const auto robots = rob::motion::embedded_robots();
  const auto found = std::ranges::find(robots, name, &rob::motion::EmbeddedRobot::name);
  if (found == robots.end()) return name;
  const std::string text(found->text);
  const std::size_t cell = text.find("\n[cell]");
  if (cell == std::string::npos) return name;
  const std::size_t arm = text.find("\n[arm]", cell);
  const std::size_t signals = text.find("\n[[signal]]", arm);
  std::ofstream(folder.path() / "robot.toml")
      << text.substr(0, cell) << text.substr(arm, signals - arm);
  return folder.file("robot.toml");
}

MotionRobot motion_robot(const std::string& name, bool look_ahead, const ScratchFolder& folder) {
  const rob::motion::RobotModel model =
      name.ends_with(".toml") ? rob::motion::parse_robot_file(read_whole_file(name), name)
                              : rob::motion::embedded_robot(name);
  MotionRobot robot;
  robot.robot = without_cell(name, folder);
  robot.look_ahead = look_ahead;
  robot.zone = look_ahead ? model.zone.distance * 1e3 : 1e9;
  for (const auto& axis : model.axes) robot.axes.push_back(bounds_of(axis, look_ahead));
  if (model.tool_coordinates) {
    const auto* const work = std::find_if(std::begin(kArms), std::end(kArms),
                                          [&](const Work& one) { return name == one.robot; });
    if (work == std::end(kArms)) throw std::runtime_error("no place to work is known of " + name);
    robot.kind = Kind::Arm;
    robot.least = Eigen::Map<const Eigen::Vector3d>(work->least);
    robot.most = Eigen::Map<const Eigen::Vector3d>(work->most);
    robot.turned.z() = work->turn;
    robot.reach = work->reach;
    robot.least_speed = work->least_speed, robot.most_speed = work->most_speed;
  } else if (model.name == "gantry") {
    robot.kind = Kind::Gantry;
    robot.least = {60, 60, 0}, robot.most = {340, 240, 0};
    robot.reach = 40;
    robot.least_speed = 2, robot.most_speed = 20;
  } else {
    robot.least = {-200, -200, -200}, robot.most = {200, 200, 200};
    robot.turning = model.axes.size() > 3;
    robot.reach = 150;
    robot.least_speed = 20, robot.most_speed = 600;
  }
  return robot;
}

void show(const RandomMotions& made) {
  std::printf("%s\n// --override %s --signals:\n%s", made.text.c_str(), made.override_share.c_str(),
              made.signals.c_str());
}

/// Whether they are right.
bool judge_all(const std::string& rob, const std::string& name, const MotionRobot& robot,
               std::uint64_t count, std::uint64_t seed, const std::string& law) {
  constexpr std::uint64_t kRefusedOf = 20;  // [choice] no more than one of these
  std::uint64_t failed = 0, refused = 0;
  for (std::uint64_t number = seed; number < seed + count; ++number) {
    const RandomMotions made = random_motions(number, robot);
    Judgement judgement;
    try {
      judgement = judge_motions(rob, robot, made, {"--law", law});
    } catch (const std::exception& error) {
      judgement.findings = {error.what()};
    }
    if (judgement.findings.empty()) continue;
    (judgement.refused ? refused : failed) += 1;
    std::printf("program %" PRIu64 " on %s%s:\n", number, name.c_str(),
                judgement.refused ? " was refused" : "");
    for (const std::string& finding : judgement.findings) std::printf("  %s\n", finding.c_str());
    std::fflush(stdout);
  }
  std::printf("%" PRIu64 " programs on %s judged, %" PRIu64 " failed, %" PRIu64 " refused\n", count,
              name.c_str(), failed, refused);
  return failed == 0 && refused * kRefusedOf <= count;
}

}  // namespace

int main(int count, char** arguments) {
  std::vector<std::string> words(arguments + 1, arguments + count);
  std::string law = "lookahead";
  if (words.size() > 3 && words[words.size() - 2] == "--law") {
    law = words.back();
    words.resize(words.size() - 2);
  }
  try {
    if (words.size() < 2 || words.size() > 4) throw std::invalid_argument("usage");
    const ScratchFolder folder;
    const MotionRobot robot = motion_robot(words[1], law == "lookahead", folder);
    if (words.size() == 4 && words[2] == "--show")
      return show(random_motions(std::stoull(words[3]), robot)), 0;
    const std::uint64_t programs = words.size() > 2 ? std::stoull(words[2]) : 20;
    const std::uint64_t seed = words.size() > 3 ? std::stoull(words[3]) : 1;
    return judge_all(words[0], words[1], robot, programs, seed, law) ? 0 : 1;
  } catch (const std::invalid_argument&) {
    std::fprintf(stderr, "usage: motions_judge ROB ROBOT [N [SEED] | --show SEED] [--law LAW]\n");
    return 64;
  } catch (const std::exception& error) {
    std::fprintf(stderr, "motions_judge: %s\n", error.what());
    return 70;
  }
}
