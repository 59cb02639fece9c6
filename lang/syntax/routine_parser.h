#pragma once

#include <utility>
#include <vector>

#include "lang/syntax/ast.h"
#include "lang/syntax/expression_parser.h"
#include "lang/syntax/open_blocks.h"
#include "lang/syntax/text_names.h"
#include "lang/syntax/token_reader.h"
#include "lang/syntax/tree_builder.h"
#include "lang/syntax/type_parser.h"

namespace rob::lang {

/// The rules for PROC, FUNC, TASK and TEST. Keeps the routines of the text.
class RoutineParser {
 public:
  RoutineParser(TokenReader& tokens, TreeBuilder& tree, TextNames& names,
                ExpressionParser& expressions, TypeParser& types, OpenBlocks& blocks)
      : tokens_(tokens),
        tree_(tree),
        names_(names),
        expressions_(expressions),
        types_(types),
        blocks_(blocks) {}

  void routine();
  /// The handler of a WHEN.
  void add_handler(const Place& place, const Place& end);
  /// One that is written as in another language, and is not read: it is called all the same.
  void add_unread(const Place& place, const Token& name);
  /// All that were read.
  std::vector<Routine> take() { return std::move(routines_); }

 private:
  void header(Routine& routine);
  void test_header(Routine& test);
  void task_header();
  void proc_or_func_header(Routine& routine);
  Routine::Parameters parameters(Routine& routine);
  void read_parameters(Routine::Parameters& group);
  void skip_parameters();
  void keep_named_parameters(Routine& routine);
  void keep(Routine routine);

  TokenReader& tokens_;
  TreeBuilder& tree_;
  TextNames& names_;
  ExpressionParser& expressions_;
  TypeParser& types_;
  OpenBlocks& blocks_;
  std::vector<Routine> routines_;
};

}  // namespace rob::lang
