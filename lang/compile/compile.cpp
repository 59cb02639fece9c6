#include "lang/compile/compile.h"

#include <algorithm>
#include <utility>
#include <variant>

#include "lang/check/checker.h"
#include "lang/compile/compiler.h"
#include "lang/syntax/used_files.h"

namespace rob::lang {

namespace {

/// The line of the first statement that a program is carried out from.
std::uint32_t begin_of(const Program& program) {
  const auto begin = std::ranges::find_if(program.statements, [&](const Statement& one) {
    return one.place.file == 0 && one.place.line >= program.from;
  });
  return begin == program.statements.end() ? 0 : begin->place.line;
}

/// Routines, records and signals can stand nowhere else.
bool is_of_top_level(const Symbol& symbol) {
  return symbol.global || symbol.kind == Symbol::Kind::Routine ||
         symbol.kind == Symbol::Kind::Record || symbol.kind == Symbol::Kind::Enum ||
         symbol.kind == Symbol::Kind::Signal;
}

KeptName kept(const Symbol& symbol, const std::vector<Location>& homes) {
  KeptName name{symbol, homes[symbol.id], {}};
  for (const Symbol* const hidden : {symbol.taught, symbol.has_taught})
    if (hidden != nullptr) name.hidden.push_back({*hidden, homes[hidden->id], {}});
  name.symbol.taught = name.symbol.has_taught = nullptr;
  name.symbol.routine = nullptr;
  return name;
}

/// The names that the entry itself declares at its top level.
std::vector<KeptName> names_of(const CheckedProgram& checked, const Generated& generated) {
  std::vector<KeptName> names;
  for (const Symbol& symbol : checked.symbols) {
    const bool own = symbol.place.file == 0 && symbol.place.line >= checked.program.entry;
    if (!own || symbol.name.empty() || !is_of_top_level(symbol)) continue;
    names.push_back(kept(symbol, generated.homes));
    for (const SafeValue& safe : generated.chunk->safe_values)
      if (safe.line == line_tag(symbol.place)) names.back().safe = safe;
  }
  return names;
}

std::vector<Compilation::Definition> definitions_of(const Program& program) {
  std::vector<Compilation::Definition> definitions;
  for (const Statement& statement : program.statements) {
    const std::uint32_t line = statement.place.line;
    if (line >= program.entry && std::holds_alternative<Use>(statement.node))
      definitions.push_back({line, line, true, {}});
  }
  for (const Routine& routine : program.routines) {
    const bool own = routine.place.file == 0 && routine.place.line >= program.entry;
    if (!own || routine.handler || routine.test) continue;
    definitions.push_back({routine.place.line, routine.end.line, false});
    for (const Routine::Parameters& group : routine.parameters)
      for (const auto& name : group.names) definitions.back().parameters.push_back(name.name);
    definitions.back().name = routine.name;
    definitions.back().task = routine.task;
  }
  return definitions;
}

/// Those of the files that it USEs, too.
void add_obstacles(const Block& statements, std::vector<Obstacle>& obstacles) {
  for (const Statement& statement : statements) {
    if (const auto* const declared = std::get_if<ObstacleDeclaration>(&statement.node))
      obstacles.push_back(declared->obstacle);
    if (const auto* const use = std::get_if<Use>(&statement.node))
      add_obstacles(use->declarations, obstacles);
  }
}

/// Checks and generates; `rooms`: of an entry of the prompt.
void compile(Program program, const RobotSignature& robot, const PointTable& points,
             const TargetJudge& judge, KnownNames known, const EntryRooms* rooms,
             Compilation& compilation) {
  Diagnostics& diagnostics = compilation.diagnostics;
  // Without one of its files nearly every name would be unknown.
  if (!program.whole) return;
  RobotSignature signature = robot;
  signature.units = program.used_units;
  CheckedProgram checked = check(std::move(program), signature, points, judge, diagnostics, known);
  compilation.law = checked.program.header.law;
  compilation.features = std::move(checked.features);
  compilation.missing_points = std::move(checked.missing_points);
  if (checked.program.from != 0) compilation.begins = begin_of(checked.program);
  if (diagnostics.has_errors()) return;
  Generated generated = generate(checked, signature, diagnostics, rooms);
  if (!generated.chunk) return;
  if (rooms != nullptr) {
    compilation.names = names_of(checked, generated);
    for (const CheckedProgram::Known& one : checked.known)
      if (newly_shared(one)) compilation.shared.push_back({one.kept, one.symbol->of_tasks});
    compilation.definitions = definitions_of(checked.program);
    compilation.room = generated.room;
    compilation.types = checked.program.types;
  }
  compilation.chunk = std::move(generated.chunk);
  compilation.chunk->type_table = checked.program.types;
  add_obstacles(checked.program.statements, compilation.chunk->obstacles);
}

}  // namespace

Compilation compile(std::string_view source, const RobotSignature& robot, const PointTable& points,
                    const TargetJudge& judge, const Sources* sources, std::uint32_t from) {
  Compilation compilation;
  Program program = read_program(source, sources, robot, compilation.diagnostics, compilation.used);
  program.from = from;
  compile(std::move(program), robot, points, judge, {}, nullptr, compilation);
  return compilation;
}

Compilation compile(const EntryText& entry, const RobotSignature& robot, const PointTable& points,
                    const TargetJudge& judge, const Sources* sources) {
  Compilation compilation;
  Program program =
      read_program(entry.source, sources, robot, compilation.diagnostics, compilation.used,
                   entry.parts, entry.types, entry.printed ? entry.line : 0);
  program.entry = entry.line;
  compile(std::move(program), robot, points, judge, entry.known, &entry.rooms, compilation);
  return compilation;
}

}  // namespace rob::lang
