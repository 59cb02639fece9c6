#pragma once

#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <optional>

#include "lang/vm/printing_machine.h"
#include "lang/vm/vm.h"

/// What the fuzz targets hold the language to.
namespace rob::fuzz {

/// Where `kept` is false: says which promise is broken, for the log, and ends as a crash does.
/// (clang 14 has no std::source_location.)
inline void promise(bool kept, const char* file = __builtin_FILE(), int line = __builtin_LINE()) {
  if (kept) return;
  std::fprintf(stderr, "%s:%d: this promise is broken\n", file, line);
  std::abort();
}

/// Runs a program, or one of its TESTs, against the printing machine for a while: endless loops,
/// and programs that only wait, are legal.
inline void run(const lang::Chunk& chunk, const lang::RobotSignature& robot,
                std::optional<std::size_t> test) {
  constexpr int kMostRuns = 20;
  constexpr std::int64_t kBudget = 2000;
  lang::PrintingMachine machine(robot);
  machine.script(2, {false, true, false});
  lang::Vm vm(chunk, machine);
  if (test) vm.choose_test(*test);
  for (int i = 0; i < kMostRuns; ++i) {
    const lang::Vm::State state = vm.run(kBudget);
    if (state == lang::Vm::State::Done) return;
    if (state == lang::Vm::State::Failed) {
      promise(!vm.error().code.empty() && !vm.error().message.empty());
      return;
    }
  }
}

}  // namespace rob::fuzz
