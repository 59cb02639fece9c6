#include <algorithm>

#include "lang/check/routine.h"
#include "lang/compile/expression_compiler.h"

/// Member functions of ExpressionCompiler for calls of routines, and for variables that are not in
/// the current frame.
namespace rob::lang {

bool calls_routine(const Expr& expression) {
  struct Visitor {
    bool operator()(const Unary& unary) const { return calls_routine(*unary.operand); }
    bool operator()(const Binary& binary) const {
      return calls_routine(*binary.left) || calls_routine(*binary.right);
    }
    bool operator()(const Call& call) const {
      return call.routine != nullptr ||
             std::ranges::any_of(call.arguments,
                                 [](const ExprPtr& argument) { return calls_routine(*argument); });
    }
    bool operator()(const NumberLiteral&) const { return false; }
    bool operator()(const BoolLiteral&) const { return false; }
    bool operator()(const StringLiteral&) const { return false; }
    bool operator()(const Name&) const { return false; }
    bool operator()(const Tuple& tuple) const {
      return std::ranges::any_of(tuple.elements, [](const Tuple::Element& element) {
        return element.value != nullptr && calls_routine(*element.value);
      });
    }
    bool operator()(const List& list) const {
      return std::ranges::any_of(list.elements,
                                 [](const ExprPtr& element) { return calls_routine(*element); });
    }
    bool operator()(const Member& member) const { return calls_routine(*member.object); }
    bool operator()(const Index& index) const {
      return calls_routine(*index.object) || calls_routine(*index.index);
    }
  };
  return std::visit(Visitor{}, expression.node);
}

void ExpressionCompiler::call(const Expr& expression) {
  begin(expression);
  const auto mark = code_.mark();
  call_routine(std::get<Call>(expression.node), expression);
  code_.release(mark);
}

/// The arguments lie where the routine's registers will begin, and there its value is left. All
/// that the caller still needs lies below.
Location ExpressionCompiler::call_routine(const Call& call, const Expr& expression) {
  const Type& type = call.routine->result;
  const CallLayout layout = layout_of(*call.routine);
  const auto parameters = parameters_of(*call.routine);
  Location result;
  if (!type.in_registers()) result = memory(slots_of(type), expression.place);
  const Register first = code_.number_registers(layout.registers);
  const Register first_text = code_.text_registers(layout.text_registers);
  for (std::size_t i = 0; i < parameters.size(); ++i) {
    const Routine::Parameters& group = *parameters[i].group;
    const Expr& argument = call.bound[i] != nullptr ? *call.bound[i] : *group.value;
    const Location& home = layout.homes[i];
    if (group.by_reference) {
      const auto mark = code_.mark();
      pass_places(locate(argument), group.type, home, first, argument.place);
      code_.release(mark);
    } else if (!group.type.in_registers()) {
      // What a later argument calls may change the variable, so its value is kept.
      const bool keep =
          std::any_of(call.bound.begin() + static_cast<std::ptrdiff_t>(i) + 1, call.bound.end(),
                      [](const Expr* later) { return later != nullptr && calls_routine(*later); });
      pass_places(located_as(argument, group.type, keep), group.type, home, first, argument.place);
    } else if (group.type.text()) {
      into(argument, static_cast<Register>(first_text + home.texts.offset), false);
    } else {
      into(argument, static_cast<Register>(first + home.numbers.offset),
           group.type.kind == Type::Kind::Real);
    }
  }
  if (!type.in_registers()) pass_places(result, type, layout.result, first, expression.place);
  code_.call(call.routine->index, first, first_text, expression.place);
  // The routine's own observations come in between: what follows belongs to a new instant.
  if (latched_) code_.emit(Opcode::latch, expression.place);
  if (type.in_registers()) result = {{.offset = first}, {.offset = first_text}};
  return result;
}

/// Where the routine will look for them.
void ExpressionCompiler::pass_places(const Location& at, const Type& type, const Location& home,
                                     Register first, Place place) {
  const Slots slots = slots_of(type);
  if (slots.numbers > 0) {
    refer(at.numbers, false, static_cast<Register>(first + home.numbers.place), place);
  }
  if (slots.texts > 0) {
    refer(at.texts, true, static_cast<Register>(first + home.texts.place), place);
  }
}

}  // namespace rob::lang
