#pragma once

#include <string>
#include <string_view>

#include "lang/syntax/ast.h"
#include "lang/syntax/text_names.h"
#include "lang/syntax/token_reader.h"
#include "lang/syntax/tree_builder.h"

namespace rob::lang {

/// The rules for expressions, from the weakest binding to the strongest, for lists and for
/// channels.
class ExpressionParser {
 public:
  ExpressionParser(TokenReader& tokens, TreeBuilder& tree, TextNames& names)
      : tokens_(tokens), tree_(tree), names_(names) {}

  ExprPtr expression();
  ExprPtr postfix();
  ExprPtr primary();
  bool at_channel() const;
  /// `behind` is what stands before it, for the message.
  /// `last`: where the number of a group's last channel goes, DIN[1..8], if there may be one.
  Name channel(std::string_view behind, ExprPtr* last = nullptr);
  /// "(" element { "," element } ")" as a tuple, one element too; `what` is what they make up, for
  /// the message.
  ExprPtr tuple(std::string_view what);
  void close_bracket(std::string_view what);

  ExprPtr binary(BinaryOp op, const Place& place, ExprPtr left, ExprPtr right);

 private:
  ExprPtr conjunction();
  ExprPtr inversion();
  ExprPtr relation();
  ExprPtr sum();
  ExprPtr chain(ExprPtr first);
  ExprPtr term();
  ExprPtr unary();
  bool at_least_int() const;
  ExprPtr power();
  ExprPtr member(ExprPtr object);
  ExprPtr index(ExprPtr object);
  ExprPtr literal(decltype(Expr::node) node);
  ExprPtr list();
  ExprPtr parenthesized();
  ExprPtr tuple_of(const Place& place, Tuple elements);
  Tuple elements(std::string_view what);
  Tuple::Element element();
  ExprPtr call(const Place& place, std::string callee);
  [[noreturn]] void fail_value();

  TokenReader& tokens_;
  TreeBuilder& tree_;
  TextNames& names_;
};

}  // namespace rob::lang
