// Rob's virtual machine beside Lua 5.4: the same algorithms in turns, and the ratio of the times.
//
//   vm_bench [TURNS [FOLDER]]
//
// Every NAME.rob of the folder, else of this one, is run, and NAME.lua beside it where lua5.4 is
// installed. The time is processor time, of execution alone, without compiling. The least of all
// turns counts: what makes a run longer is somebody else's doing. Results have to be the same.
#include <fmt/core.h>

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <filesystem>
#include <fstream>
#include <limits>
#include <optional>
#include <sstream>
#include <string>
#include <vector>

#include "lang/compile/compile.h"
#include "lang/vm/printing_machine.h"
#include "lang/vm/vm.h"
#include "tests/support/gantry_signature.h"

namespace fs = std::filesystem;

namespace {

struct Outcome {
  double seconds = std::numeric_limits<double>::infinity();
  std::string printed;
};

std::string whole_file(const fs::path& path) {
  std::ostringstream text;
  text << std::ifstream(path).rdbuf();
  return text.str();
}

Outcome run_rob(const fs::path& file) {
  using namespace rob::lang;
  const RobotSignature robot = rob::test::gantry_signature();
  const Compilation compilation = compile(whole_file(file), robot);
  if (!compilation.chunk) {
    for (const Diagnostic& found : compilation.diagnostics.all()) {
      fmt::print(stderr, "{}", render(found, file.string(), ""));
    }
    std::exit(EXIT_FAILURE);
  }
  PrintingMachine machine(robot);
  Vm vm(*compilation.chunk, machine);
  const std::clock_t begin = std::clock();
  while (vm.run(1'000'000) == Vm::State::Running) {
  }
  const auto spent = static_cast<double>(std::clock() - begin) / CLOCKS_PER_SEC;
  Outcome outcome{spent, ""};
  for (const auto& call : machine.calls()) {
    if (call.text.starts_with("print ")) outcome.printed += call.text.substr(6) + "\n";
  }
  return outcome;
}

/// Empty where lua5.4 is not installed. It prints its time behind the program's own output.
std::optional<Outcome> run_lua(const fs::path& file) {
  const std::string command = fmt::format(
      "lua5.4 -e \"local f = loadfile('{}'); local t = os.clock(); f(); print(os.clock() - t)\" "
      "2>/dev/null",
      file.string());
  std::FILE* const pipe = popen(command.c_str(), "r");
  if (pipe == nullptr) return std::nullopt;
  std::string output;
  for (int c = std::fgetc(pipe); c != EOF; c = std::fgetc(pipe)) output += static_cast<char>(c);
  if (pclose(pipe) != 0) return std::nullopt;
  output.pop_back();
  const std::size_t last = output.rfind('\n') + 1;
  return Outcome{std::atof(output.c_str() + last), output.substr(0, last)};
}

void compare(const fs::path& program, int turns) {
  fs::path other = program;
  other.replace_extension(".lua");
  Outcome rob;
  Outcome lua;
  for (int turn = 0; turn < turns; ++turn) {
    const Outcome ours = run_rob(program);
    rob = {std::min(rob.seconds, ours.seconds), ours.printed};
    const auto theirs = run_lua(other);
    if (theirs) lua = {std::min(lua.seconds, theirs->seconds), theirs->printed};
  }
  const std::string name = program.stem().string();
  if (lua.printed.empty()) {
    fmt::print("{:<12} {:8.1f} ms\n", name, rob.seconds * 1e3);
    return;
  }
  fmt::print("{:<12} {:8.1f} ms {:8.1f} ms   {:5.2f}{}\n", name, rob.seconds * 1e3,
             lua.seconds * 1e3, lua.seconds / rob.seconds,
             rob.printed == lua.printed ? "" : "   the results differ");
}

}  // namespace

int main(int argc, char** argv) {
  constexpr int kTurns = 7;
  const int turns = argc > 1 ? std::max(std::atoi(argv[1]), 1) : kTurns;
  std::vector<fs::path> programs;
  for (const auto& entry : fs::directory_iterator(argc > 2 ? argv[2] : ROB_BENCH_PROGRAMS)) {
    if (entry.path().extension() == ".rob") programs.push_back(entry.path());
  }
  std::sort(programs.begin(), programs.end());
  fmt::print("{:<12} {:>11} {:>11}   {}\n", "", "Rob", "Lua 5.4", "Lua / Rob");
  for (const fs::path& program : programs) compare(program, turns);
}
