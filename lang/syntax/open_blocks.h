#pragma once

#include <string_view>
#include <vector>

#include "lang/syntax/ast.h"
#include "lang/syntax/expression_parser.h"
#include "lang/syntax/keywords.h"
#include "lang/syntax/token_reader.h"

namespace rob::lang {

/// The means to read the statements inside other statements.
class StatementReader {
 public:
  /// The statement that begins on this line, or what an error left of it.
  virtual void statement(Block& block) = 0;
  /// The statement that stands here, on the line of another.
  virtual void simple(Block& block) = 0;

 protected:
  ~StatementReader() = default;
};

/// A block that is being read: the word that closes it, and where it begins.
struct OpenBlock {
  Keyword closer;
  Place place;
};

/// "IF": what is closed by ENDIF, or branched by ELSE.
std::string_view opener_of(Keyword closer);

/// The blocks that are open. Reads their headers, their statements and their ends, and finds out
/// what becomes of those that are not closed.
class OpenBlocks {
 public:
  OpenBlocks(TokenReader& tokens, ExpressionParser& expressions, StatementReader& statements)
      : tokens_(tokens), expressions_(expressions), statements_(statements) {}

  bool none() const { return open_.empty(); }
  bool in_path() const;
  /// ENDIF: what closes the innermost block. There must be one.
  Keyword innermost_closer() const { return open_.back().closer; }
  /// Report a declaration, and a routine, that begins here inside a block.
  void check_declaration(std::string_view word);
  void check_routine(std::string_view word);

  ExprPtr condition(Keyword last);
  void header_word(Keyword word, std::string_view behind);
  void header_end(std::string_view word);
  /// Reads DO after what `header` reads; where that throws SyntaxError the block is read all the
  /// same.
  template <typename Header>
  void header_up_to_do(Header header) {
    try {
      header();
      header_word(Keyword::Do, "what stands here");
    } catch (const SyntaxError&) {
      tokens_.recover_until(Keyword::Do);
    }
  }

  /// The statements up to the word that closes the block, or begins its next branch.
  Block read(const OpenBlock& open);
  /// The same of lines that are no statements: `line` reads one, and throws no SyntaxError.
  template <typename Line>
  void read_lines(const OpenBlock& open, Line line) {
    open_.push_back(open);
    for (tokens_.skip_line_ends(); !at_end(); tokens_.skip_line_ends()) line();
    open_.pop_back();
  }
  /// At a word that ends the innermost block, or must be taken to do so.
  bool at_closer() const;
  void close(const OpenBlock& open);
  void report_unclosed(const OpenBlock& open);
  [[noreturn]] void fail_stray_closer();

 private:
  bool at_end();
  void find_word_that_closes();
  bool closes_outer() const;
  void close_with_end(const OpenBlock& open);

  TokenReader& tokens_;
  ExpressionParser& expressions_;
  StatementReader& statements_;
  std::vector<OpenBlock> open_;
};

}  // namespace rob::lang
