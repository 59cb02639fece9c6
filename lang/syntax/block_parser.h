#pragma once

#include "lang/syntax/ast.h"
#include "lang/syntax/clause_parser.h"
#include "lang/syntax/expression_parser.h"
#include "lang/syntax/open_blocks.h"
#include "lang/syntax/text_names.h"
#include "lang/syntax/token_reader.h"
#include "lang/syntax/tree_builder.h"

namespace rob::lang {

/// The rules for statements that hold blocks: branches, loops, TRY, and what lies around motions.
class BlockParser {
 public:
  BlockParser(TokenReader& tokens, TreeBuilder& tree, TextNames& names,
              ExpressionParser& expressions, ClauseParser& clauses, OpenBlocks& blocks,
              StatementReader& statements)
      : tokens_(tokens),
        tree_(tree),
        names_(names),
        expressions_(expressions),
        clauses_(clauses),
        blocks_(blocks),
        statements_(statements) {}

  void if_statement(Block& block);
  void while_statement(Block& block);
  void for_statement(Block& block);
  void loop_statement(Block& block);
  void select_statement(Block& block);
  void try_statement(Block& block);
  void with_statement(Block& block);
  void path_statement(Block& block);
  void press_statement(Block& block);
  void allow_statement(Block& block);

 private:
  void behind_then(Block& body);
  void on_line_of(std::string_view word, Block& body);
  void further_branches(If& node, const OpenBlock& open);
  void for_header(For& loop);
  void select_branches(Select& node, const OpenBlock& open);
  void case_values(Select::Case& branch);
  void rescue_header(Try& node);
  void press_header(Press& press);
  Declaration::Declared allowed_body();

  TokenReader& tokens_;
  TreeBuilder& tree_;
  TextNames& names_;
  ExpressionParser& expressions_;
  ClauseParser& clauses_;
  OpenBlocks& blocks_;
  StatementReader& statements_;
};

}  // namespace rob::lang
