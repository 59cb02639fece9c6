#include "lang/compile/expression_compiler.h"

#include <algorithm>
#include <string>
#include <vector>

#include "lang/check/fold.h"
#include "lang/check/meaning.h"
#include "lang/compile/call_layout.h"
#include "lang/compile/joined_operations.h"
#include "lang/compile/operations.h"
#include "lang/compile/texts_in_place.h"
#include "lang/values/pose_slots.h"

namespace rob::lang {
namespace {

constexpr int kVecParts = 3;

/// The instruction's word that holds an offset or a count.
Instruction number_word(std::int64_t number) { return {static_cast<std::uint32_t>(number)}; }

/// Number slots that the value of an expression takes where it stands.
int numbers_of(const Expr& expression) {
  return expression.place_slots != 0 ? expression.place_slots : slots_of(expression.type).numbers;
}

void compute_from_row(CodeBuilder& code, const Builtin& builtin, const Type& element, Register row,
                      Register target, Place place) {
  const bool real = element.is(Type::Kind::Real);
  const RowNumber which = builtin.name == "SUM"   ? RowNumber::Sum
                          : builtin.name == "MIN" ? RowNumber::Least
                                                  : RowNumber::Greatest;
  code.emit(real ? Opcode::row_real : Opcode::row_int, place, target, row,
            static_cast<unsigned>(which));
}

/// A LIST whose element is given by REF, or that stands for an array, keeps its length during the
/// call; returns how many lists do so.
int hold_list(CodeBuilder& code, Variables& variables, const Expr& argument, bool whole) {
  const Symbol& symbol = *root_of(argument)->symbol;
  const bool element = symbol.type.is(Type::Kind::List) && !argument.type.is(Type::Kind::List);
  if (!element && !whole) return 0;
  const Register home = code.frame().number_registers();
  variables.refer(symbol, false, home, argument.place);
  code.emit(Opcode::hold_list, argument.place, home);
  return 1;
}

}  // namespace

void ExpressionCompiler::begin(const Expr& expression) {
  world_.begin(observations(expression), expression.place);
  variables_.refresh(observed_globals(expression), world_.latched(), expression.place);
}

/// Only the indices of a place that is assigned read something.
void ExpressionCompiler::begin_place(const Expr& target) {
  int count = 0;
  std::vector<const Symbol*> globals;
  for (const Expr* at = &target;;) {
    if (const auto* const member = std::get_if<Member>(&at->node)) {
      at = member->object.get();
    } else if (const auto* const index = std::get_if<Index>(&at->node)) {
      count += observations(*index->index);
      std::ranges::copy(observed_globals(*index->index), std::back_inserter(globals));
      at = index->object.get();
    } else {
      break;
    }
  }
  world_.begin(count, target.place);
  variables_.refresh(globals, world_.latched(), target.place);
}

void ExpressionCompiler::value_into(const Expr& expression, Register target, bool as_real) {
  begin(expression);
  into(expression, target, as_real);
}

Register ExpressionCompiler::value(const Expr& expression, bool as_real) {
  begin(expression);
  return operand(expression, as_real);
}

void ExpressionCompiler::append_value(const Expr& expression, Register text) {
  begin(expression);
  append(expression, text);
}

void ExpressionCompiler::call(const Expr& expression) {
  begin(expression);
  const auto mark = frame_.mark();
  const auto& called = std::get<Call>(expression.node);
  if (called.routine != nullptr) {
    call_routine(called, expression);
  } else {
    call_procedure(called, expression.place);
    const Symbol& changed = *root_of(*called.arguments.front())->symbol;
    variables_.publish(changed, expression.place);
    variables_.changed(changed, expression.place);
  }
  frame_.release(mark);
}

Location ExpressionCompiler::array(const Expr& expression) {
  begin(expression);
  return locate(expression);
}

/// The value first, then the place: an index is computed after it.
void ExpressionCompiler::assign(const Expr& target, const Expr& value) {
  const Type& type = target.type;
  const bool as_real = type.kind == Type::Kind::Real;
  const auto mark = frame_.mark();
  if (const auto* const name = std::get_if<Name>(&target.node)) {
    const Location at = variables_.home(*name->symbol);
    const SlotsAt& part = type.text() ? at.texts : at.numbers;
    if (type.in_registers() && part.in_register()) {
      value_into(value, part.reg(), as_real);
      variables_.changed(*name->symbol, target.place);
      return variables_.publish(*name->symbol, target.place);
    }
  }
  if (!type.in_registers()) {
    assign_memory(target, value);
    return frame_.release(mark);
  }
  if (assign_constant_element(target, value)) return frame_.release(mark);
  begin(value);
  assign_register(target, operand_before(target, value, as_real));
  frame_.release(mark);
}

namespace {

using SameIndices = std::vector<std::pair<const Expr*, const Expr*>>;

/// The indices of a place that are computed, from the outside in, and those of its copy.
SameIndices indices(const Expr& place, const Expr& copy) {
  if (const auto* const member = std::get_if<Member>(&place.node)) {
    return indices(*member->object, *std::get<Member>(copy.node).object);
  }
  const auto* const index = std::get_if<Index>(&place.node);
  if (index == nullptr) return {};
  const auto& same = std::get<Index>(copy.node);
  SameIndices found = indices(*index->object, *same.object);
  if (!known(index->index->constant)) {
    found.push_back({index->index.get(), same.index.get()});
  }
  return found;
}

}  // namespace

/// The place is found once: a routine in the value, or in an index, could move it.
void ExpressionCompiler::change(const Expr& target, const Expr& value) {
  const auto mark = frame_.mark();
  const std::size_t before = settled_.size();
  begin_place(target);
  for (const auto& [index, same] : indices(target, *std::get<Binary>(value.node).left)) {
    const Register number = frame_.number_registers();
    value_into(*index, number);
    settled_.push_back({index, number});
    settled_.push_back({same, number});
  }
  assign(target, value);
  settled_.resize(before);
  frame_.release(mark);
}

void ExpressionCompiler::assign_register(const Expr& target, Register value) {
  const auto mark = frame_.mark();
  begin_place(target);
  const bool shared = root_of(target)->symbol->shared;
  if (variables_.is_number_element(target) && !shared) {
    store_element(Opcode::store_element, std::get<Index>(target.node), value, target.place);
  } else {
    const Location at = locate(target);
    if (shared) code_.last_element().keep();
    variables_.store(at, target.type, value, target.place);
    variables_.publish_part(*root_of(target)->symbol, at, target.type, target.place);
  }
  variables_.changed(*root_of(target)->symbol, target.place);
  frame_.release(mark);
}

void ExpressionCompiler::read_rows(const Expr& target, Register file, Place place) {
  const auto mark = frame_.mark();
  begin_place(target);
  const Location at = locate(target);
  const Register places = frame_.number_registers(2);
  variables_.refer_both(at, target.type, places, behind(places, 1), place);
  code_.read_rows(file, places, target.type, place);
  const Symbol& root = *root_of(target)->symbol;
  variables_.publish_part(root, at, target.type, place);
  variables_.changed(root, place);
  frame_.release(mark);
}

void ExpressionCompiler::initialise(const Expr& value, const Location& home, const Type& type) {
  begin(value);
  put(value, home, type);
}

Register ExpressionCompiler::operand(const Expr& expression, bool as_real) {
  for (const auto& [index, value] : settled_) {
    if (index == &expression) return value;
  }
  const bool convert = (as_real && expression.type == Type::integer()) ||
                       numbers_of(expression) > slots_of(expression.type).numbers;
  if (!convert && expression.moved_from == nullptr && variables_.is_number_element(expression)) {
    const Register target = frame_.number_registers();
    load_element(std::get<Index>(expression.node), target, expression.place);
    return target;
  }
  if (!convert && expression.moved_from == nullptr && variables_.is_variable(expression)) {
    const Location at = locate(expression);
    const SlotsAt& part = expression.type.text() ? at.texts : at.numbers;
    if (part.in_register()) return part.reg();
    const Register target = variables_.registers_for(expression.type);
    variables_.load(at, expression.type, target, expression.place);
    return target;
  }
  // The value of a routine stays where the call has left it.
  if (const auto* const call = std::get_if<Call>(&expression.node);
      call != nullptr && call->routine != nullptr && !convert && expression.moved_from == nullptr) {
    const Location result = call_routine(*call, expression);
    return expression.type.text() ? result.texts.reg() : result.numbers.reg();
  }
  const Register target = expression.place_slots != 0
                              ? frame_.number_registers(expression.place_slots)
                              : variables_.registers_for(expression.type);
  into(expression, target, as_real);
  return target;
}

Register ExpressionCompiler::operand_before(const Expr& then, const Expr& expression,
                                            bool as_real) {
  if (!calls_routine(then) || !variables_.is_variable(expression))
    return operand(expression, as_real);
  const Register target = variables_.registers_for(expression.type);
  into(expression, target, as_real);
  return target;
}

void ExpressionCompiler::into(const Expr& expression, Register target, bool as_real) {
  const auto mark = frame_.mark();
  if (expression.place_slots != 0) {
    into_other_place(expression, target);
  } else if (expression.moved_from != nullptr) {
    into_world(expression, target);
  } else {
    into_as_it_is(expression, target, as_real);
  }
  frame_.release(mark);
}

void ExpressionCompiler::into_as_it_is(const Expr& expression, Register target, bool as_real) {
  if (known(expression.constant)) {
    load_known(code_, expression, target, as_real);
  } else if (as_real && expression.type == Type::integer()) {
    code_.emit(Opcode::int_to_real, expression.place, target, operand(expression, false));
  } else if (const auto* const name = std::get_if<Name>(&expression.node)) {
    compile(*name, expression, target);
  } else if (const auto* const member = std::get_if<Member>(&expression.node);
             member != nullptr && angle_of(member->object->type, member->field)) {
    const Register pose = operand(*member->object, false);
    code_.emit(Opcode::pose_angle, expression.place, target, pose,
               static_cast<unsigned>(*angle_of(member->object->type, member->field)));
  } else if (variables_.is_number_element(expression)) {
    load_element(std::get<Index>(expression.node), target, expression.place);
  } else if (std::holds_alternative<Member>(expression.node) ||
             std::holds_alternative<Index>(expression.node)) {
    variables_.load(locate(expression), expression.type, target, expression.place);
  } else if (const auto* const tuple = std::get_if<Tuple>(&expression.node)) {
    compile(*tuple, target);
  } else if (const auto* const call = std::get_if<Call>(&expression.node)) {
    compile(*call, expression, target);
  } else if (expression.type.is(Type::Kind::Bool)) {
    compile_truth(expression, target);
  } else if (const auto* const unary = std::get_if<Unary>(&expression.node)) {
    compile(*unary, expression, target);
  } else if (const auto* const chain = std::get_if<Chain>(&expression.node)) {
    compile(*chain, expression, target);
  } else {
    compile(std::get<Binary>(expression.node), expression, target);
  }
}

void ExpressionCompiler::append(const Expr& expression, Register text) {
  const auto mark = frame_.mark();
  if (expression.type.is_row()) {
    const Register first = row(expression);
    code_.append_row(text, first, expression.type.detail->element, expression.place);
  } else if (!expression.type.in_registers()) {
    const Register places = frame_.number_registers(2);
    variables_.refer_both(locate(expression), expression.type, places, behind(places, 1),
                          expression.place);
    code_.append_memory(Opcode::append_memory, text, places, expression.type, expression.place);
  } else if (!expression.type.scalar()) {
    code_.append_value(text, operand(expression, false), expression.type, expression.place);
  } else {
    append_register(code_, operand(expression, false), expression.type, false, text,
                    expression.place);
  }
  frame_.release(mark);
}

void ExpressionCompiler::compile(const Name& name, const Expr& expression, Register target) {
  const Symbol& symbol = *name.symbol;
  if (symbol.kind == Symbol::Kind::Signal) {
    world_.read_signal(symbol, target, expression.place);
  } else if (symbol.kind == Symbol::Kind::Reading) {
    world_.read(symbol.reading, target, expression.place);
  } else if (!variables_.has_home(symbol)) {
    code_.emit(Opcode::read_hit, expression.place, target);
  } else {
    variables_.load(variables_.home(symbol), expression.type, target, expression.place);
  }
}

/// The value of a condition: the target is written only after all that it depends on was read.
void ExpressionCompiler::compile_truth(const Expr& expression, Register target) {
  const CodeBuilder::Jumps otherwise = jumps(expression, false);
  code_.load_integer(target, 1, expression.place);
  const CodeBuilder::Jump done = code_.jump(expression.place);
  code_.land(otherwise);
  code_.load_integer(target, 0, expression.place);
  code_.land(done);
}

// Operations

void ExpressionCompiler::compile(const Unary& unary, const Expr& expression, Register target) {
  if (unary.op == UnaryOp::Plus) {
    into(*unary.operand, target, false);
    return;
  }
  const Register from = operand(*unary.operand, false);
  if (unary.op == UnaryOp::BitNot) {
    const Register all_bits = frame_.number_registers();
    code_.load_integer(all_bits, -1, expression.place);
    return code_.emit(Opcode::bit_xor, expression.place, target, from, all_bits);
  }
  const Opcode op = expression.type == Type::integer() ? Opcode::neg_int : Opcode::neg_real;
  const int parts = slots_of(expression.type).numbers;
  for (int i = 0; i < parts; ++i) {
    code_.emit(op, expression.place, behind(target, i), behind(from, i));
  }
}

void ExpressionCompiler::compile(const Binary& binary, const Expr& expression, Register target) {
  if (expression.type.is(Type::Kind::String)) {
    const Register left = operand_before(*binary.right, *binary.left, false);
    if (left == target) return append_term(code_, *this, *binary.right, target, expression.place);
    const Register right = operand(*binary.right, false);
    code_.emit(Opcode::join_text, expression.place, target, left, right);
    return;
  }
  if (binary.left->type.is_place()) return compile_on_poses(binary, expression, target);
  if (expression.type.is(Type::Kind::Vec) || expression.type.is(Type::Kind::Joints)) {
    return compile_on_vectors(binary, expression, target);
  }
  if (compile_joined(code_, variables_, *this, binary, expression, target)) return;
  // DIV of reals yields an INT from REAL operands.
  const bool whole = on_whole_numbers(binary, expression.type);
  const Register left = operand_before(*binary.right, *binary.left, !whole);
  const Register right = operand(*binary.right, !whole);
  code_.emit(whole ? whole_opcode(binary.op) : real_opcode(binary.op), expression.place, target,
             left, right);
}

/// In a register of its own: a term may read the variable that the target is.
void ExpressionCompiler::compile(const Chain& chain, const Expr& expression, Register target) {
  const bool text = expression.type.text();
  const Register sum = variables_.registers_for(expression.type);
  bool real = chain.first->type.is(Type::Kind::Real);
  into(*chain.first, sum, real);
  for (const Chain::Step& step : chain.steps) {
    const auto mark = frame_.mark();
    if (text) {
      append_term(code_, *this, *step.term, sum, step.place);
      frame_.release(mark);
      continue;
    }
    const bool becomes_real = step.type.is(Type::Kind::Real);
    if (becomes_real && !real) code_.emit(Opcode::int_to_real, step.place, sum, sum);
    real = becomes_real;
    const Opcode op = real ? real_opcode(step.op) : whole_opcode(step.op);
    const Register term = operand(*step.term, real);
    code_.emit(op, step.place, sum, sum, term);
    frame_.release(mark);
  }
  if (text) return code_.emit(Opcode::take_text, expression.place, target, sum);
  variables_.copy_registers(target, sum, 1, expression.place);
}

/// VEC + VEC, VEC - VEC, number * VEC, VEC * number, VEC / number; the same of JOINTS. The number
/// is not read in place: it may be a part of the target.
void ExpressionCompiler::compile_on_vectors(const Binary& binary, const Expr& expression,
                                            Register target) {
  const auto side = [&](const Expr& operand_expression) {
    if (!operand_expression.type.numeric()) return operand(operand_expression, false);
    const Register number = frame_.number_registers();
    into(operand_expression, number, true);
    return number;
  };
  Register left = 0;
  if (calls_routine(*binary.right) && !binary.left->type.numeric()) {
    left = variables_.registers_for(binary.left->type);
    into(*binary.left, left, false);
  } else {
    left = side(*binary.left);
  }
  const Register right = side(*binary.right);
  const int left_step = binary.left->type.numeric() ? 0 : 1;
  const int right_step = binary.right->type.numeric() ? 0 : 1;
  const int parts = slots_of(expression.type).numbers;
  for (int i = 0; i < parts; ++i) {
    code_.emit(real_opcode(binary.op), expression.place, behind(target, i),
               behind(left, i * left_step), behind(right, i * right_step));
  }
}

/// p + v, p - v, p - q, p * q, p * v.
void ExpressionCompiler::compile_on_poses(const Binary& binary, const Expr& expression,
                                          Register target) {
  const Register left = operand_before(*binary.right, *binary.left, false);
  const Register right = operand(*binary.right, false);
  if (binary.op == BinaryOp::Multiply) {
    const Opcode op = binary.right->type.is_place() ? Opcode::pose_product : Opcode::pose_transform;
    code_.emit(op, expression.place, target, left, right);
    return;
  }
  const Opcode op = binary.op == BinaryOp::Add ? Opcode::add_real : Opcode::sub_real;
  for (int i = 0; i < kVecParts; ++i) {
    code_.emit(op, expression.place, behind(target, i), behind(left, i), behind(right, i));
  }
  if (binary.right->type.is_place()) return;
  variables_.copy_registers(behind(target, kVecParts), behind(left, kVecParts),
                            kPoseSlots - kVecParts, expression.place);
}

// Poses, VECs and JOINTS

/// Into registers of its own first: a component may be computed from what lies in the target.
void ExpressionCompiler::compile(const Tuple& tuple, Register target) {
  const Register first = frame_.number_registers(kVecParts);
  for (int i = 0; i < kVecParts; ++i) {
    into(*tuple.elements[static_cast<std::size_t>(i)].value, behind(first, i), true);
  }
  variables_.copy_registers(target, first, kVecParts, tuple.elements.front().place);
}

/// A pose in a FRAME, which is a constant, where one in the world is wanted.
void ExpressionCompiler::into_world(const Expr& expression, Register target) {
  const Register frame = frame_.number_registers(kPoseSlots);
  const Register pose = frame_.number_registers(kPoseSlots);
  Register next = frame;
  for (const double part : std::get<std::vector<double>>(expression.moved_from->value)) {
    code_.load_real(next++, part, kNone, expression.place);
  }
  into_as_it_is(expression, pose, false);
  code_.emit(Opcode::pose_product, expression.place, target, frame, pose);
}

/// A TOOL where a pose is wanted; or a pose as a TOOL, which weighs nothing.
void ExpressionCompiler::into_other_place(const Expr& expression, Register target) {
  const int own = slots_of(expression.type).numbers;
  const int wanted = expression.place_slots;
  const Register value = frame_.number_registers(own);
  if (expression.moved_from != nullptr) {
    into_world(expression, value);
  } else {
    into_as_it_is(expression, value, false);
  }
  variables_.copy_registers(target, value, std::min(own, wanted), expression.place);
  for (int i = own; i < wanted; ++i) {
    code_.load_real(behind(target, i), 0, kNone, expression.place);
  }
}

/// JOINTS(q1, …, qn), into registers of its own first, as a tuple; or JOINTS of a pose.
void ExpressionCompiler::compile_joints(const Call& call, const Expr& expression, Register target) {
  const int count = slots_of(expression.type).numbers;
  const Expr& first = *call.arguments.front();
  if (first.type.is_place()) {
    const Expr& last = *call.arguments.back();
    const Register pose = operand_before(last, first, false);
    const Register near = &last == &first ? pose : operand(last, false);
    code_.emit(Opcode::inverse, expression.place, target, pose, near);
    return code_.emit(number_word(count), expression.place);
  }
  const Register values = frame_.number_registers(count);
  Register next = values;
  for (const ExprPtr& value : call.arguments) into(*value, next++, true);
  variables_.copy_registers(target, values, count, expression.place);
}

// Calls

void ExpressionCompiler::compile(const Call& call, const Expr& expression, Register target) {
  if (call.routine != nullptr) {
    const Location result = call_routine(call, expression);
    return variables_.load(result, expression.type, target, expression.place);
  }
  const Builtin& builtin = *find_builtin(call);
  if (builtin.rule == BuiltinRule::AnyToText) {
    const Register text = frame_.text_register();
    code_.load_text(text, "", expression.place);
    append(*call.arguments.front(), text);
    code_.emit(Opcode::take_text, expression.place, target, text);
    return;
  }
  if (reading_of(call) == Reading::Now) return world_.now(builtin, target, expression.place);
  if (builtin.rule == BuiltinRule::AnyToCsv) return compile_csv(call, target, expression.place);
  if (builtin.rule == BuiltinRule::FileExists) {
    const Register file = operand(*call.arguments.front(), false);
    return world_.look_for_file(file, target, expression.place);
  }
  if (const auto reading = reading_of(call)) return world_.read(*reading, target, expression.place);
  if (builtin.rule == BuiltinRule::Joints) return compile_joints(call, expression, target);
  if (builtin.rule == BuiltinRule::Forward) {
    const Expr& joints = *call.arguments.front();
    return code_.emit(Opcode::forward, expression.place, target, operand(joints, false),
                      static_cast<unsigned>(slots_of(joints.type).numbers));
  }
  if (builtin.rule == BuiltinRule::ArrayLength) {
    const Expr& array = *call.arguments.front();
    return variables_.count(locate(array), array.type, target, expression.place);
  }
  if (builtin.rule == BuiltinRule::Ordinal) {
    const Register value = operand(*call.arguments.front(), false);
    code_.load_integer(target, 1, expression.place);
    return code_.emit(Opcode::add_int, expression.place, target, value, target);
  }
  if (builtin.rule == BuiltinRule::Join) {
    const Register between = operand(*call.arguments[1], false);
    const Register parts = row(*call.arguments[0]);
    return code_.emit(Opcode::join_row, expression.place, target, parts, between);
  }
  if (builtin.rule == BuiltinRule::RowNumber) {
    return compute_from_row(code_, builtin, call.arguments.front()->type.detail->element,
                            row(*call.arguments.front()), target, expression.place);
  }
  if (builtin.rule == BuiltinRule::Random) return draw(call, expression, target);
  if (look_into_text(code_, *this, builtin, call, target, expression.place)) return;
  if (builtin.rule == BuiltinRule::Texts) return call_on_texts(builtin, call, expression, target);
  call_on_numbers(builtin, call, expression, target);
}

/// A field, or several of a compound value, for each argument.
void ExpressionCompiler::compile_csv(const Call& call, Register target, Place place) {
  const Register text = frame_.text_register();
  code_.load_text(text, "", place);
  for (const ExprPtr& argument : call.arguments) {
    const auto mark = frame_.mark();
    if (argument != call.arguments.front()) {
      const Register comma = frame_.text_register();
      code_.load_text(comma, ",", place);
      code_.emit(Opcode::append_text, place, text, comma);
    }
    const Register places = frame_.number_registers(2);
    variables_.refer_both(locate(*argument), argument->type, places, behind(places, 1), place);
    code_.append_memory(Opcode::append_csv, text, places, argument->type, place);
    frame_.release(mark);
  }
  code_.emit(Opcode::take_text, place, target, text);
}

/// Values lie side by side; the result takes their place.
void ExpressionCompiler::call_on_numbers(const Builtin& builtin, const Call& call,
                                         const Expr& expression, Register target) {
  const bool whole = computes_whole(builtin, call);
  int given = 0;
  for (const ExprPtr& argument : call.arguments) given += numbers_of(*argument);
  const int results = slots_of(expression.type).numbers;
  const Register first = frame_.number_registers(std::max(given, results));
  Register next = first;
  for (const ExprPtr& argument : call.arguments) {
    into(*argument, next, !whole);
    next = static_cast<Register>(next + numbers_of(*argument));
  }
  const auto index = static_cast<unsigned>(&builtin - builtins().data());
  code_.emit(whole ? Opcode::call_int : Opcode::call_real, expression.place, first, index,
             static_cast<unsigned>(given));
  variables_.copy_registers(target, first, results, expression.place);
}

Register ExpressionCompiler::row(const Expr& expression) {
  const Location at = locate(expression);
  if (expression.type.is(Type::Kind::List)) return variables_.list_row(at, expression.place);
  const Register first = variables_.row_at(at, slots_of(expression.type), expression.place);
  variables_.count(at, expression.type, behind(first, 2), expression.place);
  return first;
}

/// SORT, and what changes a LIST; the value, or the index, is computed first.
void ExpressionCompiler::call_procedure(const Call& call, Place place) {
  const Expr& changed = *call.arguments.front();
  const BuiltinRule rule = find_builtin(call)->rule;
  if (rule != BuiltinRule::RowSort) return change_list(rule, call, place);
  const Type& element = changed.type.detail->element;
  const Register first = row(changed);
  const Opcode sort = element.text()                ? Opcode::sort_texts
                      : element.is(Type::Kind::Int) ? Opcode::sort_ints
                                                    : Opcode::sort_reals;
  code_.emit(sort, place, first);
}

void ExpressionCompiler::change_list(BuiltinRule rule, const Call& call, Place place) {
  const Expr& list = *call.arguments.front();
  const Expr& last = *call.arguments.back();
  const Type& element = list.type.detail->element;
  Register value = 0;
  if (rule == BuiltinRule::ListRemove) {
    value = operand(last, false);
    code_.emit(Opcode::check_index, last.place, value,
               behind(variables_.list_row(locate(list), place), 2));
  } else if (rule == BuiltinRule::ListAppend) {
    const Location fresh = variables_.temporary(element, place);
    put(last, fresh, element);
    value = variables_.row_at(fresh, slots_of(element), place);
  }
  const Register home = frame_.number_registers();
  variables_.refer(locate(list).numbers, false, home, place);
  if (rule == BuiltinRule::ListAppend) {
    code_.emit(Opcode::append_list, place, home, value, behind(value, 1));
  } else if (rule == BuiltinRule::ListRemove) {
    code_.emit(Opcode::remove_list, place, home, value);
  } else {
    code_.emit(Opcode::clear_list, place, home);
  }
}

void ExpressionCompiler::draw(const Call& call, const Expr& expression, Register target) {
  code_.depends_on_time();  // each look draws anew
  if (call.arguments.empty()) {
    code_.emit(Opcode::random, expression.place, target);
    return;
  }
  const bool whole = expression.type == Type::integer();
  const Register bounds = frame_.number_registers(2);
  into(*call.arguments[0], bounds, !whole);
  into(*call.arguments[1], static_cast<Register>(bounds + 1), !whole);
  code_.emit(whole ? Opcode::random_int : Opcode::random_real, expression.place, bounds);
  code_.emit(Opcode::copy, expression.place, target, bounds);
}

/// Numbers and texts lie apart, each in order; the result takes the place of the first of its kind.
void ExpressionCompiler::call_on_texts(const Builtin& builtin, const Call& call,
                                       const Expr& expression, Register target) {
  const std::string_view parameters = builtin.signature.parameters;
  const auto count = static_cast<int>(parameters.size());
  const Register numbers = frame_.number_registers(count);
  const Register texts = frame_.text_registers(count);
  Register next = numbers;
  Register next_text = texts;
  for (std::size_t i = 0; i < parameters.size(); ++i) {
    into(*call.arguments[i], parameters[i] == 'S' ? next_text++ : next++, parameters[i] == 'Q');
  }
  const auto index = static_cast<unsigned>(&builtin - builtins().data());
  code_.emit(Opcode::call_text, expression.place, numbers, texts, index);
  code_.emit(expression.type.text() ? Opcode::take_text : Opcode::copy, expression.place, target,
             expression.type.text() ? texts : numbers);
}

namespace {

/// PERSIST variables that REF parameters stand for while the routine runs.
void lend(Variables& variables, const Call& call, CodeBuilder::Persist how) {
  const std::vector<Parameter> parameters = parameters_of(*call.routine);
  for (std::size_t i = 0; i < call.bound.size(); ++i) {
    if (call.bound[i] == nullptr || !parameters[i].group->by_reference) continue;
    variables.changed(*root_of(*call.bound[i])->symbol, call.bound[i]->place, how);
  }
}

void refer_parameter(Variables& variables, const Location& at, const Type& type,
                     const Location& home, Register first, Place place) {
  variables.refer_both(at, type, static_cast<Register>(first + home.numbers.place),
                       static_cast<Register>(first + home.texts.place), place);
}

}  // namespace

/// The arguments lie where the routine's registers will begin, and there its value is left. All
/// that the caller still needs lies below.
Location ExpressionCompiler::call_routine(const Call& call, const Expr& expression) {
  const Type& type = call.routine->result;
  const CallLayout layout = layout_of(*call.routine);
  Location result;
  if (!type.in_registers()) result = variables_.temporary(type, expression.place);
  const Register first = frame_.number_registers(layout.registers);
  const Register first_text = frame_.text_registers(layout.text_registers);
  int held = 0;
  for (std::size_t i = 0; i < layout.homes.size(); ++i) {
    held += pass(call, i, layout.homes[i], first, first_text);
  }
  if (!type.in_registers()) {
    refer_parameter(variables_, result, type, layout.result, first, expression.place);
  }
  lend(variables_, call, CodeBuilder::Persist::Lent);
  code_.call(call.routine->index, first, first_text, expression.place);
  lend(variables_, call, CodeBuilder::Persist::Back);
  if (held > 0) code_.emit(Opcode::release_lists, expression.place, static_cast<unsigned>(held));
  world_.begin_again(expression.place);
  if (type.in_registers()) result = {{.offset = first}, {.offset = first_text}};
  return result;
}

/// Gives a parameter its value, which will lie at `home` in the routine's frame.
int ExpressionCompiler::pass(const Call& call, std::size_t parameter, const Location& home,
                             Register first, Register first_text) {
  const Routine::Parameters& group = *parameters_of(*call.routine)[parameter].group;
  const Expr& argument = call.bound[parameter] != nullptr ? *call.bound[parameter] : *group.value;
  if (group.by_reference) {
    const auto mark = frame_.mark();
    const bool list_as_array = group.type.is_open() && argument.type.is(Type::Kind::List);
    Location at = locate(argument);
    if (list_as_array) {
      const Register row = variables_.list_row(at, argument.place);
      at = {{SlotsAt::Base::Place, 0, row},
            {SlotsAt::Base::Place, 0, behind(row, 1)},
            behind(row, 2)};
    }
    refer_parameter(variables_, at, group.type, home, first, argument.place);
    if (group.type.is_open()) {
      const Type& type = list_as_array ? group.type : argument.type;
      variables_.count(at, type, behind(first, home.count), argument.place);
    }
    const int held = hold_list(code_, variables_, argument, list_as_array);
    frame_.release(mark);
    return held;
  } else if (!group.type.in_registers()) {
    // A routine that a later argument calls may change the variable, so its value is kept.
    const bool keep = std::any_of(
        call.bound.begin() + static_cast<std::ptrdiff_t>(parameter) + 1, call.bound.end(),
        [](const Expr* later) { return later != nullptr && calls_routine(*later); });
    refer_parameter(variables_, located_as(argument, group.type, keep), group.type, home, first,
                    argument.place);
  } else if (group.type.text()) {
    into(argument, static_cast<Register>(first_text + home.texts.offset), false);
  } else {
    into(argument, static_cast<Register>(first + home.numbers.offset),
         group.type.is(Type::Kind::Real));
  }
  return 0;
}

// Arrays, records, and parts of variables

Location ExpressionCompiler::locate(const Expr& expression) {
  if (const Location* const fixed = variables_.fixed_part(expression)) return *fixed;
  if (!known(expression.constant)) {
    if (const auto* const name = std::get_if<Name>(&expression.node)) {
      if (variables_.has_home(*name->symbol)) {
        return variables_.reached(variables_.home(*name->symbol), expression.type,
                                  expression.place);
      }
    }
    if (const auto* const member = std::get_if<Member>(&expression.node)) {
      const auto field = field_of(member->object->type, member->field);
      if (field) return locate(*member->object).behind(field->offset);
    }
    if (const auto* const index = std::get_if<Index>(&expression.node)) return element(*index);
  }
  if (const auto* const call = std::get_if<Call>(&expression.node);
      call != nullptr && call->routine != nullptr && !expression.type.in_registers()) {
    return call_routine(*call, expression);
  }
  const Location fresh = variables_.temporary(expression.type, expression.place);
  if (!expression.type.in_registers()) {
    put(expression, fresh, expression.type);
    return fresh;
  }
  into(expression, expression.type.text() ? fresh.texts.reg() : fresh.numbers.reg(), false);
  return fresh;
}

/// Where a value lies that a type is wanted of: lists take it.
Location ExpressionCompiler::located_as(const Expr& expression, const Type& type, bool keep) {
  if (variables_.is_variable(expression) && !keep) return locate(expression);
  const Location fresh = variables_.temporary(type, expression.place);
  put(expression, fresh, type);
  return fresh;
}

Location ExpressionCompiler::element(const Index& index) {
  const Elements elements = *elements_of(index.object->type);
  const Slots size = slots_of(elements.type);
  const Location whole = locate(*index.object);
  if (const auto* const number = std::get_if<std::int64_t>(&index.index->constant);
      number != nullptr && elements.count != kAnyLength) {
    const int before = static_cast<int>(*number) - 1;
    return whole.behind({before * size.numbers, before * size.texts});
  }
  const Register which = operand(*index.index, false);
  return variables_.element(whole, which, elements, index.index->place);
}

void ExpressionCompiler::load_element(const Index& index, Register target, Place place) {
  const auto mark = frame_.mark();
  const SlotsAt whole = locate(*index.object).numbers;
  const Register which = operand(*index.index, false);
  if (code_.last_element().join(Opcode::load_cell, target, whole.place, whole.offset)) {
    code_.emit(number_word(which), place);
  } else {
    code_.emit(Opcode::load_element, place, target, which, whole.place);
    code_.emit(number_word(whole.offset), place);
  }
  code_.emit(number_word(index.object->type.detail->length), place);
  frame_.release(mark);
}

void ExpressionCompiler::store_element(Opcode opcode, const Index& index, std::uint8_t value,
                                       Place place) {
  const SlotsAt whole = locate(*index.object).numbers;
  const Register which = operand(*index.index, false);
  if (opcode == Opcode::store_element &&
      code_.last_element().join(Opcode::store_cell, value, whole.place, whole.offset)) {
    code_.emit(number_word(which), place);
  } else {
    code_.emit(opcode, place, value, which, whole.place);
    code_.emit(number_word(whole.offset), place);
  }
  code_.emit(number_word(index.object->type.detail->length), place);
}

bool ExpressionCompiler::assign_constant_element(const Expr& target, const Expr& value) {
  if (!variables_.is_number_element(target) || root_of(target)->symbol->shared) return false;
  const auto constant = constant_operand(code_, value, target.type.is(Type::Kind::Real));
  if (!constant) return false;
  begin_place(target);
  store_element(Opcode::store_element_constant, std::get<Index>(target.node), *constant,
                target.place);
  variables_.changed(*root_of(target)->symbol, target.place);
  return true;
}

void ExpressionCompiler::put(const Expr& value, const Location& to, const Type& type) {
  const auto mark = frame_.mark();
  const Place place = value.place;
  if (type.in_registers()) {
    const SlotsAt& part = type.text() ? to.texts : to.numbers;
    const bool as_real = type.is(Type::Kind::Real);
    if (part.in_register()) {
      into(value, part.reg(), as_real);
    } else {
      variables_.store(to, type, operand(value, as_real), place);
    }
  } else if (type.is(Type::Kind::List)) {
    put_list(value, to, type);
  } else if (const auto* const list = std::get_if<List>(&value.node)) {
    const Type& element = type.detail->element;
    Location next = to;
    for (const ExprPtr& each : list->elements) {
      put(*each, next, element);
      next = next.behind(slots_of(element));
    }
  } else if (const auto* const call = std::get_if<Call>(&value.node);
             call != nullptr && call->record != nullptr) {
    put_record(*call, to, place);
  } else {
    variables_.copy_memory(to, locate(value), slots_of(type), place);
  }
  frame_.release(mark);
}

/// Into a LIST. The elements of a literal are gathered in memory first.
void ExpressionCompiler::put_list(const Expr& value, const Location& to, const Type& type) {
  const Place place = value.place;
  const auto* const list = std::get_if<List>(&value.node);
  const auto* const call = std::get_if<Call>(&value.node);
  if (list == nullptr && (call == nullptr || call->routine != nullptr)) {
    return variables_.fill_list(to, locate(value), place);
  }
  const Register home = frame_.number_registers();
  variables_.refer(to.numbers, false, home, place);
  if (list == nullptr) {  // SPLIT
    const Register text = operand_before(*call->arguments[1], *call->arguments[0], false);
    const Register between = operand(*call->arguments[1], false);
    return code_.emit(Opcode::split_text, place, home, text, between);
  }
  const Type& element = type.detail->element;
  const auto count = static_cast<int>(list->elements.size());
  const Slots size = slots_of(element);
  Location at = variables_.memory({size.numbers * count, size.texts * count}, place);
  const Register row = variables_.row_at(at, size, place);
  code_.load_integer(behind(row, 2), count, place);
  for (const ExprPtr& each : list->elements) {
    put(*each, at, element);
    at = at.behind(size);
  }
  code_.emit(Opcode::fill_list, place, home, row);
}

void ExpressionCompiler::put_record(const Call& call, const Location& to, Place place) {
  Location next = to;
  for (std::size_t i = 0; i < call.bound.size(); ++i) {
    const Type& type = call.record->fields[i].type;
    if (call.bound[i] != nullptr) {
      put(*call.bound[i], next, type);
    } else {
      variables_.clear(next, type, place);
    }
    next = next.behind(slots_of(type));
  }
}

/// A whole array or record. One that is built of parts may use the old value, so it is built apart.
void ExpressionCompiler::assign_memory(const Expr& target, const Expr& value) {
  Location from;
  begin(value);
  if (variables_.is_variable(value) && !calls_routine(target)) {
    from = locate(value);
  } else {
    from = variables_.temporary(target.type, value.place);
    put(value, from, target.type);
  }
  begin_place(target);
  const Location to = locate(target);
  variables_.copy(from, to, target.type, target.place);
  const Symbol& root = *root_of(target)->symbol;
  variables_.publish_part(root, to, target.type, target.place);
  variables_.changed(root, target.place);
}

}  // namespace rob::lang
