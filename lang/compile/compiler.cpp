#include "lang/compile/compiler.h"

#include <algorithm>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include <fmt/core.h>

#include "lang/code/code_builder.h"
#include "lang/compile/expression_compiler.h"
#include "lang/compile/statement_compiler.h"
#include "lang/compile/variables.h"
#include "lang/compile/world_code.h"
#include "lang/syntax/declarations.h"
#include "lang/text/codes.h"

namespace rob::lang {
namespace {

std::vector<std::string> signal_names(const RobotSignature& robot) {
  std::vector<std::string> names;
  for (const RobotSignature::Signal& signal : robot.signals) names.push_back(shown_name(signal));
  return names;
}

/// Reports the limit that the program exceeds.
void report_limit(const CodeLimits& limits, bool at_prompt, Diagnostics& diagnostics) {
  const Place place = limits.place();
  switch (limits.exceeded()) {
    case Limit::None:
      return;
    case Limit::Registers:
      diagnostics.error(code::kTooManyVariables, place,
                        fmt::format("more than {} intermediate values and values of loops at once",
                                    kMostRegisters),
                        "compute parts of it before, in variables of their own");
      return;
    case Limit::Memory:
      diagnostics.error(
          code::kArrayTooLarge, place,
          fmt::format("with this, the arrays and records are too large: a program has room for {} "
                      "numbers and {} texts in them",
                      kMemory.numbers, kMemory.texts),
          at_prompt ? "what is declared anew keeps its room too: :reset gives all of it back"
                    : "keep less at once");
      return;
    case Limit::Jump:
      diagnostics.error(code::kBlockTooLong, place, "the block that begins here is too long",
                        "divide it");
      return;
    case Limit::Watch:
      diagnostics.error(code::kNotWatchable, place,
                        "this cannot be computed in every control cycle",
                        "give the answer a variable before, and watch that");
      return;
    case Limit::WatchLength:
      diagnostics.error(
          code::kWatchTooLong, place,
          fmt::format("a condition that is looked at in every control cycle may take {} "
                      "instructions and {} variables",
                      kLongestWatch, kMostWatched),
          "compute what does not change before, into a variable");
      return;
    case Limit::Dimensions:
      diagnostics.error(code::kTooManyUnits, place,
                        "the program makes texts of more than 256 kinds of quantities",
                        "divide by a unit to print a plain number, for example x / 1mm");
      return;
    case Limit::Motions:
      diagnostics.error(code::kProgramTooLarge, place,
                        "the program has motions of more than 65536 forms", "divide it");
      return;
  }
}

/// Code for a whole program: the top level, the beginning of TESTs and TASKs, and the routines.
class ProgramCompiler {
 public:
  ProgramCompiler(const CheckedProgram& checked, const RobotSignature& robot,
                  const EntryRooms* rooms);

  Generated compile(Diagnostics& diagnostics);

 private:
  void compile_top_level();
  void compile_entry();
  void begin_entry(const CodeBuilder::Jumps& over);
  void compile_test_entry();
  void compile_variables(const Block& statements);

  const Program& program_;
  std::span<const CheckedProgram::Known> known_;
  const EntryRooms* rooms_;  ///< null if it is no entry of the prompt
  Room room_;                ///< what the entry leaves taken
  CodeBuilder code_;
  Variables variables_;
  WorldCode world_;
  ExpressionCompiler expressions_;
  StatementCompiler statements_;
};

ProgramCompiler::ProgramCompiler(const CheckedProgram& checked, const RobotSignature& robot,
                                 const EntryRooms* rooms)
    : program_(checked.program),
      known_(checked.known),
      rooms_(rooms),
      code_(signal_names(robot)),
      variables_(code_, checked.symbols.size()),
      world_(code_),
      expressions_(code_, variables_, world_),
      statements_(code_, variables_, world_, expressions_, program_, robot) {
  for (const CheckedProgram::Known& known : checked.known) {
    statements_.know(*known.symbol, *known.kept);
  }
}

Generated ProgramCompiler::compile(Diagnostics& diagnostics) {
  const auto any = [&](bool Routine::*kind) {
    return std::ranges::any_of(program_.routines, kind);
  };
  const auto mark = code_.frame().mark();
  if (program_.memory || rooms_ != nullptr) code_.open_memory(program_.end);
  // A WHEN outside of all blocks is armed until the program has ended.
  rooms_ != nullptr ? compile_entry() : compile_top_level();
  code_.frame().release(mark);
  statements_.land_end();
  code_.emit(Opcode::end, program_.end);
  if (any(&Routine::test)) compile_test_entry();
  if (any(&Routine::task)) code_.task_entry(program_.end);
  variables_.enter_routine();
  for (const Routine& routine : program_.routines) statements_.compile(routine);
  if (code_.limits().exceeded() == Limit::None) return {code_.finish(), room_, variables_.homes()};
  report_limit(code_.limits(), rooms_ != nullptr, diagnostics);
  return {};
}

/// Where a program begins further down, only the declarations are executed before that.
void ProgramCompiler::compile_top_level() {
  for (const Statement& statement : program_.statements) {
    const bool before = statement.place.file == 0 && statement.place.line < program_.from;
    if (before && !is_declaration(statement)) continue;
    statements_.compile(statement);
  }
}

/// The lines before the entry have been executed, and are jumped over: their names keep their
/// homes.
void ProgramCompiler::compile_entry() {
  CodeBuilder::Jumps over{code_.jump(program_.end)};
  for (const Statement& statement : program_.statements) {
    const std::uint32_t line = statement.place.line;
    if (line < program_.entry) {
      statements_.begin_behind(rooms_->before.at(line));
    } else if (!over.empty()) {
      begin_entry(std::exchange(over, {}));
    }
    statements_.compile(statement);
  }
  if (!over.empty()) begin_entry(over);
  room_ = statements_.room();
}

/// TASKs get the values of the variables that they use from here on.
void ProgramCompiler::begin_entry(const CodeBuilder::Jumps& over) {
  code_.land(over);
  statements_.begin_behind(rooms_->now);
  for (const CheckedProgram::Known& known : known_)
    if (newly_shared(known)) variables_.publish(*known.symbol, program_.end);
}

/// A TEST begins like the program, with its declarations and without its statements; they take the
/// same registers again, since all else gives back what it has taken.
void ProgramCompiler::compile_test_entry() {
  code_.begin_tests();
  const auto mark = code_.frame().mark();
  if (program_.memory) code_.open_memory(program_.end);
  compile_variables(program_.statements);
  code_.call_test(program_.end);
  code_.emit(Opcode::end, program_.end);
  code_.frame().release(mark);
}

/// SIGNALs stand in the Chunk already.
void ProgramCompiler::compile_variables(const Block& statements) {
  for (const Statement& statement : statements) {
    if (const Use* const use = std::get_if<Use>(&statement.node)) {
      compile_variables(use->declarations);
    } else if (std::holds_alternative<Declaration>(statement.node) ||
               std::holds_alternative<DeviceDeclaration>(statement.node) ||
               std::holds_alternative<PointDeclaration>(statement.node) ||
               std::holds_alternative<Defaults>(statement.node)) {
      statements_.compile(statement);
    }
  }
}

}  // namespace

Generated generate(const CheckedProgram& checked, const RobotSignature& robot,
                   Diagnostics& diagnostics, const EntryRooms* rooms) {
  return ProgramCompiler(checked, robot, rooms).compile(diagnostics);
}

}  // namespace rob::lang
