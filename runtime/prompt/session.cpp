#include "runtime/prompt/session.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <memory>
#include <utility>

#include "lang/text/ascii.h"
#include "lang/text/codes.h"
#include "lang/text/visible.h"
#include "motion/robots/robot_file.h"
#include "runtime/prompt/commands.h"
#include "runtime/prompt/entry_lines.h"
#include "runtime/run/simulation.h"
#include "runtime/run/text_report.h"
#include "runtime/words/codes.h"
#include "runtime/words/units.h"

namespace rob::runtime {

namespace {

motion::RobotModel chosen(const SessionOptions& options) {
  motion::RobotModel robot = load_robot(options.robot.empty() ? "gantry" : options.robot);
  if (options.law) robot.law = *options.law;
  if (options.cell) change_cell(robot, *options.cell);
  return robot;
}

bool is_incomplete(const std::string& entry, const LoadedProgram& compiled) {
  if (compiled.runnable()) return false;
  if (EntryLines::brackets_open(entry)) return true;
  return std::ranges::any_of(
      compiled.compilation.diagnostics.all(), [](const lang::Diagnostic& one) {
        return one.code == lang::code::kUnclosedBlock || one.code == lang::code::kRescueMissing;
      });
}

const char* name_of(motion::MotionState state) {
  switch (state) {
    case motion::MotionState::Idle:
      return "idle";
    case motion::MotionState::Running:
      return "moving";
    case motion::MotionState::Held:
      return "held";
    case motion::MotionState::Stopping:
      return "stopping";
    case motion::MotionState::Jogging:
      return "jogging";
    case motion::MotionState::Pressing:
      return "pressing";
    default:
      return "busy";
  }
}

}  // namespace

Session::Session(SessionOptions options, Screen& screen)
    : options_(std::move(options)),
      screen_(&screen),
      workshop_(options_.archive.empty() ? Archive::default_folder() : options_.archive) {
  const motion::RobotModel robot = chosen(options_);
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
  options.points_file = options_.points_file;
  options.trace = options_.trace;
  options.backend = options_.backend;
  options.home = std::exchange(options_.home, false);
  options.requests = options_.requests;
  return std::make_unique<LiveRobot>(robot, std::move(options), listener(), this);
}

LiveReports::Listener Session::listener() {
  LiveReports::Listener listener;
  listener.print = [this](const std::string& text) { screen_->result(text + "\n"); };
  listener.tell = [this](const std::string& text) {
    screen_->message(lang::on_one_line(text) + "\n");
  };
  listener.consult = [this](const Note& note) {
    asks_ = note.kind != Note::Kind::Answer;
    if (note.kind == Note::Kind::Ask) screen_->message(note.text + "\n");
    if (note.kind == Note::Kind::Halt)
      screen_->message(
          fmt::format("HALT{}{}: Enter goes on\n", note.text.empty() ? "" : " ", note.text));
  };
  listener.fault = [this](int line, const Words& words) {
    asks_ = false;
    screen_->message(fmt::format("line {}: fault[{}]: {}\nhelp: {}\n", line, words.code,
                                 words.message, words.help));
    screen_->message("the robot has stopped; :reset takes it under control again\n");
    note(ExitCode::Fault);
  };
  return listener;
}

bool is_command(std::string_view line) {
  const std::size_t first = line.find_first_not_of(" \t\n");
  return first != std::string_view::npos && line[first] == ':';
}

Session::Taken Session::enter(const std::string& text, bool last) try {
  const std::size_t first = text.find_first_not_of(" \t\n");
  if (asks_ && !is_command(text)) {
    answer(text);
    return Taken::Done;
  }
  if (first == std::string::npos) return Taken::Done;
  if (is_command(text)) {
    carry_out_command(*this, text.substr(first + 1));
    return Taken::Done;
  }
  // END at the prompt is STOP: there is more to come.
  const std::string entry = lang::same_word(text.substr(first), "END") ? "STOP" : text;
  if (robot_->guided()) {
    fail("the drives are without force", ":guide off takes the robot under control again");
    return Taken::Done;
  }
  take_points();
  LoadedProgram compiled = text_->compile(entry);
  if (!last && is_incomplete(entry, compiled)) return Taken::Incomplete;
  if (!compiled.runnable()) compiled = text_->compile(entry, SessionText::Knowing::Everything);
  const std::uint32_t line = text_->line();
  if (submit(entry, std::move(compiled)) && workshop_.records) record(entry, line);
  return Taken::Done;
} catch (const FileError& error) {
  fail(error.what(), "", ExitCode::InputOutput);
  return Taken::Done;
} catch (const motion::RobotFileError& error) {
  fail(error.what());
  return Taken::Done;
}

/// False if it has been refused.
bool Session::submit(const std::string& entry, LoadedProgram compiled) {
  refuse_untaught(compiled);
  refuse_what_an_arm_cannot(compiled);
  if (compiled.runnable() && !compiled.compilation.chunk->tasks.empty()) {
    fail("a TASK runs beside a program, not at the prompt",
         "put it into a program; :load and :run it");
    return false;
  }
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
  robot_->submit({line, EntryTask::Statements{std::move(chunk)}});
  return true;
}

/// What is said of the entry that begins there; of those before it has been said.
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
    asks_ = false;  // whatever asked has ended
    const lang::RuntimeError& error = failure->error;
    forget(*failure);
    note(ExitCode::Fault);
    if (error.code == code::kStopped) {
      screen_->message(error.message + "; what was not done yet is dropped\n");
      continue;
    }
    const lang::Diagnostic told{lang::Severity::Error, error.code, error.place, error.message,
                                error.help};
    const auto run = runs_.find(failure->line);
    screen_->message(run == runs_.end() ? text_->rendered(told)
                                        : lang::render(told, run->second.file, run->second.source,
                                                       run->second.used));
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
  while (!robot_->over() && !robot_->held() && !asks_ && waits()) {
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

bool Session::interrupt_again() {
  if (!interrupted_ || !moves()) return false;
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
  constexpr std::array kFromTheLeast = {ExitCode::Done, ExitCode::Usage, ExitCode::ProgramError,
                                        ExitCode::InputOutput, ExitCode::Fault};
  worst_ = std::ranges::max(worst_, error, {},
                            [&](ExitCode one) { return std::ranges::find(kFromTheLeast, one); });
}

std::string Session::state_text() const {
  const auto& last = robot_->reports().last();
  const motion::RobotModel& model = robot_->robot();
  std::string text = model.name;
  if (!last) return text;
  text += fmt::format(" {} (", robot_->over() ? "fault" : name_of(last->sample.state));
  for (int i = 0; i < model.axis_count(); ++i) {
    const motion::Axis& axis = model.axes[static_cast<std::size_t>(i)];
    text += fmt::format("{}{}", i == 0 ? "" : ", ",
                        shown(last->measured[i] * shown_per_si(axis.kind), 1));
  }
  return text + ")";
}

void Session::choose_robot(const std::string& robot, std::optional<motion::Law> law) {
  if (!robot_->simulated())
    return fail("another robot or law needs another start on a machine",
                "leave with :quit, and name it: rob --robot, --law");
  SessionOptions options = options_;
  options.robot = robot;
  options.law = law;
  motion::RobotModel model = chosen(options);  // throws before anything is lost
  if (options.robot == options_.robot) model.start = robot_->channels().joints.load();
  if (!text_->names().empty()) screen_->message("what was declared at the prompt is gone\n");
  if (!options_.trace.empty())
    screen_->message(fmt::format("the trace '{}' ends here\n", lang::on_one_line(options_.trace)));
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

bool Session::moves() const {
  using motion::MotionState;
  const auto& last = robot_->reports().last();
  return last && last->sample.state != MotionState::Idle && last->sample.state != MotionState::Held;
}

double Session::time() const {
  const auto& last = robot_->reports().last();
  return last ? last->sample.reference.time : 0;
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

void Session::go_on() {
  if (asks_) answer("");
}

void Session::listen() {
  const std::lock_guard lock(mutex_);
  answers_.clear();
}

std::optional<std::string> Session::line() {
  const std::lock_guard lock(mutex_);
  if (answers_.empty()) return std::nullopt;
  std::string text = std::move(answers_.front());
  answers_.pop_front();
  return text;
}

void Session::answer(const std::string& text) {
  asks_ = false;  // the line after this one is none
  const std::lock_guard lock(mutex_);
  answers_.push_back(text);
}

}  // namespace rob::runtime
