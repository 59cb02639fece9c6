#include "lang/syntax/parser_impl.h"
#include "lang/text/ascii.h"

/// How the parser skips statements that belong to the language but not to this version, a block
/// with all that it holds.
namespace rob::lang {

/// The names that a skipped statement declares, so that their uses are no further mistakes.
void Parser::declare_unknown(Block& block) {
  Declaration declaration;
  declaration.type = Type{};
  while (at(TokenKind::Word)) {
    declaration.names.push_back({std::string(current_.text), current_.place});
    advance();
    if (!accept(TokenKind::Comma)) break;
  }
  if (!declaration.names.empty()) add(block, current_.place, std::move(declaration));
}

/// Skips the rest of the line, which opens a block, and all lines to the one that closes it.
/// Blocks of the same kind inside it, which a line that ends in DO opens, are counted.
void Parser::skip_later_block(std::string_view opener, std::string_view closer) {
  brackets_ = 0;
  int open = 1;
  skip_line();
  while (open > 0 && !at(TokenKind::EndOfFile)) {
    while (accept(TokenKind::EndOfLine)) {
    }
    const bool opens = same_word(current_.text, opener);
    const bool closes = same_word(current_.text, closer);
    const bool ends_in_do = skip_line();
    if (opens && ends_in_do) ++open;
    if (closes) --open;
  }
}

/// To the end of the line; whether its last word is DO.
bool Parser::skip_line() {
  bool last = false;
  while (!at_line_end()) {
    last = at(Keyword::Do);
    shift();
  }
  return last;
}

}  // namespace rob::lang
