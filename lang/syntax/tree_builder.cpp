#include "lang/syntax/tree_builder.h"

#include <memory>
#include <utility>

#include <fmt/format.h>

#include "lang/syntax/syntax_limits.h"
#include "lang/text/codes.h"

namespace rob::lang {

ExprPtr TreeBuilder::make(const Place& place, decltype(Expr::node) node, int height) {
  count(place);
  if (height > kMaxDepth) fail_too_deep(place);
  ExprPtr expr = stand_in(place, std::move(node));
  expr->height = height;
  return expr;
}

ExprPtr TreeBuilder::stand_in(const Place& place, decltype(Expr::node) node) {
  auto expr = std::make_unique<Expr>();
  expr->place = place;
  expr->node = std::move(node);
  return expr;
}

namespace {

/// Copies the node of a tree, and its parts by `part`.
template <typename Part>
struct NodeCopy {
  using Node = decltype(Expr::node);
  const Part& part;

  Node operator()(const Name& name) const { return Name{name.text, nullptr, part(name.index)}; }
  Node operator()(const Unary& unary) const { return Unary{unary.op, part(unary.operand)}; }
  Node operator()(const Binary& binary) const {
    return Binary{binary.op, part(binary.left), part(binary.right)};
  }
  Node operator()(const Call& call) const {
    Call copy{.callee = call.callee, .arguments = {}, .names = call.names};
    for (const ExprPtr& argument : call.arguments) copy.arguments.push_back(part(argument));
    return copy;
  }
  Node operator()(const Tuple& tuple) const {
    Tuple copy;
    for (const Tuple::Element& element : tuple.elements) {
      copy.elements.push_back({element.name, part(element.value), element.place});
    }
    return copy;
  }
  Node operator()(const Member& member) const {
    return Member{part(member.object), member.field, member.field_place};
  }
  Node operator()(const Index& index) const { return Index{part(index.object), part(index.index)}; }
  Node operator()(const List& list) const {
    List copy;
    for (const ExprPtr& element : list.elements) copy.elements.push_back(part(element));
    return copy;
  }
  Node operator()(const Chain& chain) const {
    Chain copy{part(chain.first), {}};
    for (const Chain::Step& step : chain.steps) {
      copy.steps.push_back({step.op, step.place, part(step.term)});
    }
    return copy;
  }
  Node operator()(const auto& literal) const { return literal; }
};

}  // namespace

ExprPtr TreeBuilder::copy(const Expr& expression) {
  const auto part = [this](const ExprPtr& one) { return one ? copy(*one) : nullptr; };
  return make(expression.place, std::visit(NodeCopy<decltype(part)>{part}, expression.node),
              expression.height);
}

void TreeBuilder::add(Block& block, const Place& place, decltype(Statement::node) node) {
  count(place);
  block.push_back({place, std::move(node)});
}

void TreeBuilder::count(const Place& place) {
  if (++nodes_ <= kMaxNodes) return;
  tokens_.report(
      code::kProgramTooLarge, place,
      fmt::format("the program is too large: more than {} statements and values", kMaxNodes));
  throw GiveUp{};
}

TreeBuilder::Level::Level(TreeBuilder& tree) : tree_(tree) {
  if (tree.level_ >= kMaxDepth) tree.fail_too_deep(tree.tokens_.place());
  ++tree.level_;
}

void TreeBuilder::fail_too_deep(const Place& place) {
  tokens_.fail(code::kTooDeep, place,
               fmt::format("the expression is nested too deep: at most {} levels", kMaxDepth),
               "compute parts of it before, in variables");
}

}  // namespace rob::lang
