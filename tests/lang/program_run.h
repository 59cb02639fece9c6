#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "lang/compile/compile.h"
#include "lang/vm/printing_machine.h"
#include "lang/vm/vm.h"
#include "tests/support/gantry_signature.h"

namespace rob::test {

/// A program from its text, ready to run on a gantry that writes down what it is told.
class ProgramRun {
 public:
  explicit ProgramRun(std::string_view source) : ProgramRun(source, gantry_signature()) {}
  ProgramRun(std::string_view source, lang::RobotSignature robot)
      : robot_(std::move(robot)),
        compilation_(lang::compile(source, robot_, {},
                                   [this](const lang::MoveCommand& command) {
                                     targets_.push_back(command);
                                     return std::optional<lang::Refusal>();
                                   })),
        machine_(robot_) {
    if (compilation_.chunk) vm_.emplace(*compilation_.chunk, machine_);
  }
  ProgramRun(const ProgramRun&) = delete;
  ProgramRun& operator=(const ProgramRun&) = delete;

  bool compiled() const { return compilation_.chunk.has_value(); }
  const lang::Compilation& compilation() const { return compilation_; }
  /// The targets that were known before the program ran.
  const std::vector<lang::MoveCommand>& targets() const { return targets_; }
  const lang::Chunk& chunk() const { return compilation_.chunk.value(); }
  lang::PrintingMachine& machine() { return machine_; }
  /// Throws, and so fails the test, if the program has errors.
  lang::Vm& vm() { return vm_.value(); }

  /// Runs to the end, or to an error; answers whatever the Vm waits for by running it again.
  lang::Vm::State finish() {
    using State = lang::Vm::State;
    State state = State::Running;
    while (state != State::Done && state != State::Failed) state = vm().run(1'000'000);
    return state;
  }

  /// What the only PRINT of the program printed.
  std::string printed() {
    finish();
    for (const auto& call : machine_.calls()) {
      if (call.text.starts_with("print ")) return call.text.substr(6);
    }
    return "";
  }

  /// The first error of the compilation, or an empty diagnostic.
  lang::Diagnostic first_error() const {
    for (const lang::Diagnostic& diagnostic : compilation_.diagnostics.all()) {
      if (diagnostic.severity == lang::Severity::Error) return diagnostic;
    }
    return {};
  }

 private:
  lang::RobotSignature robot_;
  std::vector<lang::MoveCommand> targets_;
  lang::Compilation compilation_;
  lang::PrintingMachine machine_;
  std::optional<lang::Vm> vm_;
};

}  // namespace rob::test
