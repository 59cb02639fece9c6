#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <optional>
#include <string>
#include <string_view>

#include "lang/compile.h"
#include "lang/parser.h"
#include "lang/printing_machine.h"
#include "lang/vm.h"
#include "tests/support/gantry_signature.h"

/// libFuzzer target: whatever bytes a file holds, it is compiled or refused with messages that
/// can be shown, and a program that compiles runs against the printing machine for a while.
/// A crash, a sanitizer's finding, or a broken promise below (abort) is a failure.
namespace {

using namespace rob::lang;

void promise(bool kept) {
  if (!kept) std::abort();
}

bool shows_well(const std::string& text) {
  return std::ranges::all_of(
      text, [](char c) { return c == '\n' || static_cast<unsigned char>(c) >= 0x20; });
}

void check_messages(const Compilation& compilation, std::string_view source) {
  const Diagnostics& diagnostics = compilation.diagnostics;
  promise(compilation.chunk.has_value() == !diagnostics.has_errors());
  promise(diagnostics.all().size() <= Diagnostics::kMost);
  for (const Diagnostic& diagnostic : diagnostics.all()) {
    const std::string text = render(diagnostic, "fuzz.rob", source);
    promise(shows_well(text) && text.starts_with("fuzz.rob"));
    promise(!diagnostic.message.empty() && diagnostic.message.find('\n') == std::string::npos);
    promise(shows_well(diagnostic.message) && shows_well(diagnostic.help));
  }
}

/// Endless loops, and programs that only wait, are legal: the run is cut off.
void run(const Chunk& chunk, const RobotSignature& robot, std::optional<std::size_t> test) {
  constexpr int kMostRuns = 20;
  constexpr std::int64_t kBudget = 2000;
  PrintingMachine machine(robot);
  machine.script(2, {false, true, false});
  Vm vm(chunk, machine);
  if (test) vm.choose_test(*test);
  for (int i = 0; i < kMostRuns; ++i) {
    const Vm::State state = vm.run(kBudget);
    if (state == Vm::State::Done) return;
    if (state == Vm::State::Failed) {
      promise(!vm.error().code.empty() && !vm.error().message.empty());
      return;
    }
  }
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  static const RobotSignature robot = rob::test::gantry_signature();
  const std::string_view source(reinterpret_cast<const char*>(data), size);
  const Compilation compilation = compile(source, robot);
  check_messages(compilation, source);
  if (!compilation.chunk) return 0;
  run(*compilation.chunk, robot, std::nullopt);
  if (!compilation.chunk->tests.empty()) run(*compilation.chunk, robot, 0);
  return 0;
}
