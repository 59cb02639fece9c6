#include "tests/support/traced_run.h"

#include <fstream>

namespace rob::test {

std::string TracedRun::trouble() const {
  std::string text = "exit code " + std::to_string(process.exit_code);
  if (report.is_object() && report.contains("error") && report["error"].is_object())
    text += ": " + report["error"].dump();
  return text + "\n" + process.err;
}

TracedRun run_traced(const std::string& rob, const std::string& program, const std::string& robot,
                     const std::vector<std::string>& more) {
  const ScratchFolder scratch;
  const auto file = [&](const char* name) { return (scratch.path() / name).string(); };
  std::ofstream(file("program.rob"), std::ios::binary) << program;
  // A run that never ends is one that fails: timeout(1) makes its exit code 124.
  std::vector<std::string> arguments{
      "/usr/bin/timeout", "120", rob,      "run",    file("program.rob"),
      "--robot",          robot, "--fast", "--json", "--trace",
      file("trace.csv")};
  arguments.insert(arguments.end(), more.begin(), more.end());
  TracedRun run;
  run.process = run_process(arguments);
  run.report = nlohmann::json::parse(run.process.out, nullptr, false);
  if (run.report.is_discarded()) run.report = nullptr;
  if (std::filesystem::exists(file("trace.csv")))
    run.trace = parse_trace(read_whole_file(file("trace.csv")));
  return run;
}

}  // namespace rob::test
