#include "runtime/cli/check_files.h"

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "runtime/cli/pictures.h"
#include "runtime/cli/program_files.h"
#include "runtime/files/files.h"
#include "runtime/files/path_file.h"
#include "runtime/run/console.h"
#include "runtime/run/foretell.h"
#include "runtime/run/progress.h"
#include "runtime/run/text_report.h"

namespace rob::runtime {

namespace {

/// A program with errors reports those first.
bool plans_a_path(const LoadedProgram& program) {
  return !program.runnable() || program.robot.law == motion::Law::LookAhead;
}

/// The file for the path; none asked for, or nothing to be foretold.
std::optional<PathFile> open_path(const Options& options, const LoadedProgram& program) {
  if (options.path.empty() || !program.runnable()) return std::nullopt;
  return std::optional<PathFile>(std::in_place, options.path, program.robot);
}

RunResult check_one(LoadedProgram& program, const Options& options, const SignalScript& script,
                    Pictures& pictures) {
  if (!script.diagnostics.has_errors()) machine_for(program, options);  // its limits count
  const motion::RobotModel& robot = program.robot;
  if (!program.runnable()) return refused(program, robot);
  if (script.diagnostics.has_errors()) return refused(script, robot);
  put_source_away(program);
  std::optional<PathFile> path = open_path(options, program);
  ForetellOptions how{options.seed,   &script, 1, options.data, path ? &*path : nullptr,
                      options.longest};
  how.date = options.date.value_or(WallTime{});
  Progress progress(options.longest);
  how.progress = [&](double time) { progress.show(time); };
  how.row = pictures.listener(robot);
  how.target = pictures.target_listener();
  RunResult result = foretell(program, robot, how);
  progress.clear();
  if (path) path->save();
  return result;
}

}  // namespace

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
  Pictures pictures(options, programs);
  for (std::size_t i = 0; i < programs.size(); ++i) {
    RunResult result = check_one(programs[i], options, scripts[i], pictures);
    if (result.exit_code != ExitCode::Done) result.exit_code = ExitCode::ProgramError;
    put_message(problems_text(result, programs[i], scripts[i]));
    worst = worse(worst, result.exit_code);
    if (!scripts[i].diagnostics.has_errors()) pictures.save(result, programs[i]);
    if (options.json) {
      results.push_back(std::move(result));
    } else if (programs[i].runnable() && !scripts[i].diagnostics.has_errors() &&
               options.svg != kStandardInput) {
      put_check_table(result, Pieces().put());
    }
  }
  if (options.json) print_json(options, results, put_check_json);
  return worst;
}

}  // namespace rob::runtime
