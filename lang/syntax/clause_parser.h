#pragma once

#include <string_view>

#include "lang/syntax/ast.h"
#include "lang/syntax/expression_parser.h"
#include "lang/syntax/token_reader.h"
#include "lang/syntax/tree_builder.h"

namespace rob::lang {

/// A clause of the language, whether this version has it or not; empty if it is none.
std::string_view clause_word(const Token& token);

/// Whether a value may go on with this sign: then the target is computed.
bool goes_on(const Token& token);

/// The rules for the clauses of motions, and for WITH and IN wherever they stand. Remembers whether
/// one of the two does.
class ClauseParser {
 public:
  ClauseParser(TokenReader& tokens, TreeBuilder& tree, ExpressionParser& expressions)
      : tokens_(tokens), tree_(tree), expressions_(expressions) {}

  void clauses(Clauses& clauses);
  /// The header of a block, from WITH on: there a word of a clause is one, never a tool's name.
  void with_header(Clauses& clauses);
  void in_frame(Surroundings& surroundings);
  bool any_surroundings() const { return surroundings_; }

  bool at_name_of_value() const;
  bool at_clause_word(std::string_view word) const;
  /// NEAR or FREE with what follows it: two words in a row.
  bool at_choice() const;

 private:
  bool value_ends_at_next() const;
  bool at_choice_word() const;
  void near(Clauses& clauses);
  void free(Clauses& clauses);
  void with_tool(Surroundings& surroundings);
  void clause(Clauses& clauses, Clause which, std::string_view word);
  bool at_live() const;
  bool at_further_value() const;
  void profile(Clauses& clauses);
  ExprPtr name_behind(std::string_view word, std::string_view example);
  void report_twice(std::string_view word);
  [[noreturn]] void fail_clause();

  TokenReader& tokens_;
  TreeBuilder& tree_;
  ExpressionParser& expressions_;
  bool surroundings_ = false;
};

}  // namespace rob::lang
