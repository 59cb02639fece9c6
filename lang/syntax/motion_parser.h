#pragma once

#include <string_view>

#include "lang/syntax/ast.h"
#include "lang/syntax/clause_parser.h"
#include "lang/syntax/expression_parser.h"
#include "lang/syntax/token_reader.h"
#include "lang/syntax/tree_builder.h"

namespace rob::lang {

/// The rules for motions.
class MotionParser {
 public:
  MotionParser(TokenReader& tokens, TreeBuilder& tree, ExpressionParser& expressions,
               ClauseParser& clauses)
      : tokens_(tokens), tree_(tree), expressions_(expressions), clauses_(clauses) {}

  bool at_motion() const;
  bool plain_motion(Block& block);
  void move(Block& block);

 private:
  void target_of(Move& move);
  void expect_word(std::string_view word, std::string_view behind, std::string_view example);
  void curve(Move& move);
  void spiral(Move& move);
  void jog(Move& move);
  void joint_target(Move& move);
  ExprPtr target(std::string_view motion, bool in_list = false);
  bool at_value() const;
  bool at_list() const;
  bool group_goes_on() const;
  [[noreturn]] void fail_target(std::string_view motion);

  TokenReader& tokens_;
  TreeBuilder& tree_;
  ExpressionParser& expressions_;
  ClauseParser& clauses_;
};

}  // namespace rob::lang
