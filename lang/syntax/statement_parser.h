#pragma once

#include <string_view>

#include "lang/syntax/action_parser.h"
#include "lang/syntax/ast.h"
#include "lang/syntax/block_parser.h"
#include "lang/syntax/clause_parser.h"
#include "lang/syntax/declaration_parser.h"
#include "lang/syntax/expression_parser.h"
#include "lang/syntax/foreign_hints.h"
#include "lang/syntax/header_parser.h"
#include "lang/syntax/motion_parser.h"
#include "lang/syntax/open_blocks.h"
#include "lang/syntax/routine_parser.h"
#include "lang/syntax/text_names.h"
#include "lang/syntax/token_reader.h"
#include "lang/syntax/tree_builder.h"
#include "lang/syntax/type_parser.h"
#include "lang/syntax/watch_parser.h"

namespace rob::lang {

/// Whether motions in numbers alone are kept as numbers (plain_motion.h), or as trees like others.
enum class PlainMotionsAs : bool { Numbers, Trees };

/// Finds out which statement stands on a line, and what becomes of a line that is none.
class StatementParser final : public StatementReader {
 public:
  StatementParser(TokenReader& tokens, TreeBuilder& tree, TextNames& names,
                  ExpressionParser& expressions, TypeParser& types, PlainMotionsAs plain_motions);

  void statement(Block& block) override;
  void simple(Block& block) override;
  /// At a prompt: an expression, which is printed.
  void value_alone(Block& block);
  /// Moves what was kept into the program.
  void finish(Program& program);

 private:
  void any_statement(Block& block);
  bool block_statement(Block& block);
  void motion(Block& block);
  void word_statement(Block& block);
  void default_statement(Block& block);
  bool at_placed_word(std::string_view word);
  bool at_file_word(std::string_view word);
  bool at_naming_word(std::string_view word);
  bool looks_misspelt();
  void unknown_word(Block& block);
  std::string_view statement_meant() const;
  bool can_stand_for(Keyword keyword) const;
  [[noreturn]] void fail_statement();

  TokenReader& tokens_;
  TreeBuilder& tree_;
  TextNames& names_;
  PlainMotionsAs plain_motions_;
  OpenBlocks blocks_;
  HeaderParser header_;
  DeclarationParser declarations_;
  RoutineParser routines_;
  ClauseParser clauses_;
  MotionParser motions_;
  BlockParser block_statements_;
  WatchParser watches_;
  ActionParser actions_;
  ForeignHints hints_;
};

}  // namespace rob::lang
