#include "runtime/prompt/session.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <memory>
#include <utility>

#include "lang/text/ascii.h"
#include "lang/text/codes.h"
#include "lang/text/visible.h"
#include "runtime/files/text_lines.h"
#include "runtime/prompt/entry_lines.h"
#include "runtime/run/output_file.h"
#include "runtime/run/simulation.h"
#include "runtime/run/text_report.h"
#include "runtime/words/codes.h"

namespace rob::runtime {

namespace {

motion::RobotModel chosen(const SessionOptions& options) {
  motion::RobotModel robot =
      load_robot(options.robot.empty() ? "gantry" : options.robot, options.cell_file);
  if (options.law) robot.law = *options.law;
  if (options.cell) change_cell(robot, *options.cell);
  return robot;
}

bool is_incomplete(const std::string& entry, const LoadedProgram& compiled) {
  if (compiled.runnable()) return false;
  if (EntryLines::brackets_open(entry)) return true;
  return std::ranges::any_of(compiled.compilation.diagnostics.all(), may_be_mended_below);
}

}  // namespace

Session::Session(SessionOptions options, Screen& screen)
    : options_(std::move(options)),
      prompt_points_(options_.points_file),
      screen_(&screen),
      workshop_(options_.archive.empty() ? Archive::default_folder() : options_.archive) {
  const motion::RobotModel robot = chosen(options_);
  options_.points_file = points_at_prompt(prompt_points_, robot.name);
  forget_unusable_points(robot);
  begin_text(robot);
  robot_ = live(robot);
  read_points();
}

/// As if nothing had been typed yet.
void Session::begin_text(const motion::RobotModel& robot) {
  text_.emplace(robot, options_.points_file);
  runs_.clear();
  points_.clear();
}

std::unique_ptr<LiveRobot> Session::live(const motion::RobotModel& robot) {
  LiveOptions options;
  options.fast = options_.fast;
  options.override_share = options_.override_share;
  options.seed = options_.seed;
  options.date = options_.date;
  options.points_file = options_.points_file;
  options.trace = options_.trace;
  options.backend = options_.backend;
  options.home = std::exchange(options_.home, false);
  options.requests = options_.requests;
  return std::make_unique<LiveRobot>(robot, std::move(options), listener(), &answers_);
}

LiveReports::Listener Session::listener() {
  LiveReports::Listener listener;
  listener.print = [this](const std::string& text) { screen_->result(text + "\n"); };
  listener.tell = [this](const std::string& text) {
    screen_->message(lang::on_one_line(text) + "\n");
  };
  listener.consult = [this](const Note& note) {
    answers_.want(note.kind != Note::Kind::Answer);
    if (note.kind == Note::Kind::Ask) screen_->message(note.text + "\n");
    if (note.kind == Note::Kind::Halt)
      screen_->message(
          fmt::format("HALT{}{}: Enter goes on\n", note.text.empty() ? "" : " ", note.text));
  };
  listener.not_kept = [this](const std::string& why) { fail(why, "", ExitCode::InputOutput); };
  listener.fault = [this](int line, const Words& words) {
    answers_.want(false);
    screen_->message(fmt::format("line {}: fault[{}]: {}\nhelp: {}\n", line, words.code,
                                 words.message, words.help));
    screen_->message("the robot has stopped; :reset takes it under control again\n");
    note(ExitCode::Fault);
  };
  return listener;
}

Session::Taken Session::take(const std::string& text, bool last) {
  const std::string word = text.substr(text.find_first_not_of(" \t\n"));
  // END at the prompt is STOP: there is more to come.
  const std::string entry = lang::same_word(word, "END") ? "STOP" : text;
  if (robot_->guided()) {
    fail("the drives are without force", ":guide off takes the robot under control again");
    return Taken::Done;
  }
  take_points();
  auto [compiled, as] = text_->read(entry);
  if (!last && is_incomplete(entry, compiled)) return Taken::Incomplete;
  if (!compiled.runnable()) compiled = text_->compile(entry, SessionText::Knowing::Everything, as);
  const std::uint32_t line = text_->line();
  if (submit(entry, std::move(compiled)) && workshop_.records) {
    const std::string kept = as == SessionText::As::Expression
                                 ? "PRINT " + entry.substr(entry.find_first_not_of(" \t\n"))
                                 : entry;
    workshop_.record(kept, text_->named_in(entry), line);
  }
  return Taken::Done;
}

bool Session::sound_so_far(const std::string& block, std::size_t first) {
  const std::string wrong = text_->wrong_in_open(block, static_cast<std::uint32_t>(first));
  if (wrong.empty()) return true;
  screen_->message(wrong);
  note(ExitCode::ProgramError);
  return false;
}

/// False if it has been refused.
bool Session::submit(const std::string& entry, LoadedProgram compiled) {
  refuse_untaught(compiled);
  refuse_what_an_arm_cannot(compiled);
  const std::uint32_t line = text_->line();
  text_->keep(entry, compiled);
  tell(compiled, line);
  if (!compiled.runnable()) {
    note(ExitCode::ProgramError);
    return false;
  }
  if (robot_->over()) {
    fail("the robot has stopped for good", ":reset takes it up again");
    return false;
  }
  auto chunk = std::make_shared<const lang::Chunk>(std::move(*compiled.compilation.chunk));
  robot_->submit({line, EntryTask::Statements{std::move(chunk), std::move(compiled.obstacles)}});
  return true;
}

/// The message about the entry that begins there; those before have had theirs.
void Session::tell(const LoadedProgram& compiled, std::uint32_t line) {
  for (const lang::Diagnostic& finding : compiled.compilation.diagnostics.all()) {
    const bool before = finding.severity != lang::Severity::Error && finding.place.file == 0 &&
                        finding.place.line < line;
    if (before) continue;
    screen_->message(text_->rendered(finding, compiled.compilation.used));
  }
}

void Session::let_pass() {
  robot_->let_pass();
  interrupted_ = interrupted_ && !robot_->idle();
  take_failures();
  tell_held();
}

void Session::take_failures() {
  while (const auto failure = robot_->take_failure()) {
    const lang::RuntimeError& error = failure->error;
    if (failure->told) {
      screen_->message(error.message + "\n");
      continue;
    }
    if (!failure->beside) {
      answers_.want(false);  // whatever asked has ended
      forget(*failure);
    }
    if (error.code == code::kStopped) {
      screen_->message(error.message + "; what was not done yet is dropped\n");
      continue;
    }
    note(ExitCode::Fault);
    const lang::Diagnostic told{lang::Severity::Error, error.code, error.place, error.message,
                                error.help};
    screen_->message(runs_.contains(failure->line) ? runs_.rendered(told, failure->line)
                                                   : text_->rendered(told));
  }
}

/// The entry that failed, and those after it that were not carried out for that.
void Session::forget(const EntryTask::Failure& failure) {
  if (failure.dropped > 0)
    screen_->message(fmt::format("dropped, typed ahead: {} {}\n", failure.dropped,
                                 failure.dropped == 1 ? "entry" : "entries"));
  if (failure.last == 0) return;
  text_->forget(failure.first, failure.last);
  workshop_.program.take_back(failure.first, failure.last);
  points_.clear();  // some may not have been declared
}

void Session::wait_while(const std::function<bool()>& waits) {
  using namespace std::chrono_literals;
  robot_->work();
  while (!robot_->over() && !robot_->held() && !asks() && waits()) {
    let_pass();
    if (!options_.fast) std::this_thread::sleep_for(5ms);
  }
}

void Session::carry_out_entries(std::size_t most) {
  wait_while([&] { return robot_->open() > most; });
}

void Session::finish() {
  wait_while([&] { return !robot_->idle(); });
  let_pass();
}

bool Session::interrupt() {
  if (robot_->idle() || robot_->over()) return false;
  robot_->stop();
  interrupted_ = true;
  return true;
}

void Session::stop() {
  if (interrupt() && options_.waits) finish();
}

bool Session::interrupt_again() {
  if (!interrupted_ || !robot_->reports().moves()) return false;
  robot_->brake();
  screen_->message("braked as hard as the axes can; the drives are without force\n");
  return true;
}

void Session::fail(const std::string& message, const std::string& help, ExitCode code) {
  screen_->message(fmt::format("error: {}\n", lang::on_one_line(message)));
  if (!help.empty()) screen_->message(fmt::format("help: {}\n", help));
  note(code);
}

void Session::note(ExitCode error) {
  ++errors_;
  constexpr std::array kFromTheLeast = {ExitCode::Done, ExitCode::Usage, ExitCode::ProgramError,
                                        ExitCode::InputOutput, ExitCode::Fault};
  worst_ = std::ranges::max(worst_, error, {},
                            [&](ExitCode one) { return std::ranges::find(kFromTheLeast, one); });
}

void Session::choose_robot(const std::string& robot, std::optional<motion::Law> law) {
  if (!robot_->simulated())
    return fail("another robot or law needs another start on a machine",
                "leave with :quit, and name it: rob --robot, --law");
  SessionOptions options = options_;
  options.robot = robot;
  options.law = law;
  motion::RobotModel model = chosen(options);  // throws before anything is lost
  if (model.name != robot_->robot().name)
    options.points_file = points_at_prompt(prompt_points_, model.name);
  if (options.robot == options_.robot) model.start = robot_->channels().joints.load();
  if (!text_->names().empty()) screen_->message("what was declared at the prompt is gone\n");
  if (!options_.trace.empty())
    screen_->message(fmt::format("the trace '{}' ends here\n", lang::on_one_line(options_.trace)));
  workshop_.wizard.reset();  // its positions are of the robot before
  robot_.reset();
  options.trace.clear();
  options_ = options;
  forget_unusable_points(model);
  begin_text(model);
  robot_ = live(model);
  read_points();
}

void Session::jog(const lang::MoveCommand& command, const motion::Watch& held) {
  if (robot_->over()) return fail("the robot has stopped for good", ":reset takes it up again");
  if (robot_->guided()) return fail("the drives are without force", ":guide off");
  robot_->submit({text_->line(), EntryTask::Jog{command, held}});
}

/// The variables have gone with what executed them, and so have their names.
void Session::reset() {
  robot_->reset();
  begin_text(robot_->robot());
  read_points();
}

void Session::guide(bool on) {
  if (robot_->guided()) finish();  // what is taught
  robot_->guide(on);
  begin_text(robot_->robot());
  read_points();
  if (on) screen_->message("the drives are without force: hold what could sink\n");
}

void Session::home() {
  robot_->home();
  begin_text(robot_->robot());
  read_points();
}

/// An entry that moves nothing, such as a START, takes some cycles: who types a command at once
/// after it need not know that.
bool Session::stands(const char* command) {
  if (options_.waits) {
    finish();
  } else {
    int cycles = 20;  // [choice]
    wait_while([&] { return !robot_->idle() && !robot_->reports().moves() && cycles-- > 0; });
  }
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
  robot_->run(line, program);
  text_->pass_line(":run");
  runs_.keep(line, program);
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
  screen_->message(fmt::format("held where {}\n", runs_.beginning_of(place)));
}

void Session::declare(const std::string& entry) { submit(entry, text_->compile(entry)); }

void Session::carry_out_aside(LoadedProgram compiled) {
  auto chunk = std::make_shared<const lang::Chunk>(std::move(*compiled.compilation.chunk));
  robot_->submit(
      {text_->line(), EntryTask::Statements{std::move(chunk), std::move(compiled.obstacles)}});
  if (options_.waits) finish();
}

/// Those of entries before have been reported, and have their value.
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

bool Session::rename_point(const std::string& name, const std::string& new_name) {
  if (robot_->points() == nullptr || !robot_->points()->rename(name, new_name)) return false;
  take_points();
  return true;
}

void Session::propose(const std::string& line) {
  if (options_.waits) return fail("nobody can change the line here", line + " …", ExitCode::Usage);
  proposed_ = line;
}

bool Session::traces_to(const std::string& file) const {
  return !options_.trace.empty() && same_file(options_.trace, file);
}

/// While statements are under way the file may not be what they leave.
void Session::take_points() {
  if (robot_->idle()) read_points();
}

/// After begin_text() nothing is under way, though the robot may have to come under control first.
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
