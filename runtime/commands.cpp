#include "runtime/commands.h"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "drivers/serial/port_list.h"
#include "lang/code/disassembler.h"
#include "motion/plan/capability.h"
#include "motion/robots/robot_library.h"
#include "runtime/control/units.h"
#include "runtime/explain.h"
#include "runtime/format_files.h"
#include "runtime/program/atomic_file.h"
#include "runtime/program/console.h"
#include "runtime/program/files.h"
#include "runtime/program/foretell.h"
#include "runtime/program/interruption.h"
#include "runtime/program/json_report.h"
#include "runtime/program/load.h"
#include "runtime/program/machine.h"
#include "runtime/program/output_file.h"
#include "runtime/program/path_file.h"
#include "runtime/program/points_file.h"
#include "runtime/program/progress.h"
#include "runtime/program/run.h"
#include "runtime/program/run_mark.h"
#include "runtime/program/simulation.h"
#include "runtime/program/terminal.h"
#include "runtime/program/text_report.h"
#include "runtime/prompt/prompt.h"
#include "runtime/test_files.h"

namespace rob::runtime {

namespace {

/// The graver of two: the first that is not Done.
ExitCode worse(ExitCode a, ExitCode b) { return a == ExitCode::Done ? b : a; }

/// Writes what comes in small pieces in larger ones.
class Pieces {
 public:
  Pieces() = default;
  ~Pieces() { put_result(text_); }
  Pieces(const Pieces&) = delete;
  Pieces& operator=(const Pieces&) = delete;

  Put put() {
    return [this](std::string_view piece) {
      constexpr std::size_t kMost = 65536;  // bytes [choice]
      text_ += piece;
      if (text_.size() < kMost) return;
      put_result(text_);
      text_.clear();
    };
  }

