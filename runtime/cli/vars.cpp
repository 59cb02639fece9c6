#include "runtime/cli/vars.h"

#include <fmt/format.h>

#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "lang/text/ascii.h"
#include "lang/text/suggest.h"
#include "runtime/cli/program_files.h"
#include "runtime/files/atomic_file.h"
#include "runtime/files/files.h"
#include "runtime/files/kept_values.h"
#include "runtime/run/console.h"
#include "runtime/run/load.h"
#include "runtime/run/run.h"
#include "runtime/run/run_parts.h"

namespace rob::runtime {

namespace {

/// By its name alone: also a value of another type than the variable's can be taken out.
void reset(const std::string& file, const std::string& name) {
  const ValuesLock lock(file);
  KeptValues values(file, {}, KeptValues::For::Look);
  auto lines = values.lines();
  if (lines.erase(lang::to_upper(name)) == 0) {
    std::vector<std::string_view> names;
    for (const auto& [key, line] : lines) names.push_back(line.name);
    throw UsageError(fmt::format("'{}' has no value of {}{}{}", file, lang::shortened(name),
                                 lang::suggest(name, names).empty() ? "" : "; ",
                                 lang::did_you_mean(lang::suggest(name, names))));
  }
  save_file(file, text_of_values(lines));
}

}  // namespace

ExitCode show_vars(const Options& options) {
  const std::string& program_file = options.files.front();
  const std::string file = values_file_of(program_file);
  if (!options.reset.empty()) {
    reset(file, options.reset);
    return ExitCode::Done;
  }
  const LoadedProgram program = load_program(program_file, options.robot, options.law);
  if (!program.runnable()) {
    put_message(problems_text(refused(program, program.robot), program, {}));
    return ExitCode::ProgramError;
  }
  const KeptValues values(file, kept_variables(program), KeptValues::For::Look);
  for (const std::string& warning : values.warnings()) put_note(warning);
  std::map<std::string, std::string> shown;
  for (const KeptVariable& variable : kept_variables(program))
    shown[lang::to_upper(variable.name)] = fmt::format("{}: no value yet\n", variable.name);
  for (const auto& [key, line] : values.lines())
    shown[key] = fmt::format("{} = {}\n", line.name, line.text);
  for (const auto& [key, text] : shown) put_result(text);
  return ExitCode::Done;
}

}  // namespace rob::runtime
