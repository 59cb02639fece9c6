#include "lang/compile.h"

#include <utility>

#include "lang/checker.h"
#include "lang/compiler.h"
#include "lang/parser.h"

namespace rob::lang {

Compilation compile(std::string_view source, const RobotSignature& robot,
                    const PointTable& points) {
  Compilation compilation;
  Diagnostics& diagnostics = compilation.diagnostics;
  Program program = parse(source, diagnostics);
  RobotSignature signature = robot;
  signature.units = program.header.units;
  CheckedProgram checked = check(std::move(program), signature, points, diagnostics);
  compilation.constant_targets = std::move(checked.constant_targets);
  compilation.features = std::move(checked.features);
  compilation.missing_points = std::move(checked.missing_points);
  if (!diagnostics.has_errors()) compilation.chunk = generate(checked, signature, diagnostics);
  if (compilation.chunk) compilation.chunk->type_table = checked.program.types;
  return compilation;
}

}  // namespace rob::lang
