#include "runtime/cli/compile_files.h"

#include "lang/code/disassembler.h"
#include "runtime/cli/program_files.h"
#include "runtime/run/console.h"

namespace rob::runtime {

ExitCode compile_files(const Options& options) {
  ExitCode worst = ExitCode::Done;
  for (const LoadedProgram& program : load_programs(options)) {
    for (const lang::Diagnostic& found : program.compilation.diagnostics.all()) {
      put_message(lang::render(found, program.file, program.source, program.compilation.used));
    }
    if (!program.runnable()) {
      worst = ExitCode::ProgramError;
    } else if (options.listing) {
      put_result(lang::disassemble(*program.compilation.chunk));
    }
  }
  return worst;
}

}  // namespace rob::runtime
