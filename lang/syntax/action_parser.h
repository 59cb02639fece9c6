#pragma once

#include <cstddef>
#include <set>
#include <string>
#include <utility>

#include "lang/syntax/ast.h"
#include "lang/syntax/expression_parser.h"
#include "lang/syntax/text_names.h"
#include "lang/syntax/token_reader.h"
#include "lang/syntax/tree_builder.h"

namespace rob::lang {

/// The rules for statements on one line that hold no further statement, motions apart. Keeps the
/// names of the points that are taught.
class ActionParser {
 public:
  ActionParser(TokenReader& tokens, TreeBuilder& tree, TextNames& names,
               ExpressionParser& expressions)
      : tokens_(tokens), tree_(tree), names_(names), expressions_(expressions) {}

  /// The statement that begins with the reserved word here; false if it is none of these.
  bool reserved(Block& block);
  /// At a prompt: an expression, which is printed.
  void value_alone(Block& block);
  void assignment(Block& block);
  void call_statement(Block& block);
  void start_statement(Block& block);
  void zero_statement(Block& block);
  void override_statement(Block& block);
  void load_statement(Block& block);
  void write_statement(Block& block);
  void send_statement(Block& block);
  void read_statement(Block& block);
  /// In capitals.
  std::set<std::string> take_taught() { return std::move(taught_); }

 private:
  void word_alone(Block& block, decltype(Statement::node) node);
  void print(Block& block);
  void pulse(Block& block);
  void assert_statement(Block& block);
  void expect_statement(Block& block);
  std::string source_text(std::size_t begin) const;
  void raise_statement(Block& block);
  void return_statement(Block& block);
  void halt_statement(Block& block);
  void ask_statement(Block& block);
  void teach_statement(Block& block);
  void simulate_statement(Block& block);
  bool operators_simulation(Simulate& node);

  TokenReader& tokens_;
  TreeBuilder& tree_;
  TextNames& names_;
  ExpressionParser& expressions_;
  std::set<std::string> taught_;
};

}  // namespace rob::lang
