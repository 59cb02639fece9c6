#include "lang/syntax/open_blocks.h"

#include <algorithm>
#include <utility>

#include <fmt/format.h>

#include "lang/syntax/syntax_limits.h"
#include "lang/syntax/tree_builder.h"
#include "lang/text/codes.h"

namespace rob::lang {

std::string_view opener_of(Keyword closer) {
  switch (closer) {
    case Keyword::Else:
    case Keyword::Elsif:
      return "IF";
    case Keyword::Case:
      return "SELECT";
    case Keyword::Rescue:
      return "TRY";
    default:
      return spelling(closer).substr(std::string_view("END").size());
  }
}

void OpenBlocks::check_declaration(std::string_view word) {
  if (none()) return;
  tokens_.report(code::kOnlyTopLevel, tokens_.place(),
                 fmt::format("{} can stand only outside all blocks", word),
                 fmt::format("write it before the {} of line {}", opener_of(open_.front().closer),
                             open_.front().place.line));
}

void OpenBlocks::check_routine(std::string_view word) {
  if (none()) return;
  tokens_.report(code::kMisplaced, tokens_.place(),
                 fmt::format("{} can only stand at the top level, outside of all blocks", word),
                 fmt::format("move it after the end of the {} of line {}",
                             opener_of(open_.front().closer), open_.front().place.line));
}

Block OpenBlocks::read(const OpenBlock& open) {
  if (open_.size() >= static_cast<std::size_t>(kMaxDepth)) {
    tokens_.report(code::kTooDeep, open.place,
                   fmt::format("the blocks are nested too deep: at most {} levels", kMaxDepth));
    throw GiveUp{};
  }
  Block block;
  read_lines(open, [&] { statements_.statement(block); });
  return block;
}

/// ENDALLOW is not reserved: in an ALLOW it ends that where it stands alone on its line.
void OpenBlocks::find_word_that_closes() {
  const bool alone =
      tokens_.current().first_on_line && tokens_.at_word("ENDALLOW") &&
      (tokens_.next().kind == TokenKind::EndOfLine || tokens_.next().kind == TokenKind::EndOfFile);
  const auto allows = [](const OpenBlock& open) { return open.closer == Keyword::Endallow; };
  if (alone && std::ranges::any_of(open_, allows)) tokens_.take_for(Keyword::Endallow);
}

bool OpenBlocks::at_end() {
  find_word_that_closes();
  return tokens_.at(TokenKind::EndOfFile) || at_closer();
}

bool OpenBlocks::at_closer() const {
  if (!tokens_.at(TokenKind::Reserved) || open_.empty()) return false;
  switch (tokens_.current().keyword) {
    case Keyword::End:
    case Keyword::Endallow:
    case Keyword::Endif:
    case Keyword::Endwhile:
    case Keyword::Endfor:
    case Keyword::Endloop:
    case Keyword::Endmove:
    case Keyword::Endpath:
    case Keyword::Endpress:
    case Keyword::Endselect:
    case Keyword::Endtry:
    case Keyword::Endproc:
    case Keyword::Endfunc:
    case Keyword::Endtask:
    case Keyword::Endtest:
    case Keyword::Endwhen:
    case Keyword::Endwith:
      return true;
    case Keyword::Else:
    case Keyword::Elsif:
    case Keyword::Case:
    case Keyword::Rescue:
      return closes_outer();
    default:
      return false;
  }
}

/// Whether one of the open blocks goes with the current word.
bool OpenBlocks::closes_outer() const {
  const std::string_view opener = opener_of(tokens_.current().keyword);
  return std::ranges::any_of(open_, [&](const OpenBlock& open) {
    const bool select = open.closer == Keyword::Endselect && tokens_.at(Keyword::Else);
    return select || opener_of(open.closer) == opener;
  });
}

/// Reads the closing word. Where another stands, it is left for the block it belongs to.
void OpenBlocks::close(const OpenBlock& open) {
  if (tokens_.at(open.closer)) return tokens_.advance();
  if (tokens_.at(Keyword::End)) return close_with_end(open);
  if (tokens_.at(TokenKind::EndOfFile)) return report_unclosed(open);
  tokens_.report(
      code::kUnclosedBlock, tokens_.place(),
      fmt::format("{} expected before {}: the {} of line {} is still open", spelling(open.closer),
                  spelling(tokens_.current().keyword), opener_of(open.closer), open.place.line));
  if (!closes_outer()) tokens_.advance();
}

/// END where a block is open: `END IF`, an END for the block as in other languages, or the end
/// of the program with the block forgotten.
void OpenBlocks::close_with_end(const OpenBlock& open) {
  const bool two_words = tokens_.next().kind == TokenKind::Reserved;
  if (!two_words && tokens_.only_blanks_ahead()) return report_unclosed(open);
  tokens_.report(code::kUnclosedBlock, tokens_.place(),
                 fmt::format("the {} of line {} is closed by {}", opener_of(open.closer),
                             open.place.line, spelling(open.closer)),
                 two_words ? "write it as one word" : "END ends the whole program");
  tokens_.advance();
  if (two_words) tokens_.advance();
}

void OpenBlocks::report_unclosed(const OpenBlock& open) {
  tokens_.report(
      code::kUnclosedBlock, open.place,
      fmt::format("the {} of line {} is not closed", opener_of(open.closer), open.place.line),
      fmt::format("write {} after its last statement", spelling(open.closer)));
}

void OpenBlocks::fail_stray_closer() {
  tokens_.fail_here(code::kStrayCloser,
                    fmt::format("{} without {}", spelling(tokens_.current().keyword),
                                opener_of(tokens_.current().keyword)));
}

/// A condition and the word after it. Text that cannot be read is reported and replaced, so that
/// the block after it is read all the same.
ExprPtr OpenBlocks::condition(Keyword last) {
  const Place place = tokens_.place();
  try {
    ExprPtr condition = expressions_.expression();
    header_word(last, "the condition");
    return condition;
  } catch (const SyntaxError&) {
    tokens_.recover_until(last);
    return TreeBuilder::stand_in(place, BoolLiteral{true});
  }
}

/// THEN or DO. Where it is missing the statement after it is read all the same.
void OpenBlocks::header_word(Keyword word, std::string_view behind) {
  if (tokens_.at(word)) return tokens_.advance();
  const std::string message = fmt::format("{} expected after {}", spelling(word), behind);
  const bool statement_follows =
      tokens_.at_line_end() || (begins_statement(tokens_.current()) && !tokens_.at(Keyword::Then) &&
                                !tokens_.at(Keyword::Do));
  if (!statement_follows) tokens_.fail_behind(code::kWordExpected, message, tokens_.remedy());
  tokens_.report(code::kWordExpected, tokens_.behind_previous(), message);
}

/// The end of a header's line; `word` is what the header begins with.
void OpenBlocks::header_end(std::string_view word) {
  if (tokens_.at_line_end()) return;
  if (!tokens_.at(TokenKind::Bad)) {  // that is reported already
    tokens_.report(
        code::kLineEndExpected, tokens_.place(),
        fmt::format("{} cannot stand on the line of {}", described(tokens_.current()), word),
        "begin a new line before it");
  }
  tokens_.skip_line();
}

bool OpenBlocks::in_path() const {
  for (const OpenBlock& open : open_) {
    if (open.closer == Keyword::Endpath) return true;
  }
  return false;
}

}  // namespace rob::lang
