#include "runtime/program/run.h"

#include <fmt/format.h>
#include <sys/stat.h>

#include <algorithm>
#include <limits>
#include <memory>
#include <optional>
#include <utility>

#include "runtime/control/codes.h"
#include "runtime/control/controller.h"
#include "runtime/control/execution.h"
#include "runtime/control/program_task.h"
#include "runtime/control/robot_machine.h"
#include "runtime/program/interruption.h"
#include "runtime/program/points_file.h"
#include "runtime/program/run_recorder.h"
#include "runtime/program/simulation.h"
#include "runtime/program/trace_writer.h"
#include "runtime/time/real_time.h"

namespace rob::runtime {

namespace {

constexpr RunLimits kNoLimits{std::numeric_limits<double>::infinity(),
                              std::numeric_limits<std::int64_t>::max()};
/// docs/language.md, what `rob check` assumes.
constexpr RunLimits kForetellLimits{3600, 100'000'000};
constexpr std::uint32_t kForetellTurns = 1000;

bool same_file(const std::string& a, const std::string& b) {
  struct stat first {};
  struct stat second {};
  return ::stat(a.c_str(), &first) == 0 && ::stat(b.c_str(), &second) == 0 &&
         first.st_dev == second.st_dev && first.st_ino == second.st_ino;
}

/// The trace asked for, opened before anything moves.
std::optional<TraceWriter> open_trace(const RunOptions& options, const LoadedProgram& program,
                                      const motion::RobotModel& robot) {
  if (options.trace.empty()) return std::nullopt;
  std::vector<std::string> files = used_names(program);
  files.push_back(program.file);
  for (const std::string& file : files) {
    if (!same_file(options.trace, file)) continue;
    throw FileError(
        fmt::format("the trace would overwrite the program '{}'; name another file", file));
  }
  return std::optional<TraceWriter>(std::in_place, options.trace, robot, used_names(program));
}

SignalNames names_in(const LoadedProgram& program, const motion::RobotModel& robot) {
  return {robot, program.compilation.chunk->named_signals};
}

Problem problem_of(const lang::Diagnostic& diagnostic, const std::string& file) {
  return {diagnostic.code, file, diagnostic.place, diagnostic.message, diagnostic.help};
}

/// What stops the program is also a finding, as the errors of the compiler are.
lang::Diagnostic finding_of(const Problem& problem) {
  return {lang::Severity::Error, problem.code, problem.place, problem.message, problem.help};
}

void add_failure(RunResult& result, const lang::RuntimeError& failure) {
  if (result.error) return;  // the robot's own trouble came first
  result.status = "program-error";
  result.exit_code = ExitCode::Fault;
  result.error =
      Problem{failure.code, "", failure.place, failure.message, failure.help, failure.calls};
}

void add_timing(RunResult& result, const Timing& timing) {
  result.measured += timing.drift;
  result.late_cycles = timing.late_cycles;
  result.worst_lateness = timing.worst_lateness;
}

void close_trace(std::optional<TraceWriter>& trace, const RunOptions& options, RunResult& result,
                 const RunListener& listener) {
  if (!trace) return;
  trace->close();
  result.lost_rows += trace->lost();
  if (result.lost_rows > 0 && listener.warn) {
    listener.warn(fmt::format("the trace '{}' is incomplete: {} rows are lost; is the disk full?",
                              options.trace, result.lost_rows));
  }
}

std::vector<SimulationRule> rules_of(const SignalScript* script) {
  return script == nullptr ? std::vector<SimulationRule>() : script->rules;
}

/// By signal number the names of the inputs that neither the simulated machine nor the script
/// drives; empty for all others.
std::vector<std::string> undriven_inputs(const LoadedProgram& program,
                                         const motion::RobotModel& robot,
                                         const SignalScript* script) {
  const lang::RobotSignature signature = signature_of(robot);
  std::vector<std::string> names;
  for (const lang::RobotSignature::Signal& signal : signature.signals) {
    const int channel = signal.channel - 1;
    const bool machine = !signal.analog && std::ranges::any_of(robot.actuators, [&](const auto& a) {
      return a.input_off == channel || a.input_on == channel;
    });
    const auto kind = signal.analog ? WorldSignal::Kind::AnalogInput : WorldSignal::Kind::Input;
    const bool scripted = std::ranges::any_of(rules_of(script), [&](const SimulationRule& rule) {
      return rule.setting.place.kind == kind && rule.setting.place.channel == channel;
    });
    const bool driven = signal.output || machine || scripted;
    names.push_back(driven ? "" : lang::shown_name(signal));
  }
  for (const lang::NamedSignal& named : program.compilation.chunk->named_signals) {
    std::string& name = names.at(static_cast<std::size_t>(named.signal));
    if (!name.empty()) name = named.name;
  }
  return names;
}

/// How often a script acts as the operator.
OperatorPanel::Promise promise_of(const SignalScript& script, WorldSignal::Kind kind) {
  OperatorPanel::Promise promise;
  for (const SimulationRule& rule : script.rules) {
    if (rule.setting.place.kind != kind) continue;
    if (kind == WorldSignal::Kind::Go && rule.setting.value == 0) continue;
    promise.whenever = promise.whenever || !rule.timed;
    promise.times += rule.timed ? 1 : 0;
  }
  return promise;
}

void prepare_panel(Controller& controller, const SignalScript* script) {
  if (script == nullptr) return;
  controller.channels().panel.prepare(script->answers, promise_of(*script, WorldSignal::Kind::Go),
                                      promise_of(*script, WorldSignal::Kind::Answer));
}

/// The first error is what the program is refused for.
RunResult refusal(const lang::Diagnostics& diagnostics, const std::string& file,
                  const motion::RobotModel& robot) {
  RunResult result;
  result.status = "program-error";
  result.exit_code = ExitCode::ProgramError;
  result.robot = robot.name;
  result.law = motion::law_name(robot.law);
  for (const lang::Diagnostic& diagnostic : diagnostics.all()) {
    if (diagnostic.severity != lang::Severity::Error) continue;
    result.error = problem_of(diagnostic, file);
    break;
  }
  return result;
}

RunResult start_of(const LoadedProgram& program, RunResult result) {
  result.file = program.file;
  result.used = used_names(program);
  if (result.error) place_in(program, *result.error);
  result.findings_left_out = program.compilation.diagnostics.left_out();
  const auto& found = program.compilation.diagnostics.all();
  result.findings.insert(result.findings.begin(), found.begin(), found.end());
  return result;
}

/// What is planned, where motions do not bring their times: what was foretold of the lines that
/// have run as often.
void add_foretold(RunResult& result, const RunResult& foretold) {
  result.planned = foretold.planned;
  result.foretold = result.lines.size() == foretold.lines.size();
  for (LineResult& line : result.lines) {
    const auto same = std::ranges::find(foretold.lines, line.line, &LineResult::line);
    line.foretold = same != foretold.lines.end() && same->count == line.count;
    if (line.foretold) line.planned = same->planned;
    result.foretold = result.foretold && line.foretold;
  }
}

}  // namespace

RunResult run(const LoadedProgram& program, const motion::RobotModel& robot,
              const RunOptions& options, const RunListener& listener) {
  std::optional<TraceWriter> trace = open_trace(options, program, robot);
  std::optional<RunResult> own;
  if (robot.law == motion::Law::LookAhead && options.foretold == nullptr)
    own = foretell(program, robot, options.seed, options.script, options.override_share);
  Controller controller(robot, simulation_of(robot), options.override_share,
                        rules_of(options.script));
  prepare_panel(controller, options.script);
  controller.channels().panel.seat(options.person);
  PointsFile points(points_file_of(program.file), robot);
  controller.machine().keep_points(&points);
  ProgramTask task(*program.compilation.chunk, controller.machine(), options.seed);
  RunRecorder recorder(robot, options.override_share, controller.channels(), controller.log(),
                       names_in(program, robot),
                       {listener.print,
                        [&](const Snapshot& snapshot) {
                          if (trace) trace->write(snapshot);
                        },
                        listener.consult});

  const Interruption interruption(controller.channels().hold_requested);
  const Attend attend = [&] {
    recorder.drain();
    if (listener.progress) {
      listener.progress({recorder.line(), recorder.time(), recorder.state()});
    }
  };
  if (!options.fast && listener.warn) {
    const std::string missing = prepare_real_time();
    if (!missing.empty()) listener.warn(missing);
  }
  const Timing timing = options.fast ? run_stepped(controller, task, kNoLimits, attend)
                                     : run_threaded(controller, task, attend);

  RunResult result = recorder.finish();
  result.clock = options.fast ? "virtual" : "system";
  add_timing(result, timing);
  if (robot.law == motion::Law::LookAhead) add_foretold(result, own ? *own : *options.foretold);
  if (task.failure()) add_failure(result, *task.failure());
  if (Interruption::requested() && !result.error) {
    result.status = "interrupted";
    result.exit_code = Interruption::exit_code();
  }
  close_trace(trace, options, result, listener);
  return start_of(program, std::move(result));
}

RunResult foretell(const LoadedProgram& program, const motion::RobotModel& robot,
                   std::uint64_t seed, const SignalScript* script, double override_share) {
  Controller controller(robot, simulation_of(robot), override_share, rules_of(script));
  prepare_panel(controller, script);
  ProgramTask task(*program.compilation.chunk, controller.machine(), seed);
  controller.machine().assume(undriven_inputs(program, robot, script));
  task.limit_turns(kForetellTurns);
  RunRecorder recorder(robot, override_share, controller.channels(), controller.log(),
                       names_in(program, robot), {});

  RunLimits limits = kForetellLimits;
  limits.standstill =
      !program.compilation.chunk->timed && (script == nullptr || script->rules.empty());
  const Timing timing = run_stepped(controller, task, limits, [&] { recorder.drain(); });
  RunResult result = recorder.finish();
  result.clock = "virtual";
  // What the simulated run took is what is foretold, with all its waiting.
  result.planned = result.measured;
  for (LineResult& line : result.lines) line.planned = line.measured;
  if (task.failure()) add_failure(result, *task.failure());
  if (task.circling() != 0) {
    result.findings.push_back(
        {lang::Severity::Note, code::kCircling, lang::tagged_place(task.circling()),
         fmt::format("the loop goes on; it was foretold for {} turns", kForetellTurns), ""});
  }
  if (timing.waits_for_ever) {
    result.findings.push_back(
        {lang::Severity::Warning, code::kWaitsForEver, task.place(),
         "the program waits here for ever: it stands, and nothing is left that"
         " could change an input",
         "set an output before that brings it about, or limit it: TIMEOUT 5s"});
  } else if (timing.gave_up) {
    result.findings.push_back({lang::Severity::Note,
                               code::kForetoldSoFar,
                               {},
                               "the program goes on; it was foretold as far as one hour of its "
                               "time or 100,000,000 instructions",
                               ""});
  }
  if (result.error) result.findings.push_back(finding_of(*result.error));
  return start_of(program, std::move(result));
}

RunResult refused(const LoadedProgram& program, const motion::RobotModel& robot) {
  return start_of(program, refusal(program.compilation.diagnostics, program.file, robot));
}

RunResult refused(const SignalScript& script, const motion::RobotModel& robot) {
  RunResult result = refusal(script.diagnostics, script.file, robot);
  result.file = script.file;
  result.findings = script.diagnostics.all();
  result.findings_left_out = script.diagnostics.left_out();
  return result;
}

}  // namespace rob::runtime
