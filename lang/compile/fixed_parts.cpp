#include "lang/compile/fixed_parts.h"

#include <algorithm>

#include "lang/check/fold.h"
#include "lang/check/symbols.h"

namespace rob::lang {
namespace {

bool is_read(const Symbol& symbol) {
  return symbol.kind == Symbol::Kind::Signal ||
         (symbol.kind == Symbol::Kind::Reading && is_observation(symbol.reading));
}

bool is_part_of_variable(const Expr& expression) {
  if (const auto* const member = std::get_if<Member>(&expression.node)) {
    if (!member->object->type.is(Type::Kind::Record)) return false;
  } else if (!std::holds_alternative<Index>(expression.node)) {
    return false;
  }
  const Name* const root = root_of(expression);
  return root != nullptr && !is_read(*root->symbol);
}

bool is_among(const std::vector<const Expr*>& parts, const Symbol* symbol) {
  return std::ranges::any_of(parts, [&](const Expr* part) {
    const auto* const name = std::get_if<Name>(&part->node);
    return name != nullptr && name->symbol == symbol;
  });
}

void gather(const Expr& expression, std::vector<const Expr*>& parts) {
  if (known(expression.constant)) return;
  if (const auto* const name = std::get_if<Name>(&expression.node)) {
    const bool fixed = !is_read(*name->symbol) && !known(name->symbol->value);
    if (fixed && !is_among(parts, name->symbol)) parts.push_back(&expression);
  } else if (is_part_of_variable(expression)) {
    parts.push_back(&expression);
  } else if (const auto* const unary = std::get_if<Unary>(&expression.node)) {
    gather(*unary->operand, parts);
  } else if (const auto* const binary = std::get_if<Binary>(&expression.node)) {
    gather(*binary->left, parts);
    gather(*binary->right, parts);
  } else if (const auto* const call = std::get_if<Call>(&expression.node)) {
    for (const ExprPtr& argument : call->arguments) gather(*argument, parts);
  } else if (const auto* const tuple = std::get_if<Tuple>(&expression.node)) {
    for (const Tuple::Element& element : tuple->elements) gather(*element.value, parts);
  } else if (const auto* const member = std::get_if<Member>(&expression.node)) {
    gather(*member->object, parts);
  } else if (const auto* const index = std::get_if<Index>(&expression.node)) {
    gather(*index->object, parts);
  }
}

}  // namespace

std::vector<const Expr*> fixed_parts_of(const Expr& condition) {
  std::vector<const Expr*> parts;
  gather(condition, parts);
  return parts;
}

}  // namespace rob::lang
