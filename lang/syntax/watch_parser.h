#pragma once

#include <string_view>

#include "lang/syntax/ast.h"
#include "lang/syntax/expression_parser.h"
#include "lang/syntax/open_blocks.h"
#include "lang/syntax/routine_parser.h"
#include "lang/syntax/text_names.h"
#include "lang/syntax/token_reader.h"
#include "lang/syntax/tree_builder.h"

namespace rob::lang {

/// The rules for what is looked at in every control cycle: WAIT, UNTIL, path events and WHEN.
class WatchParser {
 public:
  WatchParser(TokenReader& tokens, TreeBuilder& tree, TextNames& names,
              ExpressionParser& expressions, OpenBlocks& blocks, RoutineParser& routines,
              StatementReader& statements)
      : tokens_(tokens),
        tree_(tree),
        names_(names),
        expressions_(expressions),
        blocks_(blocks),
        routines_(routines),
        statements_(statements) {}

  void wait(Block& block);
  void receive(Block& block);
  /// UNTIL and DO after the motion that `block` ends with.
  void behind_motion(Block& block, bool may_open_block);
  WayPoint path_event();
  void when(Block& block);

 private:
  void alternative(Block& block);
  void path_events(WatchedMotion& motion, const Place& place);
  void action(Block& block, std::string_view behind);

  TokenReader& tokens_;
  TreeBuilder& tree_;
  TextNames& names_;
  ExpressionParser& expressions_;
  OpenBlocks& blocks_;
  RoutineParser& routines_;
  StatementReader& statements_;
};

}  // namespace rob::lang
