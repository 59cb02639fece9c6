#include "lang/compile/statement_compiler.h"

#include <algorithm>
#include <string>

#include "lang/check/fold.h"
#include "lang/check/meaning.h"
#include "lang/compile/call_layout.h"
#include "lang/compile/operations.h"

namespace rob::lang {
namespace {

/// Registers that the places of what a handler uses take.
int captures_of(const Routine& handler) {
  int count = 0;
  for (const Symbol* const symbol : handler.captured) {
    const Slots slots = slots_of(symbol->type);
    count +=
        (slots.numbers > 0 ? 1 : 0) + (slots.texts > 0 ? 1 : 0) + (symbol->type.is_open() ? 1 : 0);
  }
  return count;
}

}  // namespace

StatementCompiler::StatementCompiler(CodeBuilder& code, Variables& variables, WorldCode& world,
                                     ExpressionCompiler& expressions, const Program& program,
                                     const RobotSignature& robot)
    : program_(program),
      code_(code),
      frame_(code.frame()),
      variables_(variables),
      world_(world),
      expressions_(expressions),
      blocks_(code),
      motions_(code, variables, expressions, blocks_, robot),
      declarations_(code, variables, expressions, robot) {
  for (const Routine& routine : program.routines) {
    if (routine.task) task_numbers_.emplace(routine.index, task_numbers_.size());
  }
}

void StatementCompiler::begin_behind(const Room& room) {
  frame_.begin_behind(room);
  blocks_.armed(room.whens);
}

Room StatementCompiler::room() const {
  Room room = frame_.room();
  room.whens = blocks_.whens();
  return room;
}

void StatementCompiler::compile(const Block& block) {
  const auto mark = frame_.mark();
  const std::size_t whens = blocks_.whens();
  for (const Statement& statement : block) compile(statement);
  blocks_.close_whens(whens, place_);
  frame_.release(mark);
}

// Motions

/// The guard is set before the motion is commanded, and asked for after it.
void StatementCompiler::compile(const WatchedMotion& watched) {
  const Place place = place_;
  const auto mark = frame_.mark();
  const auto& move = std::get<Move>(watched.motion.front().node);
  motions_.enter(move.clauses.surroundings, place);
  for (const WayPoint& event : watched.events) compile(event);
  place_ = place;  // the actions of the events have theirs
  if (watched.until == nullptr) {
    motions_.compile_motion(move, place);
    return motions_.leave(move.clauses.surroundings, place);
  }
  const ExpressionCompiler::WatchCode watch = expressions_.watch(*watched.until);
  code_.emit(Instruction::ax(Opcode::guard, watch.values, watch.index), place);
  motions_.compile_motion(move, place);
  const Register hit = frame_.number_registers();
  code_.emit(Opcode::ended, place, hit);
  motions_.leave(move.clauses.surroundings, place);
  if (watched.has_else) {
    code_.emit(Opcode::if_bool, place, hit, 1);
    const CodeBuilder::Jump done = code_.jump(place);
    compile(watched.otherwise);
    code_.land(done);
  }
  frame_.release(mark);
}

void StatementCompiler::compile(const WayPoint& event) {
  const auto mark = frame_.mark();
  const Register distance = frame_.number_registers(2);
  const auto lead = static_cast<Register>(distance + 1);
  expressions_.value_into(*event.distance, distance);
  if (event.shift == nullptr) {
    code_.load_real(lead, 0, kTime, event.place);
  } else {
    expressions_.value_into(*event.shift, lead);
    if (event.lag) code_.emit(Opcode::neg_real, event.place, lead, lead);
  }
  code_.emit(Opcode::on_the_way, event.place, distance, event.before ? 1 : 0);
  compile(event.action);
  frame_.release(mark);
}

void StatementCompiler::compile(const With& with) {
  const Place place = place_;
  motions_.enter(with.clauses.surroundings, place);
  motions_.begin_defaults(with.clauses, place);
  compile(with.body);
  motions_.end_defaults(with.clauses, place);
  motions_.leave(with.clauses.surroundings, place);
}

void StatementCompiler::compile(const Defaults& defaults) {
  motions_.set_defaults(defaults.clauses, place_);
}

void StatementCompiler::compile(const PathBlock& path) {
  const Place place = place_;
  motions_.enter(path.clauses.surroundings, place);
  const auto mark = frame_.mark();
  motions_.begin_path(path, place);
  compile(path.body);
  motions_.end_path(place);
  frame_.release(mark);
  motions_.leave(path.clauses.surroundings, place);
}

/// IN is of the axis alone.
void StatementCompiler::compile(const Press& press) {
  const Place place = place_;
  const auto mark = frame_.mark();
  const Register force = frame_.number_registers(2);
  const auto limit = static_cast<Register>(force + 1);
  expressions_.value_into(*press.force, force);
  if (press.limit != nullptr) {
    expressions_.value_into(*press.limit, limit);
  } else {
    code_.load_real(limit, 0, kSpeed, place);
  }
  motions_.enter(press.surroundings, place);
  code_.emit(Opcode::press, place, force, static_cast<unsigned>(press.axis));
  motions_.leave(press.surroundings, place);
  frame_.release(mark);
  blocks_.open(OpenScopes::Kind::Press);
  compile(press.body);
  blocks_.close(OpenScopes::Kind::Press, place);
}

/// Like WITH: where the block is left, what was allowed before it holds again.
void StatementCompiler::compile(const Allow& allow) {
  const Place place = place_;
  std::vector<std::string> names;
  for (const Declaration::Declared& body : allow.bodies) names.push_back(body.name);
  code_.allow(std::move(names), place);
  blocks_.open(OpenScopes::Kind::With);
  compile(allow.body);
  blocks_.close(OpenScopes::Kind::With, place);
}

void StatementCompiler::compile(const SetOverride& statement) {
  const auto mark = frame_.mark();
  code_.emit(Opcode::set_override, place_, expressions_.value(*statement.share, true));
  frame_.release(mark);
}

void StatementCompiler::compile(const Load& load) {
  constexpr int kMassAndCog = 4;
  const Place place = place_;
  const auto mark = frame_.mark();
  const Register first = frame_.number_registers(kMassAndCog);
  expressions_.value_into(*load.mass, first);
  if (load.cog != nullptr) expressions_.value_into(*load.cog, static_cast<Register>(first + 1));
  code_.emit(Opcode::carry, place, first, load.cog != nullptr ? 1U : 0U);
  frame_.release(mark);
}

// Names and values

void StatementCompiler::compile(const Assign& assign) {
  const auto* const name = std::get_if<Name>(&assign.target->node);
  if (name == nullptr || name->symbol->kind != Symbol::Kind::Signal) {
    if (assign.compound) return expressions_.change(*assign.target, *assign.value);
    return expressions_.assign(*assign.target, *assign.value);
  }
  const auto mark = frame_.mark();
  const Symbol& symbol = *name->symbol;
  world_.write_signal(symbol, expressions_.value(*assign.value, symbol.analog), place_);
  frame_.release(mark);
}

void StatementCompiler::compile(const Pulse& pulse) {
  code_.uses_signal(pulse.target_place);
  const auto mark = frame_.mark();
  const Register time = expressions_.value(*pulse.time);
  world_.pulse(*pulse.target.symbol, time, place_);
  frame_.release(mark);
}

void StatementCompiler::compile(const Print& print) {
  const Place place = place_;
  const auto mark = frame_.mark();
  code_.emit(Opcode::print, place, joined(print.values, place));
  frame_.release(mark);
}

void StatementCompiler::compile(const Write& write) {
  const Place place = place_;
  const auto mark = frame_.mark();
  const Register file = frame_.text_register();
  expressions_.value_into(*write.file, file);
  code_.emit(Opcode::write, place, file, joined(write.values, place));
  frame_.release(mark);
}

void StatementCompiler::compile(const Send& send) {
  const Place place = place_;
  const auto mark = frame_.mark();
  const Register text = joined(send.values, place);
  code_.emit(
      Instruction::ax(Opcode::send, text, static_cast<std::uint16_t>(send.device.symbol->device)),
      place);
  frame_.release(mark);
}

void StatementCompiler::compile(const Receive& receive) {
  const Place place = place_;
  const auto mark = frame_.mark();
  const Register line = frame_.text_register();
  const Register limit = frame_.number_registers(2);
  const auto came = static_cast<Register>(limit + 1);
  expressions_.value_into(*receive.timeout, limit);
  code_.depends_on_time();
  code_.receive(line, limit, came, receive.device.symbol->device, place);
  code_.emit(Opcode::if_bool, place, came, 0);
  const CodeBuilder::Jump late = code_.jump(place);
  expressions_.assign_register(*receive.target, line);
  const CodeBuilder::Jump done = code_.jump(place);
  code_.land(late);
  if (!receive.has_else) code_.emit(Opcode::fail_timeout, place, 1);
  compile(receive.otherwise);
  code_.land(done);
  frame_.release(mark);
}

void StatementCompiler::compile(const Read& read) {
  const auto mark = frame_.mark();
  const Register file = frame_.text_register();
  expressions_.value_into(*read.file, file);
  expressions_.read_rows(*read.target, file, place_);
  frame_.release(mark);
}

/// All constants between two computed values are one text.
Register StatementCompiler::joined(const std::vector<ExprPtr>& values, Place place) {
  const Register text = frame_.text_register();
  std::string pending;
  bool begun = false;
  const auto flush = [&] {
    if (!begun) {
      code_.load_text(text, pending, place);
    } else if (!pending.empty()) {
      const auto inner = frame_.mark();
      const Register piece = frame_.text_register();
      code_.load_text(piece, pending, place);
      code_.emit(Opcode::append_text, place, text, piece);
      frame_.release(inner);
    }
    begun = true;
    pending.clear();
  };
  for (const ExprPtr& value : values) {
    if (known(value->constant)) {
      pending += text_of(value->constant, value->type);
    } else {
      flush();
      expressions_.append_value(*value, text);
    }
  }
  flush();
  return text;
}

// HALT, ASK, and TESTs

void StatementCompiler::compile(const Halt& halt) {
  const Place place = place_;
  const auto mark = frame_.mark();
  if (halt.text != nullptr) {
    code_.emit(Opcode::halt, place, expressions_.value(*halt.text));
  } else {
    const Register text = frame_.text_register();
    code_.load_text(text, "", place);
    code_.emit(Opcode::halt, place, text);
  }
  frame_.release(mark);
}

/// The variable is read before: where nobody answers, while the program is foretold, it keeps its
/// value.
void StatementCompiler::compile(const Ask& ask) {
  const Place place = place_;
  const Type& type = ask.target->type;
  const auto mark = frame_.mark();
  const bool text = type.is(Type::Kind::String);
  const Register answer = text ? frame_.text_register() : frame_.number_registers();
  expressions_.value_into(*ask.target, answer);
  code_.ask(expressions_.value(*ask.text), answer, type, place);
  expressions_.assign_register(*ask.target, answer);
  frame_.release(mark);
}

void StatementCompiler::compile(const Assert& assertion) {
  const Place place = place_;
  const CodeBuilder::Jumps holds = expressions_.jumps_if(*assertion.condition, true);
  code_.with_text(Opcode::fail_assertion, 0, 0, assertion.text, place);
  code_.land(holds);
}

void StatementCompiler::compile(const Expect& expectation) {
  const Place place = place_;
  const auto mark = frame_.mark();
  const Register text = frame_.text_register();
  const Expr& condition = *expectation.condition;
  const auto compared = expressions_.compare(condition);
  const CodeBuilder::Jumps holds =
      compared ? compared->holds : expressions_.jumps_if(condition, true);
  code_.load_text(text, expectation.text + (compared ? " does not hold: left " : " does not hold"),
                  place);
  if (compared) {
    const Binary& binary = std::get<Binary>(condition.node);
    append_register(code_, compared->left, binary.left->type, compared->real, text, place);
    const Register between = frame_.text_register();
    code_.load_text(between, ", right ", place);
    code_.emit(Opcode::append_text, place, text, between);
    append_register(code_, compared->right, binary.right->type, compared->real, text, place);
  }
  code_.emit(Opcode::expect_failed, place, text);
  code_.land(holds);
  frame_.release(mark);
}

void StatementCompiler::compile(const Simulate& simulation) {
  const auto mark = frame_.mark();
  const Register value = frame_.number_registers(2);
  const auto after = static_cast<Register>(value + 1);
  if (simulation.after != nullptr) {
    expressions_.value_into(*simulation.after, after);
  } else {
    code_.load_real(after, 0, kTime, place_);
  }
  simulate(simulation, value);
  frame_.release(mark);
}

/// Into the first of the registers what the operator does, or an input becomes.
void StatementCompiler::simulate(const Simulate& simulation, Register value) {
  if (simulation.what == Simulate::What::Go) {
    expressions_.value_into(*simulation.value, value);
    return code_.emit(Opcode::simulate_go, place_, value);
  }
  if (simulation.what == Simulate::What::Answer) {
    const Register answer = expressions_.value(*simulation.value);
    return code_.emit(Opcode::simulate_answer, place_, value, answer);
  }
  if (simulation.what == Simulate::What::Device) {
    const Register line = expressions_.value(*simulation.value);
    return code_.simulate_line(value, line, simulation.target.symbol->device, place_);
  }
  const Symbol& symbol = *simulation.target.symbol;
  const bool force = symbol.kind == Symbol::Kind::Reading;
  expressions_.value_into(*simulation.value, value, symbol.analog || force);
  if (force) {
    world_.simulate_force(simulation.component, value, place_);
  } else {
    world_.simulate(symbol, value, place_);
  }
}

// Flow

void StatementCompiler::compile(const Wait& wait) {
  const auto mark = frame_.mark();
  if (wait.value->type == Type::boolean()) {
    wait_for_condition(wait);
  } else {
    code_.emit(Opcode::wait, place_, expressions_.value(*wait.value));
  }
  frame_.release(mark);
}

/// The condition is looked at in every cycle of the standstill; the time counts from its first.
void StatementCompiler::wait_for_condition(const Wait& wait) {
  const Place place = place_;
  const bool limited = wait.timeout != nullptr;
  const Register limit = frame_.number_registers(3);
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

/// The value is computed once, into a register of its own: a CASE may call what changes it.
void StatementCompiler::compile(const Select& select) {
  const auto real_value = [](const ExprPtr& value) { return value->type.kind == Type::Kind::Real; };
  const bool real = real_value(select.selector) ||
                    std::ranges::any_of(select.cases, [&](const Select::Case& one) {
                      return std::ranges::any_of(one.values, real_value);
                    });
  const auto mark = frame_.mark();
  const bool text = select.selector->type.kind == Type::Kind::String;
  const Register selector = text ? frame_.text_register() : frame_.number_registers();
  expressions_.value_into(*select.selector, selector, real);
  CodeBuilder::Jumps done;
  for (const Select::Case& one : select.cases) {
    CodeBuilder::Jumps matches;
    for (const ExprPtr& value : one.values) {
      matches.push_back(expressions_.jump_if_equal(selector, *value, real));
    }
    const CodeBuilder::Jump otherwise = code_.jump(one.place);
    code_.land(matches);
    compile(one.body);
    done.push_back(code_.jump(one.place));
    code_.land(otherwise);
  }
  compile(select.otherwise);
  code_.land(done);
  frame_.release(mark);
}

void StatementCompiler::compile(const While& loop) {
  const Place place = place_;
  const std::size_t top = code_.here();
  const CodeBuilder::Jumps exits = expressions_.jumps_if(*loop.condition, false);
  compile_body(loop.body);
  code_.loop(top, place);
  code_.land(exits);
  blocks_.leave_loop();
}

/// The registers are laid out as opcodes.def says.
void StatementCompiler::compile(const For& loop) {
  if (loop.elements != nullptr) return compile_elements(loop);
  const Place place = place_;
  const auto mark = frame_.mark();
  const bool real = loop.symbol->type.kind == Type::Kind::Real;
  const Register value = declarations_.declare_in_registers(*loop.symbol).numbers.reg();
  frame_.number_registers(real ? 4 : 2);
  expressions_.value_into(*loop.from, value, real);
  expressions_.value_into(*loop.to, static_cast<Register>(value + 1), real);
  const auto step = static_cast<Register>(value + 2);
  if (loop.step != nullptr) {
    expressions_.value_into(*loop.step, step, real);
  } else if (real) {
    code_.load_real(step, 1, kNone, place);
  } else {
    code_.load_integer(step, 1, place);
  }
  code_.emit(real ? Opcode::for_prepare_real : Opcode::for_prepare_int, place, value);
  const CodeBuilder::Jump none = code_.jump(place);
  const std::size_t top = code_.here();
  compile_body(loop.body);
  if (!real) code_.join_turns(top, value);
  code_.emit(real ? Opcode::for_next_real : Opcode::for_next_int, place, value);
  code_.loop(top, place);
  code_.land(none);
  blocks_.leave_loop();
  frame_.release(mark);
}

/// A FOR that counts, in registers that no statement can name; each turn begins with a copy of the
/// element.
void StatementCompiler::compile_elements(const For& loop) {
  const Place place = place_;
  const auto mark = frame_.mark();
  const Location whole = expressions_.array(*loop.elements);
  const Elements elements = *elements_of(loop.elements->type);
  const Location own = declarations_.declare(*loop.symbol);
  const Register which = frame_.number_registers(3);
  code_.load_integer(which, 1, place);
  variables_.count(whole, loop.elements->type, behind(which, 1), place);
  code_.load_integer(behind(which, 2), 1, place);
  code_.emit(Opcode::for_prepare_int, place, which);
  const CodeBuilder::Jump none = code_.jump(place);
  const std::size_t top = code_.here();
  const auto turn = frame_.mark();
  const Location element = variables_.element(whole, which, elements, loop.elements->place);
  variables_.copy(element, own, elements.type, place);
  frame_.release(turn);
  compile_body(loop.body);
  code_.emit(Opcode::for_next_int, place, which);
  code_.loop(top, place);
  code_.land(none);
  blocks_.leave_loop();
  frame_.release(mark);
}

void StatementCompiler::compile(const Loop& loop) {
  const Place place = place_;
  const std::size_t top = code_.here();
  compile_body(loop.body);
  code_.loop(top, place);
  blocks_.leave_loop();
}

void StatementCompiler::compile_body(const Block& body) {
  blocks_.enter_loop();
  compile(body);
  blocks_.land_next();
}

/// The register of the reason is taken before the body, which thus cannot use it.
void StatementCompiler::compile(const Try& statement) {
  const Place place = place_;
  const auto mark = frame_.mark();
  const Register why = frame_.text_register();
  code_.emit(Opcode::open_try, place, why);
  const CodeBuilder::Jump failed = code_.jump(place);
  blocks_.open(OpenScopes::Kind::Try);
  compile(statement.body);
  blocks_.close(OpenScopes::Kind::Try, place);
  const CodeBuilder::Jump done = code_.jump(place);
  blocks_.open(OpenScopes::Kind::Rescue);
  code_.land(failed);
  blocks_.disarm_inner(place);
  if (statement.why.symbol != nullptr) {
    Location home;
    home.texts.offset = why;
    declarations_.name_home(*statement.why.symbol, home);
    variables_.settle(*statement.why.symbol, home);
  }
  compile(statement.rescue);
  blocks_.close(OpenScopes::Kind::Rescue, place);
  code_.land(done);
  frame_.release(mark);
}

void StatementCompiler::compile(const Raise& statement) {
  const Place place = place_;
  if (statement.value == nullptr) return code_.emit(Opcode::raise_again, place);
  const auto mark = frame_.mark();
  code_.emit(Opcode::raise, place, expressions_.value(*statement.value));
  frame_.release(mark);
}

// Routines, TASKs and handlers

void StatementCompiler::compile(const Routine& routine) {
  routine_ = &routine;
  if (routine.test) {
    code_.add_test({routine.name, routine.place, static_cast<std::uint32_t>(routine.index)});
  }
  if (routine.task)
    code_.add_task(
        {routine.name, static_cast<std::uint32_t>(routine.index), routine.place, routine.outdated});
  blocks_.begin_routine();
  code_.begin_routine(routine.name, routine.place, routine.handler);
  const auto mark = frame_.mark();
  settle_parameters(routine);
  compile(routine.body);
  // A FUNC never comes here: the checker has seen that it RETURNs before.
  code_.emit(routine.handler ? Opcode::leave_handler : Opcode::leave, routine.end);
  frame_.release(mark);
  routine_ = nullptr;
}

/// The parameters are the first registers, as the caller has laid them out.
void StatementCompiler::settle_parameters(const Routine& routine) {
  const CallLayout layout = layout_of(routine);
  const auto parameters = parameters_of(routine);
  frame_.number_registers(layout.registers);
  frame_.text_registers(layout.text_registers);
  if (routine.handler) settle_captured(routine);
  if (routine.memory) code_.open_memory(routine.place);
  for (std::size_t i = 0; i < parameters.size(); ++i) {
    const Symbol& symbol = *parameters[i].declared->symbol;
    Location home = layout.homes[i];
    const bool by_reference = parameters[i].group->by_reference;
    if (!by_reference && !symbol.type.in_registers()) {
      home = variables_.temporary(symbol.type, routine.place);
      variables_.copy(layout.homes[i], home, symbol.type, routine.place);
    } else if (!by_reference) {
      declarations_.name_home(symbol, home);
    }
    variables_.settle(symbol, home);
  }
}

void StatementCompiler::compile(const Return& statement) {
  const Place place = place_;
  if (routine_ == nullptr) {
    blocks_.leave_program(place);
  } else if (statement.value == nullptr) {
    blocks_.leave_routine(place);
    code_.emit(Opcode::leave, place);
  } else if (!routine_->result.in_registers()) {
    expressions_.initialise(*statement.value, layout_of(*routine_).result, routine_->result);
    blocks_.leave_routine(place);
    code_.emit(Opcode::leave, place);
  } else {
    const auto mark = frame_.mark();
    const Type& type = routine_->result;
    const Register value = expressions_.value(*statement.value, type.is(Type::Kind::Real));
    blocks_.leave_routine(place);
    if (type.is(Type::Kind::String)) {
      code_.emit(Opcode::leave_with_text, place, value);
    } else {
      code_.emit(Opcode::leave_with, place, value, static_cast<unsigned>(slots_of(type).numbers));
    }
    frame_.release(mark);
  }
}

void StatementCompiler::compile(const Start& start) {
  const Routine& routine = *start.task.symbol->routine;
  code_.start(task_numbers_.at(routine.index), place_);
}

void StatementCompiler::compile(const When& when) {
  const Place place = place_;
  const Routine* const handler = when.handled ? &program_.routines[when.handler] : nullptr;
  const Register captured = handler != nullptr ? capture(*handler) : Register{0};
  const auto mark = frame_.mark();
  const ExpressionCompiler::WatchCode watch = expressions_.watch(*when.condition);
  code_.when(watch.values, watch.index, blocks_.arm(), place);
  if (handler != nullptr) {
    code_.when_handle(captured, captures_of(*handler), handler->stops, handler->index, place);
  } else if (const auto* const raise = std::get_if<Raise>(&when.action.front().node)) {
    code_.emit(Opcode::when_raise, when.action.front().place, expressions_.value(*raise->value));
  } else {
    compile(when.action);
  }
  frame_.release(mark);
}

/// The places of the variables that a handler uses of those around it, number slots before text
/// slots, in registers that stay its own until the block of the WHEN ends.
Register StatementCompiler::capture(const Routine& handler) {
  const Register first = frame_.number_registers(captures_of(handler));
  Register next = first;
  for (const Symbol* const symbol : handler.captured) {
    const Slots slots = slots_of(symbol->type);
    if (slots.numbers > 0) variables_.refer(*symbol, false, next++, place_);
    if (slots.texts > 0) variables_.refer(*symbol, true, next++, place_);
    if (symbol->type.is_open()) {
      variables_.count(variables_.home(*symbol), symbol->type, next++, place_);
    }
  }
  return first;
}

/// They are a handler's first registers, as REF parameters are a routine's.
void StatementCompiler::settle_captured(const Routine& handler) {
  Register next = frame_.number_registers(captures_of(handler));
  for (const Symbol* const symbol : handler.captured) {
    const Slots slots = slots_of(symbol->type);
    Location home{{SlotsAt::Base::Place}, {SlotsAt::Base::Place}};
    if (slots.numbers > 0) home.numbers.place = next++;
    if (slots.texts > 0) home.texts.place = next++;
    if (symbol->type.is_open()) home.count = next++;
    variables_.settle(*symbol, home);
  }
}

}  // namespace rob::lang
