#include "lang/compile/compiler.h"

#include <string>
#include <type_traits>
#include <utility>
#include <vector>

#include <fmt/core.h>

#include "lang/check/fold.h"
#include "lang/compile/statement_compiler.h"
#include "lang/text/codes.h"
#include "lang/values/pose_slots.h"

namespace rob::lang {
namespace {

std::vector<std::string> signal_names(const RobotSignature& robot) {
  std::vector<std::string> names;
  for (const RobotSignature::Signal& signal : robot.signals) names.push_back(shown_name(signal));
  return names;
}

}  // namespace

bool declares(const Statement& statement) {
  return std::visit(
      []<typename Node>(const Node&) {
        return std::is_same_v<Node, Declaration> || std::is_same_v<Node, SignalDeclaration> ||
               std::is_same_v<Node, PointDeclaration> || std::is_same_v<Node, Use> ||
               std::is_same_v<Node, RecordDeclaration>;
      },
      statement.node);
}

StatementCompiler::StatementCompiler(const CheckedProgram& checked, const RobotSignature& robot,
                                     const EntryRooms* rooms)
    : program_(checked.program),
      robot_(robot),
      code_(signal_names(robot)),
      expressions_(code_, checked.symbols.size()),
      rooms_(rooms) {
  for (const CheckedProgram::Known& known : checked.known) know(known);
}

void StatementCompiler::know(const CheckedProgram::Known& known) {
  const Symbol& symbol = *known.symbol;
  expressions_.settle(symbol, known.kept->home);
  name_constant(symbol);
  if (symbol.kind == Symbol::Kind::Signal) name_signal(symbol);
  if (known.kept->safe) code_.declare_safe(*known.kept->safe);
}

Generated StatementCompiler::compile(const Program& program, Diagnostics& diagnostics) {
  const auto mark = code_.mark();
  if (program.memory || rooms_ != nullptr) code_.open_memory(program.end);
  for (const Routine& routine : program.routines) {
    if (routine.task) task_numbers_.emplace(routine.index, task_numbers_.size());
  }
  // A WHEN outside of all blocks is armed until the program has ended.
  rooms_ != nullptr ? compile_entry(program) : compile_top_level(program);
  code_.release(mark);
  code_.land(returns_);
  code_.emit(Opcode::end, program.end);
  if (std::ranges::any_of(program.routines, &Routine::test)) compile_test_entry(program);
  if (!task_numbers_.empty()) code_.task_entry(program.end);
  expressions_.enter_routine();
  for (const Routine& routine : program.routines) compile(routine);
  if (code_.failed() == CodeBuilder::Limit::None) {
    return {code_.finish(), room_, expressions_.homes()};
  }
  report_limit(diagnostics);
  return {};
}

/// Of a program that begins further down only the declarations are executed before that.
void StatementCompiler::compile_top_level(const Program& program) {
  for (const Statement& statement : program.statements) {
    const bool before = statement.place.file == 0 && statement.place.line < program.from;
    if (before && !declares(statement)) continue;
    compile(statement);
  }
}

/// What stands before the entry has been executed, and is jumped over: of that the names and their
/// homes stay.
void StatementCompiler::compile_entry(const Program& program) {
  CodeBuilder::Jumps over{code_.jump(program.end)};
  for (const Statement& statement : program.statements) {
    const std::uint32_t line = statement.place.line;
    if (line < program.entry) {
      begin_behind(rooms_->before.at(line));
    } else if (!over.empty()) {
      code_.land(std::exchange(over, {}));
      begin_behind(rooms_->now);
    }
    compile(statement);
  }
  code_.land(over);
  begin_behind(rooms_->now);
  room_ = code_.room();
  room_.whens = whens_;
}

void StatementCompiler::begin_behind(const Room& room) {
  code_.begin_behind(room);
  whens_ = std::max(whens_, room.whens);
}

Location StatementCompiler::declare(const Symbol& symbol) {
  const Slots slots = slots_of(symbol.type);
  if (!symbol.type.in_registers() || (code_.has_memory() && !code_.has_room(slots))) {
    const Location home = expressions_.memory(slots, symbol.place);
    expressions_.settle(symbol, home);
    return home;
  }
  return declare_in_registers(symbol);
}

Location StatementCompiler::declare_in_registers(const Symbol& symbol) {
  const Slots slots = slots_of(symbol.type);
  Location home;
  if (slots.numbers > 0) home.numbers.offset = code_.number_registers(slots.numbers);
  if (slots.texts > 0) home.texts.offset = code_.text_registers(slots.texts);
  name_home(symbol, home);
  expressions_.settle(symbol, home);
  return home;
}

/// Reports call a TOOL by its name.
void StatementCompiler::name_constant(const Symbol& symbol) {
  if (symbol.kind != Symbol::Kind::NamedConstant || !symbol.type.is(Type::Kind::Tool)) return;
  code_.name_tool({symbol.name, lang::load_pose(to_slots(symbol.value).data())});
}

/// And a channel by that of its SIGNAL.
void StatementCompiler::name_signal(const Symbol& symbol) {
  code_.name_signal({.name = symbol.name,
                     .signal = symbol.signal,
                     .dimension = symbol.type.dimension,
                     .low = symbol.low,
                     .high = symbol.high});
}

/// Tells listings what the registers are called.
void StatementCompiler::name_home(const Symbol& symbol, const Location& home) {
  if (symbol.name.empty()) return;
  const bool text = symbol.type.text();
  code_.name_register(symbol.name, text ? home.texts.reg() : home.numbers.reg(), text);
}

void StatementCompiler::compile(const Declaration& declaration) {
  const Symbol& first = *declaration.names.front().symbol;
  name_constant(first);
  // Constants that are known live in the code.
  if (declaration.constant && known(first.value)) return;
  const Location home = declare(first);
  if (declaration.value != nullptr) {
    expressions_.initialise(*declaration.value, home, first.type);
  } else {
    expressions_.clear(home, first.type, place_);
  }
  publish(first, place_);
  for (std::size_t i = 1; i < declaration.names.size(); ++i) {
    const Location other = declare(*declaration.names[i].symbol);
    expressions_.copy(home, other, first.type, place_);
    publish(*declaration.names[i].symbol, place_);
  }
}

void StatementCompiler::compile(const Assign& assign) {
  const auto* const name = std::get_if<Name>(&assign.target->node);
  if (name == nullptr || name->symbol->kind != Symbol::Kind::Signal) {
    expressions_.assign(*assign.target, *assign.value);
    return;
  }
  const auto mark = code_.mark();
  const Symbol& symbol = *name->symbol;
  expressions_.write_signal(symbol, expressions_.value(*assign.value, symbol.analog), place_);
  code_.release(mark);
}

void StatementCompiler::compile(const Pulse& pulse) {
  code_.uses_signal(pulse.target_place);
  const auto mark = code_.mark();
  const Register time = expressions_.value(*pulse.time);
  code_.depends_on_time();
  code_.emit(
      Instruction::ax(Opcode::pulse, time, static_cast<std::uint16_t>(pulse.target.symbol->signal)),
      place_);
  code_.release(mark);
}

void StatementCompiler::compile(const SignalDeclaration& signal) {
  name_signal(*signal.symbol);
  if (signal.safe == nullptr) return;
  code_.declare_safe({signal.symbol->signal, signal.safe_value, line_tag(signal.name_place)});
}

/// What is constant between two computed values is one text.
void StatementCompiler::compile(const Print& print) {
  const Place place = place_;
  const auto mark = code_.mark();
  const Register text = code_.text_register();
  std::string pending;
  bool begun = false;
  const auto flush = [&] {
    if (!begun) {
      code_.load_text(text, pending, place);
    } else if (!pending.empty()) {
      const auto inner = code_.mark();
      const Register piece = code_.text_register();
      code_.load_text(piece, pending, place);
      code_.emit(Opcode::append_text, place, text, piece);
      code_.release(inner);
    }
    begun = true;
    pending.clear();
  };
  for (const ExprPtr& value : print.values) {
    if (known(value->constant)) {
      pending += text_of(value->constant, value->type);
    } else {
      flush();
      expressions_.append_value(*value, text);
    }
  }
  flush();
  code_.emit(Opcode::print, place, text);
  code_.release(mark);
}

void StatementCompiler::compile(const Wait& wait) {
  const auto mark = code_.mark();
  if (wait.value->type == Type::boolean()) {
    wait_for_condition(wait);
  } else {
    code_.emit(Opcode::wait, place_, expressions_.value(*wait.value));
  }
  code_.release(mark);
}

/// The condition is looked at in every cycle of the standstill; the time counts from its first.
void StatementCompiler::wait_for_condition(const Wait& wait) {
  const Place place = place_;
  const bool limited = wait.timeout != nullptr;
  const Register limit = code_.number_registers(3);
  const auto begin = static_cast<Register>(limit + 1);
  const auto now = static_cast<Register>(limit + 2);
  if (limited) {
    expressions_.value_into(*wait.timeout, limit);
    code_.emit(Opcode::stand, place, begin);
  }
  const std::size_t top = code_.here();
  code_.emit(Opcode::stand, place, now);
  CodeBuilder::Jumps met = expressions_.jumps_if(*wait.value, true);
  code_.emit(Opcode::if_assumed, place);
  met.push_back(code_.jump(place));
  CodeBuilder::Jumps late;
  if (limited) {
    code_.depends_on_time();
    code_.emit(Opcode::if_elapsed, place, now, begin, limit);
    late.push_back(code_.jump(place));
  }
  code_.loop(top, place);
  CodeBuilder::Jumps done;
  if (limited) {
    code_.land(late);
    code_.emit(Opcode::waited, place);
    if (!wait.has_else) code_.emit(Opcode::fail_timeout, place);
    compile(wait.otherwise);
    done.push_back(code_.jump(place));
  }
  code_.land(met);
  code_.emit(Opcode::waited, place);
  code_.land(done);
}

void StatementCompiler::compile(const If& conditional) {
  CodeBuilder::Jumps done;
  for (const If::Branch& branch : conditional.branches) {
    const CodeBuilder::Jumps otherwise = expressions_.jumps_if(*branch.condition, false);
    compile(branch.body);
    const bool last = &branch == &conditional.branches.back() && conditional.otherwise.empty();
    if (!last) done.push_back(code_.jump(branch.condition->place));
    code_.land(otherwise);
  }
  compile(conditional.otherwise);
  code_.land(done);
}

void StatementCompiler::report_limit(Diagnostics& diagnostics) const {
  const Place place = code_.failed_at();
  switch (code_.failed()) {
    case CodeBuilder::Limit::None:
      return;
    case CodeBuilder::Limit::Registers:
      diagnostics.error(code::kTooManyVariables, place,
                        fmt::format("more than {} intermediate values and values of loops at once",
                                    kMostRegisters),
                        "compute parts of it before, in variables of their own");
      return;
    case CodeBuilder::Limit::Memory:
      diagnostics.error(
          code::kArrayTooLarge, place,
          fmt::format("with this, the arrays and records are too large: a program has room for {} "
                      "numbers and {} texts in them",
                      kMemory.numbers, kMemory.texts),
          "keep less at once");
      return;
    case CodeBuilder::Limit::Jump:
      diagnostics.error(code::kBlockTooLong, place, "the block that begins here is too long",
                        "divide it");
      return;
    case CodeBuilder::Limit::Watch:
      diagnostics.error(code::kNotWatchable, place,
                        "this cannot be computed in every control cycle",
                        "give the answer a variable before, and watch that");
      return;
    case CodeBuilder::Limit::WatchLength:
      diagnostics.error(
          code::kWatchTooLong, place,
          fmt::format("a condition that is looked at in every control cycle may take {} "
                      "instructions and {} variables",
                      kLongestWatch, kMostWatched),
          "compute what does not change before, into a variable");
      return;
    case CodeBuilder::Limit::Dimensions:
      diagnostics.error(code::kTooManyUnits, place,
                        "the program makes texts of more than 256 kinds of quantities",
                        "divide by a unit to print a plain number, for example x / 1mm");
      return;
    case CodeBuilder::Limit::Motions:
      diagnostics.error(code::kProgramTooLarge, place,
                        "the program has motions of more than 65536 forms", "divide it");
      return;
  }
}

Generated generate(const CheckedProgram& checked, const RobotSignature& robot,
                   Diagnostics& diagnostics, const EntryRooms* rooms) {
  return StatementCompiler(checked, robot, rooms).compile(checked.program, diagnostics);
}

}  // namespace rob::lang
