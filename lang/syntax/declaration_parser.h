#pragma once

#include <vector>

#include "lang/syntax/ast.h"
#include "lang/syntax/expression_parser.h"
#include "lang/syntax/open_blocks.h"
#include "lang/syntax/text_names.h"
#include "lang/syntax/token_reader.h"
#include "lang/syntax/tree_builder.h"
#include "lang/syntax/type_parser.h"

namespace rob::lang {

/// The rules for declarations. If one cannot be read in full, its names are declared all the
/// same, with the type Unknown.
class DeclarationParser {
 public:
  DeclarationParser(TokenReader& tokens, TreeBuilder& tree, TextNames& names,
                    ExpressionParser& expressions, TypeParser& types, OpenBlocks& blocks)
      : tokens_(tokens),
        tree_(tree),
        names_(names),
        expressions_(expressions),
        types_(types),
        blocks_(blocks) {}

  /// VAR and CONST.
  void variables(Block& block, bool persist = false);
  void persist(Block& block);
  void device(Block& block);
  void obstacle(Block& block);
  void signal(Block& block);
  void point(Block& block);
  void frame_or_tool(Block& block);
  void record(Block& block);
  void enumeration(Block& block);
  void use(Block& block);
  /// The names in a list, of a declaration that is written in another way.
  void unknown(Block& block);

 private:
  void declared_names(Declaration& declaration);
  void declared_type_and_value(Declaration& declaration);
  void scale(SignalDeclaration& signal);
  void obstacle_shape(ObstacleDeclaration& obstacle);
  std::vector<ExprPtr> shape_values();
  void tool_shape(Declaration& tool);
  void enum_names(EnumDeclaration& enumeration);
  void record_fields(RecordDeclaration& record);
  RecordDeclaration::Fields record_group();

  TokenReader& tokens_;
  TreeBuilder& tree_;
  TextNames& names_;
  ExpressionParser& expressions_;
  TypeParser& types_;
  OpenBlocks& blocks_;
};

}  // namespace rob::lang
