#include "runtime/run/load.h"

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <utility>

#include <fmt/format.h>

#include "lang/machine/move_pose.h"
#include "lang/syntax/robot_name.h"
#include "lang/text/ascii.h"
#include "motion/plan/capability.h"
#include "motion/plan/feasibility.h"
#include "motion/plan/reach.h"
#include "motion/robots/robot_file.h"
#include "motion/robots/robot_library.h"
#include "runtime/command/axis_targets.h"
#include "runtime/command/gripper_elements.h"
#include "runtime/files/files.h"
#include "runtime/files/folder_sources.h"
#include "runtime/files/points_file.h"
#include "runtime/files/text_lines.h"
#include "runtime/run/mesh_functions.h"
#include "runtime/run/program_obstacles.h"
#include "runtime/words/codes.h"
#include "runtime/words/feature_words.h"
#include "runtime/words/messages.h"
#include "runtime/words/signature.h"

namespace rob::runtime {

namespace {

constexpr std::size_t kMostSource = std::size_t{64} << 20U;  // bytes, the language's own limit
constexpr std::size_t kMostScript = std::size_t{1} << 20U;   // bytes [choice] for 1000 lines

/// [choice] A shorter text takes less than a tenth of the memory of a run.
constexpr std::size_t kLongSource = std::size_t{1} << 20U;

/// The FNV-1a hash of the lines before, and of a further one.
constexpr std::uint64_t kNoText = 14695981039346656037U;
std::uint64_t print_with(std::uint64_t before, std::string_view line) {
  constexpr std::uint64_t kPrime = 1099511628211U;
  for (const char c : line) before = (before ^ static_cast<unsigned char>(c)) * kPrime;
  return (before ^ static_cast<unsigned char>('\n')) * kPrime;
}

std::uint64_t print_of(std::string_view text) {
  std::uint64_t print = kNoText;
  while (!text.empty()) print = print_with(print, take_line(text));
  return print;
}

constexpr const char* kDefaultRobot = "gantry";

using Coordinates = std::vector<lang::RobotSignature::Coordinate>;

bool is_known_robot(const std::string& name) {
  const auto names = motion::robot_names();
  return std::ranges::find(names, name) != names.end();
}

std::optional<Words> words_against_axes(const lang::MoveCommand& command,
                                        const motion::RobotModel& robot) {
  const auto refusal = motion::check_target(robot, command.given, command.target);
  return refusal ? std::optional(words_for(*refusal, robot)) : std::nullopt;
}

/// A pose that is wholly known.
std::optional<Words> words_against_pose(lang::MoveCommand command, const motion::RobotModel& robot,
                                        const Coordinates& coordinates) {
  const motion::JointVector middle = motion::middle(robot);
  // The part that its targets leave open is the same everywhere.
  const lang::PoseValue pose =
      lang::target_pose(command, tool_at(robot, middle, {}), {}, coordinates);
  const auto free = free_turn_of(command, {});
  if (auto words = settle_on_axes(robot, pose, middle, command, {}, free)) return words;
  return words_against_axes(command, robot);
}

/// Why a target that is known beforehand is out of reach.
std::optional<lang::Refusal> refusal_of(const lang::MoveCommand& command,
                                        const motion::RobotModel& robot,
                                        const lang::RobotSignature& signature) {
  using Target = lang::MoveCommand::Target;
  const bool of_tool = command.means == Target::Coordinates && robot.tool_coordinates;
  const GripperElements hand(command, signature);
  auto words = of_tool && hand.any() ? words_against_axes(hand.command(), robot) : std::nullopt;
  const std::uint8_t all = lang::given_all(static_cast<int>(signature.coordinates.size()));
  // A coordinate that it leaves out is as the motion before leaves it.
  const bool known = !of_tool || (command.given & all) == all;
  if (!words && known)
    words = of_tool || command.means == Target::Pose
                ? words_against_pose(command, robot, signature.coordinates)
                : words_against_axes(command, robot);
  if (!words) return std::nullopt;
  return lang::Refusal{words->code, words->message, words->help};
}

/// For this robot, whose signature this is; both must outlive it.
lang::TargetJudge judge_of(const motion::RobotModel& robot, const lang::RobotSignature& signature) {
  return [&](const lang::MoveCommand& command) { return refusal_of(command, robot, signature); };
}

lang::PointTable points_in(const std::string& file, const motion::RobotModel& robot) {
  return file.empty() ? lang::PointTable{} : load_points(file, robot).table();
}

void refuse_what_the_robot_cannot(lang::Compilation& compilation, const motion::RobotModel& robot) {
  for (const lang::FeatureUse& use : compilation.features) {
    const auto words = words_against(use.feature, robot);
    if (!words) continue;
    compilation.diagnostics.error(words->code, use.place, words->message, words->help);
    compilation.chunk.reset();
  }
}

/// The program's obstacles stand around its robot.
void stand_obstacles(LoadedProgram& program) {
  std::vector<motion::Obstacle>& all = program.robot.collision.obstacles;
  std::erase_if(all, [](const motion::Obstacle& one) { return one.of_program; });
  program.obstacles =
      obstacles_of(program.compilation, std::filesystem::path(program.file).parent_path().string());
  all.insert(all.end(), program.obstacles.begin(), program.obstacles.end());
}

/// Obstacles that nothing can hit are not what was meant.
void warn_of_missing_shapes(LoadedProgram& program) {
  const auto& chunk = program.compilation.chunk;
  if (!chunk || chunk->obstacles.empty()) return;
  if (chunk->shaped || !program.robot.collision.bodies.empty()) return;
  program.compilation.diagnostics.warning(
      code::kNothingToHit, chunk->obstacles.front().place,
      fmt::format("nothing is checked against {}: {} has no shapes",
                  lang::shortened(chunk->obstacles.front().name), program.robot.name),
      "TOOL … SHAPE CAPSULE(…) gives the tool one, [[axis.shape]] in the robot's file an arm");
}

void refuse(lang::Compilation& compilation, const Words& words) {
  const lang::Place place = compilation.law ? compilation.law->place : lang::Place{};
  compilation.diagnostics.error(words.code, place, words.message, words.help);
  compilation.chunk.reset();
}

void settle_law(LoadedProgram& program, std::optional<motion::Law> asked) {
  using motion::Law;
  motion::RobotModel& robot = program.robot;
  if (const auto& written = program.compilation.law; written && !asked)
    asked = written->law == lang::TransitionLaw::Paul ? Law::Paul : Law::LookAhead;
  const Law law = asked.value_or(robot.law);
  if (!motion::can(robot, law)) return refuse(program.compilation, words_against_paul(robot));
  robot.law = law;
}

}  // namespace

void put_source_away(LoadedProgram& program) {
  if (program.source.size() < kLongSource || program.file == kStandardInput) return;
  program.put_away = print_of(program.source);
  program.source.clear();
  program.source.shrink_to_fit();
}

std::string source_lines(const LoadedProgram& program, const std::set<std::uint32_t>& shown) {
  if (!program.put_away) return program.source;
  std::error_code none;
  if (!std::filesystem::is_regular_file(program.file, none)) return "";
  std::ifstream file(program.file, std::ios::binary);
  std::uint64_t print = kNoText;
  std::string text;
  std::string line;
  for (std::uint32_t number = 1; std::getline(file, line); ++number) {
    print = print_with(print, line);
    text += shown.contains(number) ? line + "\n" : "\n";
  }
  return print == *program.put_away ? text : "";
}

std::vector<std::string> used_names(const LoadedProgram& program) {
  std::vector<std::string> names;
  for (const lang::SourceFile& file : program.compilation.used) names.push_back(file.name);
  return names;
}

void place_in(const LoadedProgram& program, Problem& problem) {
  problem.used = used_names(program);
  const std::uint32_t file = problem.place.file;
  problem.file = file == 0 ? program.file : problem.used.at(file - 1);
}

motion::RobotModel load_robot(const std::string& name_or_file, const std::string& cell) {
  try {
    motion::RobotModel robot = motion::load_robot(name_or_file);
    if (!cell.empty()) motion::load_cell(cell, robot);
    if (!robot.collision.meshes.empty()) mesh_functions().read(robot.collision);
    return robot;
  } catch (const motion::RobotFileUnreadable& error) {
    throw FileError(error.what());
  }
}

LoadedProgram load_program(const std::string& file, const std::string& asked,
                           std::optional<motion::Law> law, const std::string& cell) {
  std::string source =
      file == kStandardInput ? read_input(kMostSource) : read_file(file, kMostSource);
  return compile_program(file, std::move(source), asked, points_file_of(file), law, cell);
}

LoadedProgram compile_program(std::string file, std::string source, const std::string& asked,
                              const std::string& points_file, std::optional<motion::Law> law,
                              const std::string& cell) {
  const auto declared = lang::declared_robot(source);
  if (!declared) {
    return compile_program(std::move(file), std::move(source),
                           load_robot(asked.empty() ? kDefaultRobot : asked, cell), points_file,
                           law);
  }
  if (asked.empty() && !is_known_robot(declared->name)) {
    LoadedProgram program{std::move(file), std::move(source), load_robot(kDefaultRobot), {}};
    const Words words = words_for_unknown_robot(declared->name);
    program.compilation.diagnostics.error(words.code, declared->place, words.message, words.help);
    return program;
  }
  LoadedProgram program =
      compile_program(std::move(file), std::move(source),
                      load_robot(asked.empty() ? declared->name : asked, cell), points_file, law);
  if (program.robot.name != declared->name) {
    const Words words = words_for_other_robot(declared->name, program.robot.name);
    program.compilation.diagnostics.error(words.code, declared->place, words.message, words.help);
    program.compilation.chunk.reset();
  }
  return program;
}

SignalScript load_signal_script(const std::string& file, const LoadedProgram& program) {
  if (file.empty()) return {};
  std::string text = read_file(file, kMostScript);
  if (!program.runnable()) return {};  // its SIGNALs are not known
  return parse_signal_script(file, std::move(text), program.robot,
                             program.compilation.chunk->named_signals,
                             program.compilation.chunk->devices);
}

LoadedProgram compile_program(std::string file, std::string source, const motion::RobotModel& robot,
                              const std::string& points_file, std::optional<motion::Law> law,
                              std::uint32_t from) {
  LoadedProgram program{std::move(file), std::move(source), robot, {}};
  const FolderSources sources(program.file);
  const lang::RobotSignature signature = signature_of(robot);
  program.compilation = lang::compile(program.source, signature, points_in(points_file, robot),
                                      judge_of(robot, signature), &sources, from);
  stand_obstacles(program);
  warn_of_missing_shapes(program);
  settle_law(program, law);
  if (!robot.tool_coordinates) refuse_what_the_robot_cannot(program.compilation, program.robot);
  return program;
}

LoadedProgram compile_entry(const lang::Entries& entries, std::string entry,
                            const motion::RobotModel& robot, const lang::RobotSignature& signature,
                            const std::string& points_file, const lang::Sources& sources,
                            lang::Entries::Knowing knowing, lang::Entries::As as) {
  LoadedProgram program{sources.program().name, std::move(entry), robot, {}};
  program.compilation = entries.compile(program.source, signature, points_in(points_file, robot),
                                        judge_of(robot, signature), &sources, knowing, as);
  stand_obstacles(program);
  settle_law(program, robot.law);
  if (!robot.tool_coordinates) refuse_what_the_robot_cannot(program.compilation, program.robot);
  return program;
}

void refuse_missing_points(LoadedProgram& program) {
  lang::Compilation& compilation = program.compilation;
  for (const lang::MissingPoint& point : compilation.missing_points) {
    compilation.diagnostics.error(
        code::kPointMissing, point.place,
        fmt::format("{} has no value: '{}' does not have it", lang::shortened(point.name),
                    points_file_of(program.file)),
        fmt::format("TEACH {0} before its first use, or give it a value: POINT {0} = POSE(…)",
                    lang::shortened(point.name)));
    compilation.chunk.reset();
  }
}

void refuse_what_an_arm_cannot(LoadedProgram& program) {
  if (program.robot.tool_coordinates)
    refuse_what_the_robot_cannot(program.compilation, program.robot);
}

}  // namespace rob::runtime