 private:
  std::string text_;
};

using PutJson = void (*)(const RunResult& result, std::size_t indent, const Put& put);

/// One document, or a list where several programs were named, however many of them ran.
void print_json(const Options& options, const std::vector<RunResult>& results, PutJson document) {
  Pieces pieces;
  const Put put = pieces.put();
  if (options.files.size() == 1) {
    document(results.front(), 0, put);
    return put("\n");
  }
  const char* comma = "[";
  for (const RunResult& result : results) {
    put(std::string(comma) + "\n  ");
    document(result, 2, put);
    comma = ",";
  }
  put(results.empty() ? "[]\n" : "\n]\n");
}

RunListener listener_of(const Options& options, Progress& progress) {
  RunListener listener;
  listener.warn = [&](const std::string& message) {
    progress.clear();
    put_error(message);
  };
  listener.consult = [&](const Note& note, int line) { progress.consult(note, line); };
  listener.abandoned = reader_has_gone;
  if (options.json) return listener;
  listener.print = [&](const std::string& text) {
    progress.clear();
    put_result(text + "\n");
  };
  listener.progress = [&](const Position& position) { progress.show(position); };
  return listener;
}

/// Motion in real time leaves a mark as long as it lasts.
void mark(std::optional<RunMark>& running, const LoadedProgram& program,
          const RunListener& listener) {
  try {
    running.emplace(program.file, program.robot.name);
  } catch (const FileError& error) {
    listener.warn(error.what());
  }
}

void tell_unclean_ends() {
  for (const std::string& end : unclean_ends()) put_message(end);
}

/// TEACH keeps points beside the program; where that is not possible nothing moves. Throws
/// FileError.
void find_out_whether_points_can_be_kept(const LoadedProgram& program) {
  const auto& teach = program.compilation.chunk->first_teach;
  if (!teach) return;
  try {
    try_saving(points_file_of(program.file));
  } catch (const FileError& error) {
    const std::string file = teach->file == 0 ? program.file : used_names(program)[teach->file - 1];
    throw FileError(
        fmt::format("{}; TEACH in {}:{} keeps points there", error.what(), file, teach->line));
  }
}

/// The program's machine, open, and the program as it fits to it.
OpenMachine machine_for(LoadedProgram& program, const Options& options) {
  OpenMachine machine =
      open_machine(*backend_of(options.backend), program, options.law, options.home);
  for (const std::string& note : machine.notes) put_error(note);
  return machine;
}

RunResult run_one(LoadedProgram& program, const Options& options, const SignalScript& script) {
  const bool starts = program.runnable() && !script.diagnostics.has_errors();
  OpenMachine machine = starts ? machine_for(program, options) : OpenMachine{};
  const motion::RobotModel& robot = program.robot;
  if (!program.runnable()) return refused(program, robot);
  if (script.diagnostics.has_errors()) return refused(script, robot);
  find_out_whether_points_can_be_kept(program);
  put_source_away(program);
  std::optional<Foretold> foretold;
  if (isatty(STDERR_FILENO) != 0 || robot.law == motion::Law::LookAhead)
    foretold =
        foretold_by(foretell(program, robot, {options.seed, &script, options.override_share}));
  Progress progress(foretold ? foretold->planned : 0, options.override_share, used_names(program));
  Terminal terminal(options.fast);
  const RunOptions run_options{
      options.fast, options.override_share,         options.trace, options.seed, &script,
      &terminal,    foretold ? &*foretold : nullptr};
  const RunListener listener = listener_of(options, progress);
  StopRequests before_motion;
  const Interruption interruption(before_motion);  // from here on the mark must be taken back
  std::optional<RunMark> running;
  if (!options.fast) mark(running, program, listener);
  RunResult result = run(program, std::move(machine), run_options, listener);
  progress.clear();
  return result;
}

/// All of them, before the first one starts: a file that cannot be read leaves nothing half done.
std::vector<LoadedProgram> load_programs(const Options& options) {
  std::vector<LoadedProgram> programs;
  for (const std::string& file : options.files)
    programs.push_back(load_program(file, options.robot, options.law));
  for (LoadedProgram& program : programs)
    if (options.cell) change_cell(program.robot, *options.cell);
  return programs;
}

/// The signal script for each of them, which may use their names.
std::vector<SignalScript> load_scripts(const Options& options,
                                       const std::vector<LoadedProgram>& programs) {
  std::vector<SignalScript> scripts;
  for (const LoadedProgram& program : programs) {
    scripts.push_back(load_signal_script(options.signals, program));
  }
  return scripts;
}

/// Everything that the command reads, and what the programs may keep.
void refuse_overwriting_inputs(std::string_view option, const std::string& output,
                               const Options& options, const std::vector<LoadedProgram>& programs) {
  if (output.empty()) return;
  std::vector<InputFile> inputs;
  for (const LoadedProgram& program : programs)
    std::ranges::copy(inputs_of(program), std::back_inserter(inputs));
  if (!options.signals.empty()) inputs.push_back({options.signals, "the signal script"});
  if (options.robot.ends_with(".toml")) inputs.push_back({options.robot, "the robot file"});
  refuse_overwriting(option, output, inputs);
}

/// What is wrong with the program or with its script, for people.
std::string problems_text(const RunResult& result, const LoadedProgram& program,
                          const SignalScript& script) {
  const bool in_script = program.runnable() && script.diagnostics.has_errors();
  if (in_script) return problems_text(result, script.source);
  std::set<std::uint32_t> lines;
  for (const lang::Diagnostic& finding : result.findings) lines.insert(finding.place.line);
  if (result.error) lines.insert(result.error->place.line);
  return problems_text(result, lines.empty() ? "" : source_lines(program, lines),
                       program.compilation.used);
}

ExitCode run_files(const Options& options) {
  ExitCode worst = ExitCode::Done;
  std::vector<RunResult> results;
  if (!options.fast) tell_unclean_ends();
  std::vector<LoadedProgram> programs = load_programs(options);
  for (LoadedProgram& program : programs) {
    refuse_missing_points(program);
    refuse_what_an_arm_cannot(program);
  }
  const std::vector<SignalScript> scripts = load_scripts(options, programs);
  refuse_overwriting_inputs("--trace", options.trace, options, programs);
  for (std::size_t i = 0; i < programs.size(); ++i) {
    LoadedProgram& program = programs[i];
    RunResult result = run_one(program, options, scripts[i]);
    const ExitCode exit_code = result.exit_code;
    const bool starts = program.runnable() && !scripts[i].diagnostics.has_errors();
    put_message(problems_text(result, program, scripts[i]));
    if (options.json) {
      results.push_back(std::move(result));
    } else if (starts) {
      put_run_table(result, Pieces().put());
    }
    worst = worse(worst, exit_code);
    // Where the robot stands now is not where the next program was written to begin.
    if (starts && exit_code != ExitCode::Done) break;
  }
  if (options.json) print_json(options, results, put_run_json);
  return worst;
}

/// What has errors is told of those first.
bool plans_a_path(const LoadedProgram& program) {
  return !program.runnable() || program.robot.law == motion::Law::LookAhead;
}

/// The file for the path; none asked for, or nothing to be foretold.
std::optional<PathFile> open_path(const Options& options, const LoadedProgram& program) {
  if (options.path.empty() || !program.runnable()) return std::nullopt;
  return std::optional<PathFile>(std::in_place, options.path, program.robot);
}

RunResult check_one(LoadedProgram& program, const Options& options, const SignalScript& script) {
  if (!script.diagnostics.has_errors()) machine_for(program, options);  // its limits count
  const motion::RobotModel& robot = program.robot;
  if (!program.runnable()) return refused(program, robot);
  if (script.diagnostics.has_errors()) return refused(script, robot);
  put_source_away(program);
  std::optional<PathFile> path = open_path(options, program);
  ForetellOptions how{options.seed, &script, 1, path ? &*path : nullptr, options.longest};
  Progress progress(options.longest);
  how.progress = [&](double time) { progress.show(time); };
  RunResult result = foretell(program, robot, how);
  progress.clear();
  if (path) path->save();
  return result;
}

ExitCode check_files(const Options& options) {
  ExitCode worst = ExitCode::Done;
  std::vector<RunResult> results;
  std::vector<LoadedProgram> programs = load_programs(options);
  for (LoadedProgram& program : programs) refuse_what_an_arm_cannot(program);
  const std::vector<SignalScript> scripts = load_scripts(options, programs);
  refuse_overwriting_inputs("--path", options.path, options, programs);
  if (!options.path.empty() && !plans_a_path(programs.front())) {
    put_error("--path: under Paul's law no path is planned ahead; use --law lookahead");
    return ExitCode::Usage;
  }
  for (std::size_t i = 0; i < programs.size(); ++i) {
    RunResult result = check_one(programs[i], options, scripts[i]);
    if (result.exit_code != ExitCode::Done) result.exit_code = ExitCode::ProgramError;
    put_message(problems_text(result, programs[i], scripts[i]));
    worst = worse(worst, result.exit_code);
    if (options.json) {
      results.push_back(std::move(result));
    } else if (programs[i].runnable() && !scripts[i].diagnostics.has_errors()) {
      put_check_table(result, Pieces().put());
    }
  }
  if (options.json) print_json(options, results, put_check_json);
  return worst;
}

ExitCode compile_files(const Options& options) {
  ExitCode worst = ExitCode::Done;
  for (const LoadedProgram& program : load_programs(options)) {
    for (const lang::Diagnostic& found : program.compilation.diagnostics.all()) {
      put_message(lang::render(found, program.file, program.source, program.compilation.used));
    }
    if (!program.runnable()) {
      worst = ExitCode::ProgramError;
    } else if (options.listing) {
      put_result(lang::disassemble(*program.compilation.chunk));
    }
  }
  return worst;
}

std::string describe(const motion::RobotModel& robot) {
  std::string text = fmt::format("{}: {}\n", robot.name, robot.description);
  for (const motion::Axis& axis : robot.axes) {
    text += fmt::format("    {:<8} {} … {}, {}/s\n", axis.name, shown(axis.min, axis.kind),
                        shown(axis.max, axis.kind), shown(axis.v_max, axis.kind));
  }
  std::string signals;
  for (const motion::RobotSignal& signal : robot.signals) {
    signals += fmt::format(" {} ({})", signal.name, signal.output ? "output" : "input");
  }
  text += signals.empty() ? "" : "    signals:" + signals + "\n";
  if (robot.force_sensor) text += "    measures forces and torques on its tool\n";
  const char* const laws = motion::can(robot, motion::Law::Paul)
                               ? "Paul's law and the look-ahead law"
                               : "the look-ahead law";
  const char* const motions =
      robot.kinematics->inverts() ? "MOVE, MOVEL, MOVEC, MOVES, SPIRAL, JOG" : "MOVE, JOG JOINT";
  return text + fmt::format("    {} under {}; simulated\n", motions, laws);
}

ExitCode list_ports() {
  const std::vector<drivers::PortEntry> ports = drivers::list_ports();
  for (const drivers::PortEntry& port : ports) {
    put_result(fmt::format("{}: {}\n", port.path, port.state));
    if (!port.by_id.empty()) put_result(fmt::format("    {}\n", port.by_id));
  }
  if (ports.empty())
    put_error("no serial port is there: is the machine plugged in and switched on?");
  return ExitCode::Done;
}

ExitCode list_robots() {
  for (const motion::EmbeddedRobot& robot : motion::embedded_robots()) {
    put_result(describe(load_robot(std::string(robot.name))));
  }
  return ExitCode::Done;
}

}  // namespace

ExitCode carry_out(const Options& options) {
  switch (options.command) {
    case Options::Command::Prompt:
      return run_prompt(options);
    case Options::Command::Run:
      return run_files(options);
    case Options::Command::Check:
      return check_files(options);
    case Options::Command::Test:
      return test_files(options);
    case Options::Command::Compile:
      return compile_files(options);
    case Options::Command::Format:
      return format_files(options);
    case Options::Command::Explain:
      return explain(options.word);
    case Options::Command::Robots:
      return list_robots();
    case Options::Command::Ports:
      return list_ports();
    case Options::Command::Help:
      put_result(options.help_text);
      return ExitCode::Done;
  }
  return ExitCode::Usage;
}

}  // namespace rob::runtime
