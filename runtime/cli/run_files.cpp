#include "runtime/cli/run_files.h"

#include <fmt/format.h>
#include <unistd.h>

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "runtime/cli/pictures.h"
#include "runtime/cli/program_files.h"
#include "runtime/cli/records.h"
#include "runtime/files/atomic_file.h"
#include "runtime/files/files.h"
#include "runtime/files/points_file.h"
#include "runtime/files/run_mark.h"
#include "runtime/run/console.h"
#include "runtime/run/foretell.h"
#include "runtime/run/interruption.h"
#include "runtime/run/progress.h"
#include "runtime/run/run.h"
#include "runtime/run/terminal.h"
#include "runtime/run/text_report.h"

namespace rob::runtime {

namespace {

RunListener listener_of(const Options& options, Progress& progress) {
  RunListener listener;
  listener.warn = [&](const std::string& message) {
    progress.clear();
    put_note(message);
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

/// Pictures and record (null: none) see the run as it goes on.
void show_to(Pictures& pictures, const motion::RobotModel& robot, RunRecord* record,
             RunListener& listener) {
  listener.row = pictures.listener(robot);
  if (record == nullptr) return;
  listener.row = [record, draw = std::move(listener.row)](const Snapshot& snapshot) {
    if (draw) draw(snapshot);
    record->row(snapshot);
  };
  listener.signal = [record](const SignalChange& change) { record->signal(change); };
  listener.said = [record](const std::string& text, double time, int line) {
    record->print(time, line, text);
  };
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

ForetellOptions foretell_options(const Options& options, const SignalScript& script) {
  ForetellOptions how{options.seed, &script, options.override_share, options.data};
  how.ends_known = backend_of(options.backend)->simulated();
  how.date = options.date.value_or(options.fast ? WallTime{} : wall_time_now());
  return how;
}

void close_record(RunRecord& record, const Options& options, RunResult& result) {
  const bool whole = record.finish(result);
  if (whole && result.lost_rows == 0) return;
  if (result.exit_code == ExitCode::Done) result.exit_code = ExitCode::InputOutput;
  put_error(fmt::format("the record '{}' is incomplete; {}", options.mcap,
                        whole ? "the computer was too busy to write it" : "is the disk full?"));
}

RunResult run_one(LoadedProgram& program, const Options& options, const SignalScript& script,
                  Pictures& pictures) {
  const motion::RobotModel& robot = program.robot;
  if (!program.runnable()) return refused(program, robot);
  if (script.diagnostics.has_errors()) return refused(script, robot);
  find_out_whether_points_can_be_kept(program);
  ProgramStores stores(program, options.data, !options.fast);
  std::optional<RunRecord> record = open_record(options, program);
  OpenMachine machine = machine_for(program, options);
  if (!program.runnable()) return refused(program, robot);
  put_source_away(program);
  std::optional<Foretold> foretold;
  if (isatty(STDERR_FILENO) != 0 || robot.law == motion::Law::LookAhead ||
      !robot.collision.bodies.empty() || program.compilation.chunk->shaped) {
    RunResult ahead = foretell(program, robot, foretell_options(options, script));
    if (ahead.contact) return refused_for_contact(program, ahead);
    foretold = foretold_by(std::move(ahead));
  }
  Progress progress(foretold ? foretold->planned : 0, options.override_share, used_names(program));
  Terminal terminal(options.fast);
  const RunOptions run_options{
      options.fast, options.override_share, options.trace, options.seed,
      &script,      options.data,           &terminal,     foretold ? &*foretold : nullptr,
      options.date};
  RunListener listener = listener_of(options, progress);
  show_to(pictures, robot, record ? &*record : nullptr, listener);
  StopRequests before_motion;
  const Interruption interruption(before_motion);  // from here on the mark must be taken back
  std::optional<RunMark> running;
  if (!options.fast) mark(running, program, listener);
  RunResult result = run(program, std::move(machine), stores, run_options, listener);
  progress.clear();
  if (record) close_record(*record, options, result);
  return result;
}

/// The programs of a command line, checked as far as that goes before anything moves.
std::vector<LoadedProgram> runnable_programs(const Options& options) {
  std::vector<LoadedProgram> programs = load_programs(options);
  for (LoadedProgram& program : programs) {
    refuse_missing_points(program);
    refuse_what_an_arm_cannot(program);
  }
  refuse_overwriting_inputs("--trace", options.trace, options, programs);
  refuse_overwriting_inputs("--mcap", options.mcap, options, programs);
  return programs;
}

}  // namespace

ExitCode run_silently(const Options& options) {
  std::vector<LoadedProgram> programs = runnable_programs(options);
  const std::vector<SignalScript> scripts = load_scripts(options, programs);
  Pictures pictures(options, programs);
  const RunResult result = run_one(programs.front(), options, scripts.front(), pictures);
  put_message(problems_text(result, programs.front(), scripts.front()));
  return result.exit_code;
}

ExitCode run_files(const Options& asked) {
  Options options = asked;
  // A record has to say when NOW() began.
  if (!options.mcap.empty() && !options.fast && !options.date) options.date = wall_time_now();
  ExitCode worst = ExitCode::Done;
  std::vector<RunResult> results;
  if (!options.fast) tell_unclean_ends();
  std::vector<LoadedProgram> programs = runnable_programs(options);
  const std::vector<SignalScript> scripts = load_scripts(options, programs);
  Pictures pictures(options, programs);
  for (std::size_t i = 0; i < programs.size(); ++i) {
    LoadedProgram& program = programs[i];
    RunResult result = run_one(program, options, scripts[i], pictures);
    const ExitCode exit_code = result.exit_code;
    const bool starts = program.runnable() && !scripts[i].diagnostics.has_errors();
    put_message(problems_text(result, program, scripts[i]));
    if (starts) pictures.save(result, program);
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

}  // namespace rob::runtime
