#include "runtime/cli/program_files.h"

#include <algorithm>
#include <cstdint>
#include <iterator>
#include <set>

#include "runtime/run/output_file.h"
#include "runtime/run/simulation.h"
#include "runtime/run/text_report.h"

namespace rob::runtime {

/// One document, or a list where several programs were named, however many of them ran.
void print_json(const Options& options, const std::vector<RunResult>& results, PutJson document) {
  Pieces pieces;
  const Put put = pieces.put();
  if (options.files.size() == 1) {
    document(results.front(), 0, put);
    return put("\n");
  }
  const char* comma = "[";
  for (const RunResult& result : results) {
    put(std::string(comma) + "\n  ");
    document(result, 2, put);
    comma = ",";
  }
  put(results.empty() ? "[]\n" : "\n]\n");
}

/// The program's machine, open, and the program as it fits to it.
OpenMachine machine_for(LoadedProgram& program, const Options& options) {
  OpenMachine machine =
      open_machine(*backend_of(options.backend), program, options.law, options.home);
  for (const std::string& note : machine.notes) put_note(note);
  return machine;
}

/// All of them, before the first one starts: a file that cannot be read leaves nothing half done.
std::vector<LoadedProgram> load_programs(const Options& options) {
  std::vector<LoadedProgram> programs;
  for (const std::string& file : options.files)
    programs.push_back(load_program(file, options.robot, options.law, options.cell_file));
  for (LoadedProgram& program : programs)
    if (options.cell) change_cell(program.robot, *options.cell);
  return programs;
}

/// The signal script for each of them, which may use their names.
std::vector<SignalScript> load_scripts(const Options& options,
                                       const std::vector<LoadedProgram>& programs) {
  std::vector<SignalScript> scripts;
  for (const LoadedProgram& program : programs) {
    scripts.push_back(load_signal_script(options.signals, program));
  }
  return scripts;
}

/// Everything that the command reads, and what the programs may keep.
void refuse_overwriting_inputs(std::string_view option, const std::string& output,
                               const Options& options, const std::vector<LoadedProgram>& programs) {
  if (output.empty()) return;
  std::vector<InputFile> inputs;
  for (const LoadedProgram& program : programs)
    std::ranges::copy(inputs_of(program), std::back_inserter(inputs));
  if (!options.signals.empty()) inputs.push_back({options.signals, "the signal script"});
  if (!options.cell_file.empty()) inputs.push_back({options.cell_file, "the cell's file"});
  if (options.robot.ends_with(".toml")) inputs.push_back({options.robot, "the robot file"});
  refuse_overwriting(option, output, inputs);
}

/// The errors of the program or of its script, for people.
std::string problems_text(const RunResult& result, const LoadedProgram& program,
                          const SignalScript& script) {
  const bool in_script = program.runnable() && script.diagnostics.has_errors();
  if (in_script) return problems_text(result, script.source);
  std::set<std::uint32_t> lines;
  for (const lang::Diagnostic& finding : result.findings) lines.insert(finding.place.line);
  if (result.error) lines.insert(result.error->place.line);
  return problems_text(result, lines.empty() ? "" : source_lines(program, lines),
                       program.compilation.used);
}

}  // namespace rob::runtime
