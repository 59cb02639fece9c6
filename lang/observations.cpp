#include "lang/observations.h"

#include "lang/fold.h"
#include "lang/symbols.h"

namespace rob::lang {

int observations(const Expr& expression) {
  struct Counter {
    int operator()(const Name& name) const {
      // A name that is not known is reported already; it may have been meant for a signal.
      if (name.symbol == nullptr || name.symbol->kind == Symbol::Kind::Signal) return 1;
      const bool reading = name.symbol->kind == Symbol::Kind::Reading;
      return reading && is_observation(name.symbol->reading) ? 1 : 0;
    }
    int operator()(const Unary& unary) const { return observations(*unary.operand); }
    int operator()(const Binary& binary) const {
      return observations(*binary.left) + observations(*binary.right);
    }
    int operator()(const Call& call) const {
      int sum = 0;
      for (const ExprPtr& argument : call.arguments) sum += observations(*argument);
      return sum;
    }
    int operator()(const NumberLiteral&) const { return 0; }
    int operator()(const BoolLiteral&) const { return 0; }
    int operator()(const StringLiteral&) const { return 0; }
    int operator()(const Tuple& tuple) const {
      int sum = 0;
      for (const Tuple::Element& element : tuple.elements) {
        if (element.value != nullptr) sum += observations(*element.value);
      }
      return sum;
    }
    int operator()(const List& list) const {
      int sum = 0;
      for (const ExprPtr& element : list.elements) sum += observations(*element);
      return sum;
    }
    int operator()(const Member& member) const { return observations(*member.object); }
    int operator()(const Index& index) const {
      return observations(*index.object) + observations(*index.index);
    }
  };
  if (known(expression.constant)) return 0;
  return std::visit(Counter{}, expression.node);
}

}  // namespace rob::lang
