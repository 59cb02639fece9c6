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
