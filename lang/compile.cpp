#include "lang/compile.h"

#include <utility>

#include "lang/checker.h"
#include "lang/compiler.h"
#include "lang/parser.h"

namespace rob::lang {

Compilation compile(std::string_view source, const RobotSignature& robot) {
  Compilation compilation;
  Diagnostics& diagnostics = compilation.diagnostics;
  CheckedProgram checked = check(parse(source, diagnostics), robot, diagnostics);
  compilation.constant_targets = std::move(checked.constant_targets);
  compilation.features = std::move(checked.features);
  if (!diagnostics.has_errors()) compilation.chunk = generate(checked, robot, diagnostics);
  return compilation;
}

}  // namespace rob::lang
