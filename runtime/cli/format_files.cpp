#include "runtime/cli/format_files.h"

#include "lang/format/formatter.h"
#include "lang/text/visible.h"
#include "runtime/files/atomic_file.h"
#include "runtime/files/files.h"
#include "runtime/run/console.h"
#include "runtime/run/load.h"

namespace rob::runtime {

namespace {

/// False, and they are reported, if there are any; warnings do not matter to the layout.
bool is_sound(const lang::Diagnostics& found, const LoadedProgram& program) {
  for (const lang::Diagnostic& one : found.all()) {
    if (one.severity != lang::Severity::Error) continue;
    put_message(lang::render(one, program.file, program.source, program.compilation.used));
  }
  return !found.has_errors();
}

ExitCode format_file(const std::string& file, const Options& options) {
  const LoadedProgram program = load_program(file, options.robot, options.law);
  if (!is_sound(program.compilation.diagnostics, program)) return ExitCode::ProgramError;
  const lang::Formatting formatting = lang::format(program.source);
  if (!is_sound(formatting.diagnostics, program) || !formatting.text) return ExitCode::ProgramError;
  if (file == kStandardInput && !options.check_only) {
    put_result(*formatting.text);
    return ExitCode::Done;
  }
  if (*formatting.text == program.source) return ExitCode::Done;
  if (!options.check_only) {
    save_file(file, *formatting.text);
    return ExitCode::Done;
  }
  put_result(lang::on_one_line(file) + "\n");
  return ExitCode::ProgramError;
}

}  // namespace

ExitCode format_files(const Options& options) {
  ExitCode worst = ExitCode::Done;
  for (const std::string& file : options.files) {
    ExitCode code = ExitCode::InputOutput;
    try {
      code = format_file(file, options);
    } catch (const FileError& error) {
      put_error(error.what());
    }
    if (worst == ExitCode::Done) worst = code;
  }
  return worst;
}

}  // namespace rob::runtime
