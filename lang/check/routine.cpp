#include "lang/check/routine.h"

#include <algorithm>

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

}  // namespace rob::lang
