#include "runtime/run/run.h"

#include <fmt/format.h>

#include <algorithm>
#include <limits>
#include <memory>
#include <optional>
#include <utility>

#include "runtime/command/program_task.h"
#include "runtime/files/points_file.h"
#include "runtime/run/controller.h"
#include "runtime/run/execution.h"
#include "runtime/run/foretell.h"
#include "runtime/run/interruption.h"
#include "runtime/run/run_parts.h"
#include "runtime/run/run_recorder.h"
#include "runtime/run/trace_writer.h"
#include "runtime/time/real_time.h"

namespace rob::runtime {

namespace {

constexpr RunLimits kNoLimits{std::numeric_limits<double>::infinity(),
                              std::numeric_limits<std::int64_t>::max()};

/// The trace asked for, opened before anything moves.
std::optional<TraceWriter> open_trace(const RunOptions& options, const LoadedProgram& program,
                                      const motion::RobotModel& robot) {
  if (options.trace.empty()) return std::nullopt;
  return std::optional<TraceWriter>(std::in_place, options.trace, robot, used_names(program));
}

Problem problem_of(const lang::Diagnostic& diagnostic, const std::string& file) {
  return {diagnostic.code, file, diagnostic.place, diagnostic.message, diagnostic.help};
}

void add_timing(RunResult& result, const Timing& timing) {
  result.measured += timing.drift;
  result.late_cycles = timing.late_cycles;
  result.worst_lateness = timing.worst_lateness;
}

void close_trace(std::optional<TraceWriter>& trace, const RunOptions& options, RunResult& result,
                 const RunListener& listener) {
  if (!trace) return;
  const bool whole = trace->close();
  result.lost_rows += trace->lost();
  if (whole && result.lost_rows == 0) return;
  if (result.exit_code == ExitCode::Done) result.exit_code = ExitCode::InputOutput;
  const char* const why = whole ? "the computer was too busy to write them" : "is the disk full?";
  if (listener.warn) {
    listener.warn(fmt::format("the trace '{}' is incomplete: {} rows are lost; {}", options.trace,
                              result.lost_rows, why));
  }
}

/// Reports what could not be kept, and that the program does not know of.
void close_stores(ProgramStores& stores, RunResult& result, const RunListener& listener) {
  if (listener.warn) {
    for (const std::string& event : stores.take_events(TextDevices::Telling::All))
      listener.warn(event);
  }
  for (const std::string& why : stores.finish()) {
    if (result.exit_code == ExitCode::Done) result.exit_code = ExitCode::InputOutput;
    if (listener.warn) listener.warn(why);
  }
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

/// Where motions do not bring their times, the plan is the time that was foretold of the lines
/// that have run as often.
void compare(RunResult& result, const Foretold& foretold) {
  result.planned = foretold.planned;
  result.foretold = result.lines.size() == foretold.count;
  result.lines.change([&](LineTotal& line) {
    line.foretold = line.foretold && line.expected == line.count;
    if (!line.foretold) line.planned = 0;
    result.foretold = result.foretold && line.foretold;
  });
}

/// The virtual clock begins at a fixed date, so that runs repeat to the bit.
WallTime begin_of(const RunOptions& options) {
  return options.date.value_or(options.fast ? WallTime{} : wall_time_now());
}

ForetellOptions foretell_as(const RunOptions& options) {
  ForetellOptions how{options.seed, options.script, options.override_share, options.data};
  how.date = begin_of(options);
  return how;
}

RunResult run_on(const LoadedProgram& program, motion::RobotModel robot, OpenMachine machine,
                 ProgramStores& stores, const RunOptions& options, const RunListener& listener) {
  std::optional<TraceWriter> trace = open_trace(options, program, robot);
  Foretold own;
  Foretold& foretold = options.foretold != nullptr ? *options.foretold : own;
  if (robot.law == motion::Law::LookAhead && options.foretold == nullptr)
    own = foretold_by(foretell(program, robot, foretell_as(options)));
  robot.servo_period = machine.period;
  Controller controller(robot, std::move(machine.backend), options.override_share,
                        rules_of(options.script), 0, has_handlers(program));
  controller.trust(foretold.cleared);
  prepare_panel(controller, options.script);
  controller.channels().begun = begin_of(options);
  controller.channels().panel.seat(options.person);
  PointsFile points(points_file_of(program.file), robot);
  controller.keep_points(&points);
  give_lines(options.script, stores.devices());
  controller.keep_files(&stores.files());
  controller.connect(&stores.devices());
  ProgramTask task(*program.compilation.chunk, controller.machine(), options.seed);
  if (stores.saved() != nullptr) task.start_from(*stores.saved());
  RunRecorder recorder(robot, options.override_share, controller.channels(), controller.log(),
                       names_in(program, robot),
                       {.print = listener.print,
                        .snapshot =
                            [&](const Snapshot& snapshot) {
                              if (trace) trace->write(snapshot);
                              if (listener.row) listener.row(snapshot);
                            },
                        .consult = listener.consult,
                        .write = [&](const Note& note, double time) { stores.take(note, time); },
                        .signal = listener.signal,
                        .said = listener.said});

  if (robot.law == motion::Law::LookAhead) recorder.expect(std::move(foretold.lines));
  Channels& channels = controller.channels();
  const Interruption interruption(channels.stop);
  bool abandoned = false;
  int cycles = 0;
  const Attend attend = [&] {
    recorder.drain();
    give_said_lines(options.script, channels, recorder.time(), stores.devices());
    stores.drained();
    if (listener.warn)
      for (const std::string& event : stores.take_events()) listener.warn(event);
    // On the virtual clock this is every cycle: a question to the system would take longer.
    constexpr int kCyclesPerLook = 1000;
    if (listener.abandoned && (!options.fast || cycles++ % kCyclesPerLook == 0) &&
        listener.abandoned()) {
      abandoned = true;
      controller.request_hold();
    }
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
  if (robot.law == motion::Law::LookAhead) compare(result, foretold);
  if (task.failure()) add_failure(result, *task.failure());
  if (Interruption::requested() && !result.error) {
    result.status = "interrupted";
    result.exit_code = Interruption::exit_code();
  }
  if (abandoned && result.exit_code == ExitCode::Done) {
    result.status = "interrupted";
    result.exit_code = ExitCode::InputOutput;
  }
  close_trace(trace, options, result, listener);
  close_stores(stores, result, listener);
  return of_program(program, std::move(result));
}

}  // namespace

Foretold foretold_by(RunResult result) {
  Foretold foretold{result.planned, result.lines.size(), std::move(result.lines),
                    std::move(result.cleared)};
  foretold.lines.expect();
  return foretold;
}

RunResult run(const LoadedProgram& program, OpenMachine machine, ProgramStores& stores,
              const RunOptions& options, const RunListener& listener) {
  return run_on(program, program.robot, std::move(machine), stores, options, listener);
}

RunResult run(const LoadedProgram& program, const motion::RobotModel& robot,
              const RunOptions& options, const RunListener& listener) {
  motion::RobotModel model = robot;
  ProgramStores stores(program, options.data, !options.fast);
  OpenMachine machine = open_machine(BackendName{}, model);
  return run_on(program, model, std::move(machine), stores, options, listener);
}

RunResult refused(const LoadedProgram& program, const motion::RobotModel& robot) {
  return of_program(program, refusal(program.compilation.diagnostics, program.file, robot));
}

RunResult refused_for_contact(const LoadedProgram& program, const RunResult& foretold) {
  RunResult result;
  result.status = "fault";
  result.exit_code = ExitCode::Fault;
  result.robot = foretold.robot;
  result.law = foretold.law;
  result.findings = foretold.findings;
  result.contact = foretold.contact;
  result.contact_joints = foretold.contact_joints;
  result.error = foretold.error;
  return of_program(program, std::move(result));
}

RunResult refused(const SignalScript& script, const motion::RobotModel& robot) {
  RunResult result = refusal(script.diagnostics, script.file, robot);
  result.file = script.file;
  result.findings = script.diagnostics.all();
  result.findings_left_out = script.diagnostics.left_out();
  return result;
}

}  // namespace rob::runtime
