#include "lang/observations.h"

#include <algorithm>

#include "lang/fold.h"
#include "lang/symbols.h"

namespace rob::lang {

namespace {

/// Calls `visit` for each name in an expression; what is constant is not looked at.
template <typename Visit>
void each_name(const Expr& expression, const Visit& visit);

template <typename Visit>
struct Names {
  const Visit& visit;

  void go(const ExprPtr& part) const {
    if (part != nullptr) each_name(*part, visit);
  }
  void operator()(const Name& name) const { visit(name); }
  void operator()(const Unary& unary) const { go(unary.operand); }
  void operator()(const Binary& binary) const {
    go(binary.left);
    go(binary.right);
  }
  void operator()(const Call& call) const {
    for (const ExprPtr& argument : call.arguments) go(argument);
  }
  void operator()(const Tuple& tuple) const {
    for (const Tuple::Element& element : tuple.elements) go(element.value);
  }
  void operator()(const Member& member) const { go(member.object); }
  void operator()(const Index& index) const {
    go(index.object);
    go(index.index);
  }
  void operator()(const auto& /*literal*/) const {}
};

template <typename Visit>
void each_name(const Expr& expression, const Visit& visit) {
  if (!known(expression.constant)) std::visit(Names<Visit>{visit}, expression.node);
}

bool is_observed(const Name& name) {
  // A name that is not known is reported already; it may have been meant for a signal.
  if (name.symbol == nullptr || name.symbol->kind == Symbol::Kind::Signal) return true;
  const bool reading = name.symbol->kind == Symbol::Kind::Reading;
  return name.symbol->observed || (reading && is_observation(name.symbol->reading));
}

}  // namespace

int observations(const Expr& expression) {
  int count = 0;
  each_name(expression, [&](const Name& name) { count += is_observed(name) ? 1 : 0; });
  return count;
}

std::vector<const Symbol*> observed_globals(const Expr& expression) {
  std::vector<const Symbol*> found;
  each_name(expression, [&](const Name& name) {
    const bool is_new = std::ranges::find(found, name.symbol) == found.end();
    if (name.symbol != nullptr && name.symbol->observed && is_new) found.push_back(name.symbol);
  });
  return found;
}

bool reads_global(const Expr& expression) {
  bool found = false;
  each_name(expression, [&](const Name& name) {
    const Symbol* const symbol = name.symbol;
    found =
        found || (symbol != nullptr && symbol->global && symbol->kind == Symbol::Kind::Variable);
  });
  return found;
}

}  // namespace rob::lang
