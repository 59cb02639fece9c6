#include <algorithm>
#include <memory>
#include <utility>

#include <fmt/format.h>

#include "lang/syntax/parser_impl.h"
#include "lang/text/ascii.h"
#include "lang/text/codes.h"

/// The parser's rules for IF, WHILE and FOR, and what becomes of blocks that are not closed.
namespace rob::lang {

namespace {

/// What cannot stand on the line of THEN.
bool takes_lines(Keyword keyword) {
  switch (keyword) {
    case Keyword::If:
    case Keyword::When:
    case Keyword::While:
    case Keyword::For:
    case Keyword::Loop:
    case Keyword::Select:
    case Keyword::Try:
    case Keyword::Proc:
    case Keyword::Func:
    case Keyword::Task:
    case Keyword::Var:
    case Keyword::Const:
    case Keyword::Signal:
    case Keyword::With:
    case Keyword::Record:
    case Keyword::End:
      return true;
    default:
      return false;
  }
}

/// Stands in for a value that could not be read and has been reported.
template <typename Literal>
ExprPtr stand_in(const Place& place, Literal literal) {
  auto expr = std::make_unique<Expr>();
  expr->place = place;
  expr->node = literal;
  return expr;
}

}  // namespace

/// What opens the block that a word closes, or whose branch it begins.
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

Block Parser::block_of(const OpenBlock& open) {
  if (open_blocks_.size() >= static_cast<std::size_t>(kMaxDepth)) {
    report(code::kTooDeep, open.place,
           fmt::format("the blocks are nested too deep: at most {} levels", kMaxDepth));
    throw GiveUp{};
  }
  open_blocks_.push_back(open);
  Block block;
  for (;;) {
    while (accept(TokenKind::EndOfLine)) {
    }
    if (at(TokenKind::EndOfFile) || at_block_end()) break;
    statement(block);
  }
  open_blocks_.pop_back();
  return block;
}

/// A word that ends the innermost block, or must be taken to do so.
bool Parser::at_block_end() const {
  if (!at(TokenKind::Reserved) || open_blocks_.empty()) return false;
  switch (current_.keyword) {
    case Keyword::End:
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
bool Parser::closes_outer() const {
  const std::string_view opener = opener_of(current_.keyword);
  return std::ranges::any_of(open_blocks_, [&](const OpenBlock& open) {
    const bool select = open.opener == Keyword::Select && at(Keyword::Else);
    return select || opener_of(open.closer) == opener;
  });
}

/// Reads the closing word. Where another stands, it is left for the block it belongs to.
void Parser::close(const OpenBlock& open) {
  if (at(open.closer)) return advance();
  if (at(Keyword::End)) return close_with_end(open);
  if (at(TokenKind::EndOfFile)) return report_unclosed(open);
  report(
      code::kUnclosedBlock, current_.place,
      fmt::format("{} expected before {}: the {} of line {} is still open", spelling(open.closer),
                  spelling(current_.keyword), opener_of(open.closer), open.place.line));
  if (!closes_outer()) advance();
}

/// END where a block is open: `END IF`, an END for the block as in other languages, or the end
/// of the program with the block forgotten.
void Parser::close_with_end(const OpenBlock& open) {
  const bool two_words = next_.kind == TokenKind::Reserved;
  if (!two_words && lexer_.only_blanks_left()) return report_unclosed(open);
  report(code::kUnclosedBlock, current_.place,
         fmt::format("the {} of line {} is closed by {}", opener_of(open.closer), open.place.line,
                     spelling(open.closer)),
         two_words ? "write it as one word" : "END ends the whole program");
  advance();
  if (two_words) advance();
}

void Parser::report_unclosed(const OpenBlock& open) {
  report(code::kUnclosedBlock, open.place,
         fmt::format("the {} of line {} is not closed", opener_of(open.closer), open.place.line),
         fmt::format("write {} behind its last statement", spelling(open.closer)));
}

void Parser::stray_closer() {
  fail_here(code::kStrayCloser,
            fmt::format("{} without {}", spelling(current_.keyword), opener_of(current_.keyword)));
}

// "IF" expr "THEN" simple eol
// "IF" expr "THEN" eol block { "ELSIF" expr "THEN" eol block } [ "ELSE" eol block ] "ENDIF" eol
void Parser::if_statement(Block& block) {
  const OpenBlock open{Keyword::If, Keyword::Endif, current_.place};
  If node;
  advance();
  node.branches.push_back({condition(Keyword::Then), {}});
  Block& body = node.branches.back().body;
  if (at_line_end()) {
    body = block_of(open);
    further_branches(node, open);
    close(open);
  } else {
    behind_then(body);
  }
  add(block, open.place, std::move(node));
}

/// The one statement on the line of THEN.
void Parser::behind_then(Block& body) {
  if (at(TokenKind::Reserved) && takes_lines(current_.keyword)) {
    fail_here(code::kLineEndExpected,
              fmt::format("{} cannot stand on the line of THEN", spelling(current_.keyword)),
              "begin a new line behind THEN, and close with ENDIF");
  }
  simple(body);
  if (at(Keyword::Else)) {
    fail_here(code::kLineEndExpected, "an IF with ELSE takes several lines",
              "begin new lines behind THEN and around ELSE, and close with ENDIF");
  }
  if (at(Keyword::Endif)) {
    fail_here(code::kLineEndExpected, "an IF on one line has no ENDIF", "leave ENDIF out");
  }
}

void Parser::further_branches(If& node, const OpenBlock& open) {
  bool had_else = false;
  while (at(Keyword::Elsif) || at(Keyword::Else)) {
    const Place place = current_.place;
    const std::string_view word = spelling(current_.keyword);
    const bool split = next_.kind == TokenKind::Reserved && next_.keyword == Keyword::If;
    if (had_else) {
      report(code::kStrayCloser, place,
             fmt::format("{} behind the ELSE of the IF of line {}", word, open.place.line));
    } else if (at(Keyword::Else) && split) {
      report(code::kLineEndExpected, place, "ELSE IF is written as one word", "write ELSIF");
    }
    const bool conditional = at(Keyword::Elsif) || split;
    if (at(Keyword::Else) && split) advance();
    advance();
    if (conditional) {
      node.branches.push_back({condition(Keyword::Then), {}});
      node.branches.back().body = block_of(open);
    } else {
      had_else = node.has_else = true;
      node.otherwise = block_of(open);
    }
  }
}

// "WHILE" expr "DO" eol block "ENDWHILE" eol
void Parser::while_statement(Block& block) {
  const OpenBlock open{Keyword::While, Keyword::Endwhile, current_.place};
  While loop;
  advance();
  loop.condition = condition(Keyword::Do);
  loop.body = block_of(open);
  close(open);
  add(block, open.place, std::move(loop));
}

// "FOR" IDENT "=" expr "TO" expr [ "STEP" expr ] "DO" eol block "ENDFOR" eol
void Parser::for_statement(Block& block) {
  const OpenBlock open{Keyword::For, Keyword::Endfor, current_.place};
  For loop;
  advance();
  try {
    for_header(loop);
  } catch (const SyntaxError&) {
    recover_until(Keyword::Do);
    const NumberLiteral one{.value = 1, .integer = 1, .is_integer = true, .dimension = {}};
    if (!loop.from) loop.from = stand_in(open.place, one);
    if (!loop.to) loop.to = stand_in(open.place, one);
  }
  loop.body = block_of(open);
  close(open);
  add(block, open.place, std::move(loop));
}

void Parser::for_header(For& loop) {
  Declaration::Declared variable = declared_name("FOR");
  loop.variable = std::move(variable.name);
  loop.variable_place = variable.place;
  if (!accept(TokenKind::Assign)) {
    fail_here(code::kAssignExpected,
              fmt::format("'=' expected after {}", shortened(loop.variable)));
  }
  loop.from = expression();
  if (!at_word("TO")) {
    fail(code::kWordExpected, behind_previous(), "TO expected after the first value of FOR",
         "FOR i = 1 TO 10 DO");
  }
  advance();
  loop.to = expression();
  if (at_word("STEP")) {
    advance();
    loop.step = expression();
  }
  header_word(Keyword::Do, "the values of FOR");
}

/// A condition and the word behind it. What cannot be read is reported and replaced, so that the
/// block behind it is read all the same.
ExprPtr Parser::condition(Keyword last) {
  const Place place = current_.place;
  try {
    ExprPtr condition = expression();
    header_word(last, "the condition");
    return condition;
  } catch (const SyntaxError&) {
    recover_until(last);
    return stand_in(place, BoolLiteral{true});
  }
}

/// THEN or DO. Where it is missing the statement behind it is read all the same.
void Parser::header_word(Keyword word, std::string_view behind) {
  if (at(word)) return advance();
  const std::string message = fmt::format("{} expected after {}", spelling(word), behind);
  const bool statement_follows =
      at_line_end() || (begins_statement(current_) && !at(Keyword::Then) && !at(Keyword::Do));
  if (!statement_follows) fail(code::kWordExpected, behind_previous(), message, remedy());
  report(code::kWordExpected, behind_previous(), message);
}

}  // namespace rob::lang
