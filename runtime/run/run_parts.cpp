#include "runtime/run/run_parts.h"

#include <filesystem>
#include <utility>

namespace rob::runtime {

namespace {

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

}  // namespace

SignalNames names_in(const LoadedProgram& program, const motion::RobotModel& robot) {
  return {robot, program.compilation.chunk->named_signals};
}

bool has_handlers(const LoadedProgram& program) {
  return lang::has_handlers(*program.compilation.chunk);
}

std::string data_folder_of(const LoadedProgram& program, const std::string& data) {
  return data.empty() ? std::filesystem::path(program.file).parent_path().string() : data;
}

std::vector<KeptVariable> kept_variables(const LoadedProgram& program) {
  std::vector<KeptVariable> variables;
  const std::vector<std::string> used = used_names(program);
  for (const lang::PersistCode& one : program.compilation.chunk->persists) {
    const std::uint32_t file = one.place.file;
    const std::string of =
        file == 0 ? "" : std::filesystem::path(used.at(file - 1)).stem().string() + ".";
    variables.push_back({of + one.name, one.type});
  }
  return variables;
}

void hand_over(const Note& note, double time, DataFiles& files, TextDevices& devices) {
  if (note.kind == Note::Kind::Write) files.append(note.file, note.text);
  if (note.kind == Note::Kind::Send) devices.send(note.variable, note.text);
  if (note.kind == Note::Kind::Line) devices.give(note.variable, time + note.after, note.text);
}

void give_lines(const SignalScript* script, TextDevices& devices) {
  if (script == nullptr) return;
  for (const SignalScript::Line& line : script->lines)
    devices.give(line.device, line.time, line.text);
  for (const SignalScript::Line& line : script->said) devices.promise(line.device);
}

void give_said_lines(const SignalScript* script, Channels& channels, double time,
                     TextDevices& devices) {
  std::uint32_t number = 0;
  while (channels.device_lines.take(number)) {
    const SignalScript::Line& line = script->said.at(number);
    devices.give(line.device, time, line.text);
  }
}

std::vector<SimulationRule> rules_of(const SignalScript* script) {
  return script == nullptr ? std::vector<SimulationRule>() : script->rules;
}

void prepare_panel(Controller& controller, const SignalScript* script) {
  if (script == nullptr) return;
  controller.channels().panel.prepare(script->answers, promise_of(*script, WorldSignal::Kind::Go),
                                      promise_of(*script, WorldSignal::Kind::Answer));
}

void add_failure(RunResult& result, const lang::RuntimeError& failure) {
  if (result.error) return;  // the robot's own trouble came first
  result.status = "program-error";
  result.exit_code = ExitCode::Fault;
  result.error =
      Problem{failure.code, "", failure.place, failure.message, failure.help, failure.calls};
}

RunResult of_program(const LoadedProgram& program, RunResult result) {
  result.file = program.file;
  result.used = used_names(program);
  if (result.error) place_in(program, *result.error);
  result.findings_left_out += program.compilation.diagnostics.left_out();
  const auto& found = program.compilation.diagnostics.all();
  result.findings.insert(result.findings.begin(), found.begin(), found.end());
  return result;
}

}  // namespace rob::runtime
