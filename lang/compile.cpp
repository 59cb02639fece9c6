#include "lang/compile.h"

#include <algorithm>
#include <utility>

#include "lang/checker.h"
#include "lang/compiler.h"
#include "lang/parser.h"

namespace rob::lang {
namespace {

/// A file without END ends in its last line, not in the empty one behind the last line end.
Place end_within(Place end, std::string_view source) {
  if (source.empty() || source.back() != '\n') return end;
  const auto lines = static_cast<std::uint32_t>(std::ranges::count(source, '\n'));
  return end.line > lines ? Place{.line = lines, .column = 1} : end;
}

}  // namespace

Compilation compile(std::string_view source, const RobotSignature& robot) {
  Compilation compilation;
  Diagnostics& diagnostics = compilation.diagnostics;
  Program program = parse(source, diagnostics);
  program.end = end_within(program.end, source);
  CheckedProgram checked = check(std::move(program), robot, diagnostics);
  compilation.constant_targets = std::move(checked.constant_targets);
  if (!diagnostics.has_errors()) compilation.chunk = generate(checked, robot, diagnostics);
  return compilation;
}

}  // namespace rob::lang
