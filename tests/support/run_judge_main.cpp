// Runs random gantry programs through a built `rob` and judges what it did against an independent
// reading of S1's law.
//
//   run_judge ROB [N [SEED]]      N programs from number SEED on
//   run_judge ROB --show SEED     prints one program and its segments

#include <cstdint>
#include <cstdio>
#include <exception>
#include <fstream>
#include <nlohmann/json.hpp>
#include <stdexcept>
#include <string>

#include "tests/support/gantry.h"
#include "tests/support/process.h"
#include "tests/support/random_program.h"
#include "tests/support/report_judge.h"
#include "tests/support/trace_file.h"
#include "tests/support/trace_judge.h"

namespace {

using namespace rob::test;

constexpr int kUsage = 64;

void add(Findings& findings, const Findings& more) {
  findings.insert(findings.end(), more.begin(), more.end());
}

/// One run of `rob`, and the bytes of its trace.
struct Run {
  ProcessResult process;
  std::string trace;
};

Run run_rob(const std::string& rob, const ScratchFolder& scratch, const char* name) {
  const std::string trace = (scratch.path() / (std::string(name) + ".csv")).string();
  Run run;
  run.process = run_process({rob, "run", (scratch.path() / "program.rob").string(), "--fast",
                             "--json", "--trace", trace});
  if (run.process.exit_code == 0) run.trace = read_whole_file(trace);
  return run;
}

Findings judge_program(const std::string& rob, const RandomProgram& program) {
  const ScratchFolder scratch;
  std::ofstream(scratch.path() / "program.rob") << program.text;
  const Run first = run_rob(rob, scratch, "first");
  if (first.process.exit_code != 0) {
    return {"exit code " + std::to_string(first.process.exit_code) + "\n" + first.process.out +
            first.process.err};
  }
  const PaulModel model(gantry_robot(), gantry_start(), program.steps);
  const TraceFile trace = parse_trace(first.trace);
  Findings findings = judge_against_model(trace, model, gantry_limits());
  add(findings, judge_smoothness(trace, gantry_limits().period, greatest_jerk(model)));
  add(findings, judge_report(nlohmann::json::parse(first.process.out), model, trace,
                             gantry_limits(), program.output));
  const Run second = run_rob(rob, scratch, "second");
  if (second.trace != first.trace) findings.push_back("a second run writes another trace");
  if (second.process.out != first.process.out) {
    findings.push_back("a second run writes another report");
  }
  return findings;
}

void show(const RandomProgram& program) {
  std::fputs(program.text.c_str(), stdout);
  const PaulModel model(gantry_robot(), gantry_start(), program.steps);
  std::printf("\n  line    starts     takes\n");
  for (const PaulSegment& segment : model.segments()) {
    std::printf("%6d %9.4f %9.4f\n", segment.line, segment.start, segment.span());
  }
  std::printf("   total %9.4f s\n", model.total());
}

/// How many of the programs failed.
int judge_all(const std::string& rob, std::uint64_t count, std::uint64_t seed) {
  int failed = 0;
  for (std::uint64_t number = seed; number < seed + count; ++number) {
    const RandomProgram program = random_gantry_program(number);
    Findings findings;
    try {
      findings = judge_program(rob, program);
    } catch (const std::exception& error) {
      findings = {error.what()};
    }
    if (findings.empty()) continue;
    ++failed;
    std::printf("program %llu:\n%s", static_cast<unsigned long long>(number), program.text.c_str());
    for (const std::string& finding : findings) std::printf("  %s\n", finding.c_str());
  }
  std::printf("%llu programs judged, %d failed\n", static_cast<unsigned long long>(count), failed);
  return failed;
}

}  // namespace

int main(int count, char** arguments) {
  try {
    if (count == 4 && std::string(arguments[2]) == "--show") {
      show(random_gantry_program(std::stoull(arguments[3])));
      return 0;
    }
    if (count >= 2 && count <= 4) {
      const std::uint64_t programs = count > 2 ? std::stoull(arguments[2]) : 20;
      const std::uint64_t seed = count > 3 ? std::stoull(arguments[3]) : 1;
      return judge_all(arguments[1], programs, seed) == 0 ? 0 : 1;
    }
  } catch (const std::logic_error&) {  // not a number
  }
  std::fprintf(stderr, "usage: run_judge ROB [N [SEED]] | ROB --show SEED\n");
  return kUsage;
}
