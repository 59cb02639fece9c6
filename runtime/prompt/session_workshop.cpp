#include <fmt/format.h>

#include <algorithm>
#include <memory>
#include <utility>

#include "lang/text/ascii.h"
#include "lang/text/visible.h"
#include "runtime/prompt/session.h"
#include "runtime/run/output_file.h"

/// Member functions of Session for the commands that build programs and points.
namespace rob::runtime {

bool Session::stands(const char* command) {
  if (options_.waits) finish();
  if (robot_->over()) {
    fail("the robot has stopped for good", ":reset takes it up again");
  } else if (robot_->guided()) {
    fail(fmt::format("{} needs a robot under control", command), ":guide off before");
  } else if (robot_->held()) {
    fail(fmt::format("{} needs a robot at rest; it is held", command), ":resume or :stop before");
  } else if (!robot_->idle()) {
    fail(fmt::format("{} needs a robot at rest; it is busy", command), "wait for it, or :stop it");
  } else {
    return true;
  }
  return false;
}

void Session::run(LoadedProgram program) {
  const std::uint32_t line = text_->line();
  text_->pass_line(":run");
  auto chunk = std::make_shared<const lang::Chunk>(std::move(*program.compilation.chunk));
  runs_[line] = {program.file, program.source, program.compilation.used};
  robot_->submit({line, EntryTask::Program{std::move(chunk), options_.seed}});
  leave_hold();
}

void Session::leave_hold() {
  robot_->pause(false);
  if (options_.waits) finish();
}

void Session::go_back() {
  if (options_.waits) finish();
  if (!robot_->held() && !stands(":back")) return;
  robot_->go_back();
  while (options_.waits && robot_->going_back() && !robot_->over()) let_pass();
}

/// The tick has asked for the hold; what is said of it is of the program run last.
void Session::tell_held() {
  const lang::Place place =
      lang::tagged_place(static_cast<int>(robot_->channels().hold_points.take_held()));
  if (place.line == 0 || runs_.empty()) return;
  const Run& run = runs_.rbegin()->second;
  const bool main = place.file == 0;
  const auto lines = split_lines(main ? run.source : run.used.at(place.file - 1).text);
  const std::string text = place.line <= lines.size() ? lines[place.line - 1] : "";
  screen_->message(
      fmt::format("held where {}line {} begins: {}\n",
                  main ? "" : lang::on_one_line(run.used.at(place.file - 1).name) + " ", place.line,
                  text.substr(std::min(text.find_first_not_of(" \t"), text.size()))));
}

void Session::declare(const std::string& entry) { submit(entry, text_->compile(entry)); }

void Session::carry_out_aside(LoadedProgram compiled) {
  auto chunk = std::make_shared<const lang::Chunk>(std::move(*compiled.compilation.chunk));
  robot_->submit({text_->line(), EntryTask::Statements{std::move(chunk)}});
  if (options_.waits) finish();
}

/// Points that it uses are declared in the program where they are used first.
void Session::record(const std::string& entry, std::uint32_t line) {
  ProgramText& program = workshop_.program;
  std::string points;
  for (const lang::DeclaredName& name : text_->named_in(entry)) {
    if (name.kind != lang::DeclaredName::Kind::Point) continue;
    const auto declares = [&](const std::string& text) {
      return find_word(text, "POINT") == text.find_first_not_of(" \t") && has_word(text, name.name);
    };
    const auto known = split_lines(program.text() + entry);
    if (std::ranges::any_of(known, declares)) continue;
    points += "POINT " + name.name + "\n";
  }
  program.record(points + entry, line);
}

/// Those of entries before have been told, and have their value.
void Session::refuse_untaught(LoadedProgram& compiled) const {
  std::erase_if(compiled.compilation.missing_points,
                [&](const lang::MissingPoint& one) { return one.place.line < text_->line(); });
  refuse_missing_points(compiled);
}

/// Points of another robot, or a file with errors: the prompt works without them.
void Session::forget_unusable_points(const motion::RobotModel& robot) {
  if (options_.points_file.empty()) return;
  try {
    load_points(options_.points_file, robot);
  } catch (const FileError& error) {
    fail(error.what(), "points are not kept at this prompt", ExitCode::InputOutput);
    options_.points_file.clear();
  }
}

void Session::follow_points(const std::string& file) {
  if (options_.points_file.empty() || robot_->points() == nullptr) return;
  load_points(file, robot_->robot());
  options_.points_file = file;
  text_->use_points(file);
  robot_->points()->move_to(file);
  take_points();
}

bool Session::traces_to(const std::string& file) const {
  return !options_.trace.empty() && same_file(options_.trace, file);
}

/// While statements are under way the file may not be what they leave.
void Session::take_points() {
  if (robot_->idle()) read_points();
}

/// Behind begin_text() nothing is under way, though the robot may have to come under control first.
void Session::read_points() {
  if (options_.points_file.empty() || robot_->over()) return;
  const motion::RobotModel& robot = robot_->robot();
  const SessionPoints::Change change =
      points_.take_change(load_points(options_.points_file, robot), robot);
  for (const std::string& name : change.gone) {
    if (!text_->forget_name(name))
      screen_->message(fmt::format("{} stays as it was at this prompt: it is used there\n", name));
  }
  if (!change.declares.empty()) declare(change.declares);
}

/// TEACH must stand beside the POINT that it gives its first value.
void Session::teach(const std::string& point) {
  if (robot_->guided()) {  // where a hand has brought the axes is where the robot stands now
    robot_->reset();
    begin_text(robot_->robot());
  }
  const auto declared = text_->find(point);
  const bool known = declared && declared->kind == lang::DeclaredName::Kind::Point;
  declare(known ? "TEACH " + point : fmt::format("POINT {0}\nTEACH {0}", point));
}

}  // namespace rob::runtime
