#include "runtime/cli/test_files.h"

#include <string>
#include <utility>
#include <vector>

#include "runtime/run/console.h"
#include "runtime/run/json_report.h"
#include "runtime/run/load.h"
#include "runtime/run/run.h"
#include "runtime/run/simulation.h"
#include "runtime/run/test_report.h"
#include "runtime/run/test_runner.h"
#include "runtime/run/text_report.h"

namespace rob::runtime {

using Json = nlohmann::ordered_json;

namespace {

struct Outcome {
  Json json;
  bool passed = false;
};

Outcome test_file(const LoadedProgram& program, const Options& options) {
  const motion::RobotModel& robot = program.robot;
  if (!program.runnable()) {
    const RunResult result = refused(program, robot);
    put_message(problems_text(result, program.source, program.compilation.used));
    return {{{"status", result.status},
             {"file", program.file},
             {"ok", 0},
             {"failed", 0},
             {"tests", Json::array()},
             {"error", problem_json(result.error)}},
            false};
  }
  const std::vector<TestResult> results =
      run_tests(program, robot, options.seed, options.data, options.date.value_or(WallTime{}));
  if (!options.json) put_result(test_text(program.file, results));
  Json json = test_json(program.file, results);
  const bool passed = json["failed"] == 0;
  return {std::move(json), passed};
}

}  // namespace

ExitCode test_files(const Options& options) {
  std::vector<LoadedProgram> programs;
  for (const std::string& file : options.files)
    programs.push_back(load_program(file, options.robot, options.law, options.cell_file));
  for (LoadedProgram& program : programs) {
    if (options.cell) change_cell(program.robot, *options.cell);
    refuse_missing_points(program);
    refuse_what_an_arm_cannot(program);
  }
  ExitCode code = ExitCode::Done;
  Json documents = Json::array();
  for (const LoadedProgram& program : programs) {
    Outcome outcome = test_file(program, options);
    if (!outcome.passed) code = ExitCode::ProgramError;
    documents.push_back(std::move(outcome.json));
  }
  if (!options.json) return code;
  const Json& document = documents.size() == 1 ? documents.front() : documents;
  put_result(json_text(document));
  return code;
}

}  // namespace rob::runtime
