#pragma once

#include <cstddef>

#include "lang/syntax/ast.h"
#include "lang/syntax/token_reader.h"

namespace rob::lang {

/// Makes the nodes of a tree, and bounds their number and the height of the tree (syntax_limits.h).
class TreeBuilder {
 public:
  /// `nodes`: of the files that were read before.
  TreeBuilder(TokenReader& tokens, std::size_t nodes) : tokens_(tokens), nodes_(nodes) {}

  ExprPtr make(const Place& place, decltype(Expr::node) node, int height = 1);
  /// A tree that has not been checked, once more.
  ExprPtr copy(const Expr& expression);
  void add(Block& block, const Place& place, decltype(Statement::node) node);
  /// Counts what is neither of the two as one.
  void count(const Place& place);
  std::size_t nodes() const { return nodes_; }

  /// Stands in for a value that could not be read and has been reported; it does not count.
  static ExprPtr stand_in(const Place& place, decltype(Expr::node) node);

  /// Bounds the recursion of the parser: one level a bracket, sign or block.
  class Level {
   public:
    explicit Level(TreeBuilder& tree);
    ~Level() { --tree_.level_; }
    Level(const Level&) = delete;
    Level& operator=(const Level&) = delete;

   private:
    TreeBuilder& tree_;
  };

 private:
  [[noreturn]] void fail_too_deep(const Place& place);

  TokenReader& tokens_;
  std::size_t nodes_;
  int level_ = 0;
};

}  // namespace rob::lang
