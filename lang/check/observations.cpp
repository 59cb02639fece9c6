#include "lang/check/observations.h"

#include <algorithm>

#include "lang/check/fold.h"
#include "lang/check/symbols.h"
#include "lang/text/ascii.h"

namespace rob::lang {

std::optional<Reading> reading_of(const Call& call) {
  if (call.routine != nullptr || !call.arguments.empty()) return std::nullopt;
  if (same_word(call.callee, "JOINTS")) return Reading::Joints;
  if (same_word(call.callee, "WRENCH")) return Reading::Wrench;
  return std::nullopt;
}

namespace {

/// Calls `visit` for each name and each call in an expression; what is constant is not looked at.
template <typename Visit>
void each_use(const Expr& expression, const Visit& visit);

template <typename Visit>
struct Uses {
  const Visit& visit;

  void go(const ExprPtr& part) const {
    if (part != nullptr) each_use(*part, visit);
  }
  void operator()(const Name& name) const { visit(name); }
  void operator()(const Unary& unary) const { go(unary.operand); }
  void operator()(const Binary& binary) const {
    go(binary.left);
    go(binary.right);
  }
  void operator()(const Call& call) const {
    visit(call);
    for (const ExprPtr& argument : call.arguments) go(argument);
  }
  void operator()(const Tuple& tuple) const {
    for (const Tuple::Element& element : tuple.elements) go(element.value);
  }
  void operator()(const List& list) const {
    for (const ExprPtr& element : list.elements) go(element);
  }
  void operator()(const Member& member) const { go(member.object); }
  void operator()(const Index& index) const {
    go(index.object);
    go(index.index);
  }
  void operator()(const NumberLiteral& /*literal*/) const {}
  void operator()(const BoolLiteral& /*literal*/) const {}
  void operator()(const StringLiteral& /*literal*/) const {}
};

template <typename Visit>
void each_use(const Expr& expression, const Visit& visit) {
  if (!known(expression.constant)) std::visit(Uses<Visit>{visit}, expression.node);
}

bool is_observed(const Name& name) {
  // A name that is not known is reported already; it may have been meant for a signal.
  if (name.symbol == nullptr || name.symbol->kind == Symbol::Kind::Signal) return true;
  const bool reading = name.symbol->kind == Symbol::Kind::Reading;
  return name.symbol->observed || (reading && is_observation(name.symbol->reading));
}
bool is_observed(const Call& call) { return reading_of(call).has_value(); }

const Symbol* symbol_of(const Name& name) { return name.symbol; }
const Symbol* symbol_of(const Call& /*call*/) { return nullptr; }

}  // namespace

int observations(const Expr& expression) {
  int count = 0;
  each_use(expression, [&](const auto& use) { count += is_observed(use) ? 1 : 0; });
  return count;
}

std::vector<const Symbol*> observed_globals(const Expr& expression) {
  std::vector<const Symbol*> found;
  each_use(expression, [&](const auto& use) {
    const Symbol* const symbol = symbol_of(use);
    const bool is_new = std::ranges::find(found, symbol) == found.end();
    if (symbol != nullptr && symbol->observed && is_new) found.push_back(symbol);
  });
  return found;
}

bool reads_global(const Expr& expression) {
  bool found = false;
  each_use(expression, [&](const auto& use) {
    const Symbol* const symbol = symbol_of(use);
    found =
        found || (symbol != nullptr && symbol->global && symbol->kind == Symbol::Kind::Variable);
  });
  return found;
}

}  // namespace rob::lang
