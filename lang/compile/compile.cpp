#include "lang/compile/compile.h"

#include <utility>

#include "lang/check/checker.h"
#include "lang/compile/compiler.h"
#include "lang/syntax/used_files.h"

namespace rob::lang {

Compilation compile(std::string_view source, const RobotSignature& robot, const PointTable& points,
                    const TargetJudge& judge, const Sources* sources) {
  Compilation compilation;
  Diagnostics& diagnostics = compilation.diagnostics;
  Program program = read_program(source, sources, robot, diagnostics, compilation.used);
  // Without one of its files nearly every name would be unknown.
  if (!program.whole) return compilation;
  RobotSignature signature = robot;
  signature.units = program.used_units;
  CheckedProgram checked = check(std::move(program), signature, points, judge, diagnostics);
  compilation.law = checked.program.header.law;
  compilation.features = std::move(checked.features);
  compilation.missing_points = std::move(checked.missing_points);
  if (!diagnostics.has_errors()) compilation.chunk = generate(checked, signature, diagnostics);
  if (compilation.chunk) compilation.chunk->type_table = checked.program.types;
  return compilation;
}

}  // namespace rob::lang
