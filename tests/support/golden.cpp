#include "tests/support/golden.h"

#include <algorithm>
#include <array>

#include <fmt/core.h>

#include "lang/compile/compile.h"
#include "lang/vm/printing_machine.h"
#include "lang/vm/vm.h"

namespace rob::test {
namespace {

using Kind = Expectation::Kind;

std::string_view name_of(Kind kind) {
  switch (kind) {
    case Kind::Call:
      return "call";
    case Kind::Error:
      return "error";
    case Kind::Warning:
      return "warning";
    case Kind::Failure:
      return "failure";
    case Kind::Refusal:
      return "refusal";
  }
  return {};
}

/// Holds what happens against what is expected, and keeps the differences.
class Comparison {
 public:
  explicit Comparison(GoldenScript script) : open_(std::move(script.expectations)) {
    for (std::string& mistake : script.mistakes) differences_.push_back(std::move(mistake));
    if (open_.empty()) differences_.emplace_back("the program expects nothing");
  }

  /// A message: it must contain the text of an expectation of its line.
  void message(Kind kind, int line, const std::string& text) {
    const auto met = std::ranges::find_if(open_, [&](const Expectation& expected) {
      return expected.kind == kind && expected.line == line &&
             text.find(expected.text) != std::string::npos;
    });
    settle(met, kind, line, text);
  }

  /// A call: it must be the next one that is expected of its line.
  void call(int line, const std::string& text) {
    const auto next = std::ranges::find_if(open_, [&](const Expectation& expected) {
      return expected.kind == Kind::Call && expected.line == line;
    });
    if (next == open_.end() && text == "end") return;
    if (next != open_.end() && next->text != text) {
      differences_.push_back(
          fmt::format("line {}: expected call: {}, but got: {}", line, next->text, text));
      open_.erase(next);
      return;
    }
    settle(next, Kind::Call, line, text);
  }

  GoldenResult result() {
    GoldenResult result{.differences = std::move(differences_), .refusals = {}};
    for (const Expectation& expected : open_) {
      if (expected.kind == Kind::Refusal) {
        result.refusals.push_back(expected);
      } else {
        result.differences.push_back(fmt::format("line {}: expected {} did not come: {}",
                                                 expected.line, name_of(expected.kind),
                                                 expected.text));
      }
    }
    return result;
  }

  void difference(std::string text) { differences_.push_back(std::move(text)); }

 private:
  void settle(std::vector<Expectation>::iterator met, Kind kind, int line,
              const std::string& text) {
    if (met != open_.end()) {
      open_.erase(met);
    } else {
      differences_.push_back(fmt::format("line {}: unexpected {}: {}", line, name_of(kind), text));
    }
  }

  std::vector<Expectation> open_;
  std::vector<std::string> differences_;
};

/// The files that a golden program brings along.
class GivenFiles final : public lang::Sources {
 public:
  explicit GivenFiles(const GoldenScript& script) : script_(script) {}

  const lang::SourceFile& program() const override { return program_; }
  std::variant<lang::SourceFile, lang::NoSource> find(std::string_view name,
                                                      const std::string& /*by*/) const override {
    if (name == program_.identity) return program_;
    const auto file = std::ranges::find(script_.files, name, &GoldenScript::File::name);
    if (file == script_.files.end()) return lang::NoSource{"there is no such file", ""};
    return lang::SourceFile{file->name + ".rob", file->name, file->text};
  }

 private:
  const GoldenScript& script_;
  const lang::SourceFile program_{"main.rob", "main", ""};
};

/// The line of the golden program that tells of a place, in whichever file that is.
int line_of(const lang::Place& place, const lang::Compilation& compilation,
            const GoldenScript& script) {
  if (place.file == 0) return static_cast<int>(place.line);
  const std::string& name = compilation.used.at(place.file - 1).identity;
  const auto file = std::ranges::find(script.files, name, &GoldenScript::File::name);
  const bool within = place.line > 0 && place.line <= file->lines.size();
  return within ? file->lines[place.line - 1] : 0;
}

constexpr std::array<std::string_view, 6> kForceParts{"force.x",  "force.y",  "force.z",
                                                      "torque.x", "torque.y", "torque.z"};

void prepare(lang::PrintingMachine& machine, const lang::RobotSignature& robot,
             const GoldenScript& script, Comparison& comparison) {
  machine.answer_later(script.later);
  machine.answer(script.answers);
  for (const auto& [name, values] : script.signals) {
    const auto signal = std::ranges::find(robot.signals, name, lang::shown_name);
    const auto* const part = std::ranges::find(kForceParts, name);
    if (part != kForceParts.end()) {
      const auto component = static_cast<int>(part - kForceParts.begin());
      machine.script(lang::force_part(component), values);
    } else if (signal == robot.signals.end()) {
      comparison.difference("there is no signal " + name);
    } else {
      machine.script(static_cast<int>(signal - robot.signals.begin()), values);
    }
  }
}

void run(const lang::Compilation& compilation, const GoldenScript& script,
         lang::PrintingMachine& machine, Comparison& comparison) {
  // [choice] a golden program is small: what takes longer never ends.
  constexpr std::int64_t kMostInstructions = 10'000'000;
  lang::Vm vm(*compilation.chunk, machine);
  while (vm.state() != lang::Vm::State::Done && vm.state() != lang::Vm::State::Failed) {
    if (vm.executed() > kMostInstructions) {
      comparison.difference("the program does not end");
      break;
    }
    vm.run(kMostInstructions);
  }
  for (const auto& call : machine.calls()) {
    comparison.call(line_of(lang::tagged_place(call.line), compilation, script), call.text);
  }
  if (vm.state() == lang::Vm::State::Failed) {
    const lang::RuntimeError& error = vm.error();
    comparison.message(Kind::Failure, line_of(error.place, compilation, script),
                       fmt::format("{}: {}; {}", error.code, error.message, error.help));
  }
}

}  // namespace

GoldenResult check_golden(std::string_view source, const lang::RobotSignature& robot) {
  const GoldenScript script = read_golden(source);
  Comparison comparison(script);
  const GivenFiles files(script);
  const lang::Compilation compilation = lang::compile(source, robot, script.points, {}, &files);
  for (const lang::Diagnostic& diagnostic : compilation.diagnostics.all()) {
    comparison.message(
        diagnostic.severity == lang::Severity::Error ? Kind::Error : Kind::Warning,
        line_of(diagnostic.place, compilation, script),
        fmt::format("{}: {}; {}", diagnostic.code, diagnostic.message, diagnostic.help));
  }
  if (compilation.chunk) {
    lang::PrintingMachine machine(robot);
    prepare(machine, robot, script, comparison);
    run(compilation, script, machine, comparison);
  }
  return comparison.result();
}

}  // namespace rob::test
