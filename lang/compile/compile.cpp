#include "lang/compile/compile.h"

#include <algorithm>
#include <utility>
#include <variant>

#include "lang/check/checker.h"
#include "lang/compile/compiler.h"
#include "lang/syntax/used_files.h"
#include "lang/text/ascii.h"
#include "lang/values/types.h"

namespace rob::lang {

namespace {

DeclaredName::Kind kind_of(const Symbol& symbol) {
  switch (symbol.kind) {
    case Symbol::Kind::NamedConstant:
      return DeclaredName::Kind::Const;
    case Symbol::Kind::Point:
      return DeclaredName::Kind::Point;
    case Symbol::Kind::Signal:
      return DeclaredName::Kind::Signal;
    case Symbol::Kind::Routine:
      return DeclaredName::Kind::Routine;
    case Symbol::Kind::Record:
      return DeclaredName::Kind::Record;
    default:
      return DeclaredName::Kind::Variable;
  }
}

bool is_definition(const Symbol& symbol) {
  return symbol.kind == Symbol::Kind::Routine || symbol.kind == Symbol::Kind::Record;
}

/// Those of the program, the last of each name.
std::vector<DeclaredName> names_of(const CheckedProgram& checked) {
  std::vector<DeclaredName> names;
  for (const Symbol& symbol : checked.symbols) {
    const bool named = symbol.place.line != 0 && !symbol.name.empty();
    if (!named || !(symbol.global || is_definition(symbol))) continue;
    std::erase_if(names, [&](const DeclaredName& one) { return same_word(one.name, symbol.name); });
    names.push_back({kind_of(symbol), symbol.name, in_words(symbol.type), symbol.place});
  }
  return names;
}

/// Whether what stands from the entry on has to stay.
bool lasts(const Program& program) {
  const auto stays = [](const Statement& statement) {
    return declares(statement) || std::holds_alternative<When>(statement.node);
  };
  const auto is_new = [&](const auto& one) { return one.place.line >= program.entry; };
  return std::ranges::any_of(program.statements,
                             [&](const Statement& one) { return is_new(one) && stays(one); }) ||
         std::ranges::any_of(program.routines, [&](const Routine& one) {
           return !one.handler && one.place.file == 0 && is_new(one);
         });
}

/// The line of the first statement that a program is carried out from.
std::uint32_t begin_of(const Program& program) {
  const auto begin = std::ranges::find_if(program.statements, [&](const Statement& one) {
    return one.place.file == 0 && one.place.line >= program.from;
  });
  return begin == program.statements.end() ? 0 : begin->place.line;
}

}  // namespace

Compilation compile(std::string_view source, const RobotSignature& robot, const PointTable& points,
                    const TargetJudge& judge, const Sources* sources, std::uint32_t entry,
                    std::uint32_t from) {
  Compilation compilation;
  Diagnostics& diagnostics = compilation.diagnostics;
  Program program = read_program(source, sources, robot, diagnostics, compilation.used);
  // Without one of its files nearly every name would be unknown.
  if (!program.whole) return compilation;
  program.entry = entry;
  program.from = from;
  RobotSignature signature = robot;
  signature.units = program.used_units;
  CheckedProgram checked = check(std::move(program), signature, points, judge, diagnostics);
  compilation.law = checked.program.header.law;
  compilation.features = std::move(checked.features);
  compilation.missing_points = std::move(checked.missing_points);
  if (from != 0) compilation.begins = begin_of(checked.program);
  if (entry != 0) {
    compilation.lasts = lasts(checked.program);
    compilation.names = names_of(checked);
  }
  if (!diagnostics.has_errors()) compilation.chunk = generate(checked, signature, diagnostics);
  if (compilation.chunk) compilation.chunk->type_table = checked.program.types;
  return compilation;
}

}  // namespace rob::lang
