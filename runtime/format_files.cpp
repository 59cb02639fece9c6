#include "runtime/format_files.h"

#include <fmt/format.h>

#include "lang/format/formatter.h"
#include "lang/text/source_text.h"
#include "runtime/program/atomic_file.h"
#include "runtime/program/console.h"
#include "runtime/program/files.h"

namespace rob::runtime {

namespace {

ExitCode format_file(const std::string& file, bool check_only) {
  const std::string source = read_file(file, lang::kMaxSourceBytes);
  const lang::Formatting formatting = lang::format(source);
  for (const lang::Diagnostic& found : formatting.diagnostics.all()) {
    put_message(lang::render(found, file, source));
  }
  if (!formatting.text) return ExitCode::ProgramError;
  if (*formatting.text == source) return ExitCode::Done;
  if (!check_only) {
    save_file(file, *formatting.text);
    return ExitCode::Done;
  }
  put_result(file + "\n");
  return ExitCode::ProgramError;
}

}  // namespace

ExitCode format_files(const std::vector<std::string>& files, bool check_only) {
  ExitCode worst = ExitCode::Done;
  for (const std::string& file : files) {
    ExitCode code = ExitCode::InputOutput;
    try {
      code = format_file(file, check_only);
    } catch (const FileError& error) {
      put_message(fmt::format("rob: {}\n", error.what()));
    }
    if (worst == ExitCode::Done) worst = code;
  }
  return worst;
}

}  // namespace rob::runtime
