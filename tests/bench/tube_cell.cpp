/// tube_cell ROB EXAMPLES: S4's working cycle with all of its 100 tubes, without an operator, on
/// the virtual clock; twice, and whether both reports are the same to the last digit (tests/cli
/// compares traces, of which this would write a gigabyte).

#include <fmt/format.h>

#include <chrono>
#include <fstream>
#include <nlohmann/json.hpp>

#include "tests/support/process.h"

int main(int argc, char** argv) {
  using namespace rob::test;
  if (argc != 3) {
    fmt::print(stderr, "usage: tube_cell ROB EXAMPLES\n");
    return 64;
  }
  const std::string examples = argv[2];
  const ScratchFolder folder;
  std::string program = read_whole_file(examples + "/22_tube_cell.rob");
  const std::string few = "CONST tubes = 3 ";
  if (program.find(few) == std::string::npos) return 70;
  program.replace(program.find(few), few.size(), "CONST tubes = 100 ");
  const std::string file = (folder.path() / "cell.rob").string();
  std::ofstream(file) << program;
  std::ofstream(folder.path() / "tube_hand.rob") << read_whole_file(examples + "/tube_hand.rob");

  std::string first;
  for (int run = 1; run <= 2; ++run) {
    const auto begin = std::chrono::steady_clock::now();
    const ProcessResult result = run_process({argv[1], "run", file, "--fast", "--json"});
    const std::chrono::duration<double> took = std::chrono::steady_clock::now() - begin;
    const auto report = nlohmann::json::parse(result.out, nullptr, false);
    if (result.exit_code != 0 || report.is_discarded()) {
      fmt::print("{}", result.err);
      return 70;
    }
    for (const auto& line : report["output"]) fmt::print("{}\n", line.get<std::string>());
    fmt::print("run {}: {:.0f} s of the cell in {:.0f} s\n", run,
               report["measured_s"].get<double>(), took.count());
    if (run == 2) fmt::print("both reports: {}\n", result.out == first ? "the same" : "DIFFER");
    first = result.out;
  }
}
