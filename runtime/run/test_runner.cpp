#include "runtime/run/test_runner.h"

#include <utility>

#include "runtime/command/program_task.h"
#include "runtime/files/data_files.h"
#include "runtime/run/controller.h"
#include "runtime/run/execution.h"
#include "runtime/run/run_parts.h"
#include "runtime/run/run_recorder.h"
#include "runtime/run/simulation.h"
#include "runtime/words/codes.h"

namespace rob::runtime {

namespace {

/// [choice] As for `rob check`: what takes longer does not end.
constexpr RunLimits kTestLimits{3600, 100'000'000};

TestResult run_test(const LoadedProgram& program, const motion::RobotModel& robot,
                    std::size_t number, std::uint64_t seed, const std::string& data,
                    const WallTime& date) {
  const lang::Chunk& chunk = *program.compilation.chunk;
  const lang::TestCode& test = chunk.tests[number];
  Controller controller(robot, simulation_of(robot), 1);
  controller.channels().begun = date;
  ProgramTask task(chunk, controller.machine(), seed, number);
  DataFiles files(data_folder_of(program, data), DataFiles::Keeps::InMemory, true);
  controller.keep_files(&files);
  TextDevices devices(program.compilation.chunk->devices);
  controller.connect(&devices);
  RunRecorder recorder(robot, 1, controller.channels(), controller.log(),
                       {robot, chunk.named_signals},
                       {.print = {}, .snapshot = {}, .write = [&](const Note& note, double time) {
                          hand_over(note, time, files, devices);
                        }});
  const Timing timing = run_stepped(controller, task, kTestLimits, [&] { recorder.drain(); });
  RunResult run = recorder.finish();

  TestResult result{.name = test.name, .place = test.place, .time = run.measured};
  result.failures = controller.log().failed_expects();
  result.failures_left_out = controller.log().failed_expects_left_out();
  result.output = std::move(run.output);
  result.error = std::move(run.error);
  if (!result.error && task.failure()) {
    const lang::RuntimeError& failure = *task.failure();
    result.error =
        Problem{failure.code, "", failure.place, failure.message, failure.help, failure.calls};
  }
  // The outermost call is the TEST itself.
  if (result.error && !result.error->calls.empty() &&
      result.error->calls.back().routine == test.name) {
    result.error->calls.pop_back();
  }
  if (!result.error && timing.gave_up) {
    result.error = Problem{code::kTestWithoutEnd, "", test.place,
                           "this TEST has not ended within one hour of its time or 100,000,000"
                           " instructions",
                           "a WAIT in it may wait for an input that SIMULATE has to set"};
  }
  if (result.error) place_in(program, *result.error);
  return result;
}

}  // namespace

std::vector<TestResult> run_tests(const LoadedProgram& program, const motion::RobotModel& robot,
                                  std::uint64_t seed, const std::string& data,
                                  const WallTime& date) {
  std::vector<TestResult> results;
  const std::size_t count = program.compilation.chunk->tests.size();
  for (std::size_t i = 0; i < count; ++i)
    results.push_back(run_test(program, robot, i, seed, data, date));
  return results;
}

}  // namespace rob::runtime
