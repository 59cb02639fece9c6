#include "runtime/run/foretell.h"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "drivers/contact/sim_cell.h"
#include "runtime/command/program_task.h"
#include "runtime/files/data_files.h"
#include "runtime/run/contact_watch.h"
#include "runtime/run/controller.h"
#include "runtime/run/execution.h"
#include "runtime/run/run_parts.h"
#include "runtime/run/run_recorder.h"
#include "runtime/run/simulation.h"
#include "runtime/words/codes.h"
#include "runtime/words/signature.h"
#include "runtime/words/units.h"

namespace rob::runtime {

namespace {

// docs/cli.md, rob check
constexpr double kHour = 3600;  // s
constexpr std::int64_t kInstructionsOfHour = 100'000'000;
constexpr std::uint32_t kForetellTurns = 10'000;

RunLimits limits_of(double longest) {
  const double hours = std::max(1.0, longest / kHour);
  return {longest, static_cast<std::int64_t>(kInstructionsOfHour * hours)};
}

/// It goes on beyond what was foretold.
lang::Diagnostic cut_short(double after) {
  return {lang::Severity::Note,
          code::kForetoldSoFar,
          {},
          fmt::format("the program goes on beyond the {:.0f} s that were foretold", after),
          "times and findings are those up to there, and not of the whole program; rob check --for "
          "8h follows it longer"};
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
    const bool moved = std::ranges::any_of(robot.actuators, [&](const auto& a) {
      return a.input_off == channel || a.input_on == channel;
    });
    const bool felt = robot.cell && (robot.cell->gripper.closed_input == channel ||
                                     robot.cell->gripper.held_input == channel);
    const bool machine = !signal.analog && (moved || felt);
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

/// A contact comes before anything that would have happened after it.
void add_contacts(ContactWatch& contacts, const LoadedProgram& program,
                  const motion::RobotModel& robot, bool early_ones, RunResult& result) {
  std::ranges::move(contacts.finish(), std::back_inserter(result.findings));
  result.cleared = contacts.cleared(early_ones);
  if (!contacts.contact()) return;
  const Contact& contact = *contacts.contact();
  const Words words = words_for(contact, robot);
  result.contact = contact;
  result.contact_joints = shown_joints(robot, contact.q);
  result.error = Problem{words.code, program.file, lang::tagged_place(contact.line), words.message,
                         words.help};
  result.status = "program-error";
  result.exit_code = ExitCode::ProgramError;
}

/// An error that stops the program is also a finding, as the errors of the compiler are.
lang::Diagnostic finding_of(const Problem& problem) {
  return {lang::Severity::Error, problem.code, problem.place, problem.message, problem.help};
}

}  // namespace

RunResult foretell(const LoadedProgram& program, const motion::RobotModel& robot,
                   const ForetellOptions& options) {
  const SignalScript* const script = options.script;
  std::unique_ptr<motion::ServoBackend> simulation = simulation_of(robot);
  const auto* const cell = dynamic_cast<const drivers::SimCell*>(simulation.get());
  Controller controller(robot, std::move(simulation), options.override_share, rules_of(script), 0,
                        has_handlers(program));
  if (options.path != nullptr) controller.tell(*options.path);
  prepare_panel(controller, script);
  controller.channels().begun = options.date;
  ProgramTask task(*program.compilation.chunk, controller.machine(), options.seed);
  std::optional<KeptValues> kept;
  if (!program.compilation.chunk->persists.empty())
    kept.emplace(values_file_of(program.file), kept_variables(program), KeptValues::For::Look);
  if (kept) task.start_from(kept->saved());
  controller.foretell(undriven_inputs(program, robot, script));
  task.limit_turns(kForetellTurns);
  DataFiles files(data_folder_of(program, options.data), DataFiles::Keeps::InMemory, true);
  controller.keep_files(&files);
  TextDevices devices(program.compilation.chunk->devices);
  give_lines(script, devices);
  controller.connect(&devices);
  ContactWatch contacts(robot);
  RunRecorder recorder(
      robot, options.override_share, controller.channels(), controller.log(),
      names_in(program, robot),
      {.print = {},
       .snapshot =
           [&](const Snapshot& snapshot) {
             if (cell != nullptr) contacts.hold(cell->scene().below_tip());
             contacts.take(snapshot);
             if (options.row) options.row(snapshot);
           },
       .write = [&](const Note& note, double time) { hand_over(note, time, files, devices); },
       .begin =
           [&](const LoggedSegment& motion, double time) {
             contacts.begin(motion, time);
             if (options.target) options.target(motion.target, static_cast<int>(motion.tag));
           },
       .end = [&](const LoggedSegment& motion, bool early) { contacts.end(motion, early); }});

  RunLimits limits = limits_of(options.longest);
  limits.standstill =
      !program.compilation.chunk->timed && (script == nullptr || script->rules.empty());
  const Timing timing = run_stepped(controller, task, limits, [&] {
    recorder.drain();
    give_said_lines(script, controller.channels(), recorder.time(), devices);
    if (options.progress) options.progress(recorder.time());
  });
  RunResult result = recorder.finish();
  result.clock = "virtual";
  // The foretold times are those that the simulated run took, with all its waiting.
  result.planned = result.measured;
  result.lines.change([](LineTotal& line) { line.planned = line.measured; });
  if (task.failure()) add_failure(result, *task.failure());
  if (result.status == "interrupted") {
    result.exit_code = ExitCode::Done;  // as the script wants it
    result.findings.push_back(
        {lang::Severity::Note,
         code::kForetoldSoFar,
         {},
         fmt::format("the signal script stops the robot; the program is foretold for the {:.2f} s "
                     "up to there",
                     result.measured),
         ""});
  }
  if (task.circling() != 0) {
    result.findings.push_back(
        {lang::Severity::Note, code::kCircling, lang::tagged_place(task.circling()),
         fmt::format("the loop goes on; it was foretold for {} turns without a motion",
                     kForetellTurns),
         ""});
  }
  if (timing.waits_for_ever) {
    result.findings.push_back(
        {lang::Severity::Warning, code::kWaitsForEver, task.place(),
         "the program waits here for ever: it stands, and nothing is left that"
         " could change an input",
         "set an output before that brings it about, or limit it: TIMEOUT 5s"});
  } else if (timing.gave_up) {
    result.findings.push_back(cut_short(result.measured));
  }
  add_contacts(contacts, program, robot, options.ends_known, result);
  if (result.error) result.findings.push_back(finding_of(*result.error));
  return of_program(program, std::move(result));
}

}  // namespace rob::runtime
