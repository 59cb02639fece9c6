#pragma once

#include "lang/syntax/ast.h"
#include "lang/syntax/token_reader.h"

namespace rob::lang {

/// The rules for ROBOT, UNITS and LAW. Keeps what they say.
class HeaderParser {
 public:
  explicit HeaderParser(TokenReader& tokens) : tokens_(tokens) {}

  /// `block` is what stands before it; `inside`: a block is open.
  void header(const Block& block, bool inside);
  const Header& read() const { return header_; }

 private:
  void robot_header(const Place& place);
  void law_header(const Place& place);
  void units_header();

  TokenReader& tokens_;
  Header header_;
};

}  // namespace rob::lang
