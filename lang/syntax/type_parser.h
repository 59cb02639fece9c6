#pragma once

#include <cstddef>
#include <vector>

#include "lang/syntax/ast.h"
#include "lang/syntax/expression_parser.h"
#include "lang/syntax/source_context.h"
#include "lang/syntax/text_names.h"
#include "lang/syntax/token_reader.h"
#include "lang/syntax/tree_builder.h"
#include "lang/values/types.h"

namespace rob::lang {

/// The rules for types. Keeps what the checker has to settle in those that were written.
class TypeParser {
 public:
  /// All that `context` points to must outlive it.
  TypeParser(TokenReader& tokens, TreeBuilder& tree, TextNames& names,
             ExpressionParser& expressions, const SourceContext& context);

  Type type();
  /// Moves what was kept into the program.
  void finish(Program& program);

 private:
  Type array_type();
  Type list_type();
  Type pose_type();
  Type vec_type();
  Type unit_type();

  TokenReader& tokens_;
  TreeBuilder& tree_;
  TextNames& names_;
  ExpressionParser& expressions_;
  TypeTable& table_;
  std::size_t first_array_length_;
  std::vector<Program::ArrayLength> array_lengths_;
  std::vector<Program::FrameUse> frame_uses_;
};

}  // namespace rob::lang
