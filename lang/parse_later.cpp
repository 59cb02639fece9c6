#include <algorithm>
#include <array>
#include <utility>

#include <fmt/format.h>

#include "lang/ascii.h"
#include "lang/codes.h"
#include "lang/parser_impl.h"

/// Statements that belong to the language but not to this version: one clear message each, then
/// they are skipped, a block with all that it holds.
namespace rob::lang {

namespace {

/// Statements known by their place only: the first word of a line.
constexpr std::array<std::string_view, 4> kLaterWords{"PRESS", "PATH", "ZERO", "OVERRIDE"};

/// A DO at the end of its line opens a block for every motion, closed by ENDMOVE.
std::string closer_of(const Token& opener) {
  const bool motion = opener.kind == TokenKind::Reserved &&
                      role(opener.keyword) == KeywordRole::LaterMotion &&
                      opener.keyword != Keyword::When;
  return motion ? "ENDMOVE" : "END" + to_upper(opener.text);
}

bool always_opens_block(const Token& word) {
  if (word.kind == TokenKind::Reserved) return role(word.keyword) == KeywordRole::LaterBlock;
  return same_word(word.text, "PRESS") || same_word(word.text, "PATH");
}

}  // namespace

bool Parser::at_later_word() const {
  const bool listed = std::ranges::any_of(
      kLaterWords, [&](std::string_view word) { return same_word(word, current_.text); });
  if (!listed) return false;
  if (next_.kind == TokenKind::LeftParen) return same_word(current_.text, "PATH");
  return next_.kind != TokenKind::Assign && next_.kind != TokenKind::Dot &&
         next_.kind != TokenKind::LeftBracket;
}

void Parser::later_statement() {
  const Token word = current_;
  report(code::kNotYet, word.place,
         fmt::format("{} is not in this version of Rob yet", to_upper(word.text)));
  const bool always = always_opens_block(word);
  if (always || line_ends_with(Keyword::Do)) {
    skip_later_block(to_upper(word.text), closer_of(word), always);
  }
  throw SyntaxError{};
}

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
/// Blocks of the same kind inside it are counted; without `always` only a line that ends in DO
/// opens one.
void Parser::skip_later_block(std::string_view opener, std::string_view closer, bool always) {
  brackets_ = 0;
  int open = 1;
  skip_line();
  while (open > 0 && !at(TokenKind::EndOfFile)) {
    while (accept(TokenKind::EndOfLine)) {
    }
    const bool opens = same_word(current_.text, opener);
    const bool closes = same_word(current_.text, closer);
    const bool ends_in_do = skip_line();
    if (opens && (always || ends_in_do)) ++open;
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
