#include <array>
#include <utility>

#include <fmt/format.h>

#include "lang/syntax/parser_impl.h"
#include "lang/text/ascii.h"
#include "lang/text/codes.h"
#include "lang/text/suggest.h"

/// The parser's rules for statements on one line, and what becomes of unknown ones.
namespace rob::lang {
namespace {

/// Not reserved, and known at the beginning of a line.
constexpr std::array<std::string_view, 11> kPlacedWords{
    "FRAME", "LAW", "LOAD", "OVERRIDE", "PATH", "PRESS", "ROBOT", "START", "TOOL", "UNITS", "ZERO"};

}  // namespace

/// One statement, or what an error left of it.
void Parser::statement(Block& block) {
  const std::size_t open = open_blocks_.size();
  try {
    any_statement(block);
  } catch (const SyntaxError&) {
    open_blocks_.resize(open);
    recover();
  }
}

// statement = simple eol | compound .   block = { decl | statement } .
void Parser::any_statement(Block& block) {
  if (at(TokenKind::Reserved) && next_.kind == TokenKind::Assign) {
    fail_here(code::kReservedName,
              fmt::format("{} is a reserved word and cannot be a name", described(current_)),
              "choose another name");
  }
  if (!block_statement(block)) simple(block);
  // At the beginning of a line stands the end of a block, for the rule of that block.
  if (!current_.first_on_line) end_of_line();
}

/// What cannot stand behind THEN on the same line; false if nothing of the kind stands here.
bool Parser::block_statement(Block& block) {
  if (!at(TokenKind::Reserved)) return false;
  switch (current_.keyword) {
    case Keyword::If:
      if_statement(block);
      return true;
    case Keyword::While:
      while_statement(block);
      return true;
    case Keyword::For:
      for_statement(block);
      return true;
    case Keyword::When:
      when_statement(block);
      return true;
    case Keyword::Signal:
      signal_declaration(block);
      return true;
    case Keyword::Use:
      use_statement(block);
      return true;
    case Keyword::Point:
      point_declaration(block);
      return true;
    case Keyword::Record:
      record_declaration(block);
      return true;
    case Keyword::Loop:
      loop_statement(block);
      return true;
    case Keyword::Select:
      select_statement(block);
      return true;
    case Keyword::Try:
      try_statement(block);
      return true;
    case Keyword::With:
      with_statement(block);
      return true;
    case Keyword::Proc:
    case Keyword::Func:
      routine();
      return true;
    case Keyword::Task:
      task();
      return true;
    case Keyword::Test:
      test();
      return true;
    case Keyword::Var:
    case Keyword::Const:
      declaration(block);
      return true;
    default:
      return false;
  }
}

// simple = action | motion [ until ] | wait .
void Parser::simple(Block& block) {
  const Place place = current_.place;
  if (at_motion()) {
    const bool first = current_.first_on_line;
    if (first && !rereading_ && plain_motion(block)) return;
    move(block);
    return behind_motion(block, first);
  }
  if (at(Keyword::Print)) return print(block);
  if (at(Keyword::Wait)) return wait(block);
  if (at(Keyword::Pulse)) return pulse(block);
  if (at(Keyword::Expect)) return expect_statement(block);
  if (at(Keyword::Simulate)) return simulate_statement(block);
  if (at(Keyword::Stop)) {
    advance();
    return add(block, place, Stop{});
  }
  if (at(Keyword::Brake)) {
    advance();
    return add(block, place, Brake{});
  }
  if (at(Keyword::Halt)) return halt_statement(block);
  if (at(Keyword::Ask)) return ask_statement(block);
  if (at(Keyword::Teach)) return teach_statement(block);
  if (at(Keyword::Exit)) {
    advance();
    return add(block, place, Exit{});
  }
  if (at(Keyword::Next)) {
    advance();
    return add(block, place, Next{});
  }
  if (at(Keyword::Return)) return return_statement(block);
  if (at(Keyword::Assert)) return assert_statement(block);
  if (at(Keyword::Raise)) return raise_statement(block);
  if (at(TokenKind::Word)) return word_statement(block);
  if (!at(TokenKind::Reserved)) {
    fail_here(code::kStatementExpected,
              fmt::format("a statement begins with a word, not with {}", described(current_)),
              remedy());
  }
  switch (role(current_.keyword)) {
    case KeywordRole::Closer:
      stray_closer();
    case KeywordRole::Statement:
      fail_here(
          code::kMisplaced,
          fmt::format("{} cannot stand on the line of another statement", described(current_)),
          "begin a new line with it; where it has to depend on a condition, inside a block");
    default:
      fail_here(code::kStatementExpected,
                fmt::format("no statement begins with {}", described(current_)));
  }
}

/// What begins with a word that is not reserved: an assignment, a statement known by its place
/// at the beginning of a line, or a mistake.
void Parser::word_statement(Block& block) {
  if (at_placed_word("ROBOT") || at_placed_word("UNITS") || at_placed_word("LAW")) {
    return header(block);
  }
  if (at_placed_word("FRAME") || at_placed_word("TOOL")) return frame_declaration(block);
  if (at_placed_word("PATH")) return path_statement(block);
  if (at_placed_word("PRESS")) return press_statement(block);
  if (at_placed_word("OVERRIDE")) return override_statement(block);
  if (at_placed_word("LOAD")) return load_statement(block);
  if (in_path() && (at_placed_word("AFTER") || at_placed_word("BEFORE"))) {
    const Place place = current_.place;
    return add(block, place, path_event());
  }
  if (at_placed_word("ZERO")) return zero_statement(block);
  if (at_placed_word("START")) return start_statement(block);
  if (next_.kind == TokenKind::Assign || next_.kind == TokenKind::Equal) return assignment(block);
  if (next_.kind == TokenKind::Dot || next_.kind == TokenKind::LeftBracket) {
    return assignment(block);
  }
  // A call, unless it looks like MOVE( or PRINT( misspelt.
  if (next_.kind == TokenKind::LeftParen &&
      (suggest(current_.text, statement_words()).empty() || names_routine(current_.text))) {
    return call_statement(block);
  }
  unknown_word(block);
}

/// Reports the word, then goes on as if the word that was meant stood there; the line has had its
/// message. The head of a block is taken for one only if its line ends like one: a block opened
/// by mistake would swallow the rest of the program.
void Parser::unknown_word(Block& block) {
  const std::string message = fmt::format("{} is no statement", described(current_));
  if (named_type(current_.text) && next_.kind == TokenKind::Word) {
    report(
        code::kUnknownStatement, current_.place, message,
        fmt::format("a variable is declared so: VAR {}: {}", shortened(next_.text), current_.text));
    advance();
    declare_unknown(block);
    throw SyntaxError{};
  }
  if (!clause_word(current_).empty()) {
    fail_here(code::kUnknownStatement, message, "a clause stands on the line of its motion");
  }
  const std::string_view meant = statement_meant();
  if (meant.empty()) {
    const std::string_view placed = suggest(current_.text, kPlacedWords);
    fail_here(code::kUnknownStatement, message,
              placed.empty() ? "a line begins with a statement's word, or with a name and '='"
                             : did_you_mean(placed));
  }
  report(code::kUnknownStatement, current_.place, message, did_you_mean(meant));
  muted_line_ = current_.place.line;
  const Keyword keyword = find_keyword(meant).value();
  const bool needs_do =
      keyword == Keyword::While || keyword == Keyword::For || keyword == Keyword::With;
  const bool stands_alone = next_.kind == TokenKind::EndOfLine;
  const bool routine = keyword == Keyword::Proc || keyword == Keyword::Func ||
                       keyword == Keyword::Record || keyword == Keyword::Task;
  if (keyword == Keyword::End || (routine && next_.kind != TokenKind::Word) ||
      ((keyword == Keyword::Loop || keyword == Keyword::Try) && !stands_alone) ||
      (needs_do && !line_ends_with(Keyword::Do)) ||
      (keyword == Keyword::If && !line_ends_with(Keyword::Then))) {
    throw SyntaxError{};
  }
  current_.kind = TokenKind::Reserved;
  current_.keyword = keyword;
  if (!at_block_end()) any_statement(block);
}

/// The statement's word nearest to the current one; where it is as near, the end of the open block.
std::string_view Parser::statement_meant() const {
  const std::string_view nearest = suggest(current_.text, statement_words());
  if (nearest.empty() || open_blocks_.empty()) return nearest;
  const std::string_view closer = spelling(open_blocks_.back().closer);
  const bool closes = edit_distance(current_.text, closer) <= edit_distance(current_.text, nearest);
  return closes ? closer : nearest;
}

/// Also a call of another file's routine, which begins like an assignment to a part.
// assign = place "=" expr .
void Parser::assignment(Block& block) {
  const Place place = current_.place;
  Assign assign;
  assign.target = postfix();
  const bool call = std::holds_alternative<Call>(assign.target->node);
  if (call && !at(TokenKind::Assign) && !at(TokenKind::Equal)) {
    return add(block, place, CallStatement{std::move(assign.target)});  // of a USEd file
  }
  if (!at(TokenKind::Assign) && !at(TokenKind::Equal)) {
    fail_here(code::kAssignExpected, fmt::format("'=' expected, not {}", described(current_)));
  }
  if (at(TokenKind::Equal)) {
    report(code::kAssignExpected, current_.place, "'==' compares, it does not assign", "write =");
  }
  advance();
  assign.value = expression();
  add(block, place, std::move(assign));
}

// panel = "PRINT" expr { "," expr } .
void Parser::print(Block& block) {
  const Place place = current_.place;
  Print print;
  advance();
  do {
    print.values.push_back(expression());
  } while (accept(TokenKind::Comma));
  add(block, place, std::move(print));
}

// wait = "WAIT" expr [ "TIMEOUT" expr [ "ELSE" simple ] ] .
void Parser::wait(Block& block) {
  const Place place = current_.place;
  Wait wait;
  advance();
  wait.value = expression();
  if (at_word("TIMEOUT")) {
    advance();
    wait.timeout = expression();
  }
  if (at(Keyword::Else) && !current_.first_on_line) {
    if (wait.timeout == nullptr) {
      fail_here(code::kWordExpected, "ELSE of a WAIT needs a TIMEOUT before it",
                "WAIT part_here TIMEOUT 3s ELSE lift = OFF");
    }
    wait.has_else = true;
    advance();
    alternative(wait.otherwise);
  }
  add(block, place, std::move(wait));
}

/// The one statement behind the ELSE of a WAIT.
void Parser::alternative(Block& block) {
  if (at_line_end()) {
    fail(code::kStatementExpected, behind_previous(), "a statement expected after ELSE");
  }
  const Level level(*this);  // it may be a WAIT with an ELSE of its own
  simple(block);
}

// eol = NL { NL } .
void Parser::end_of_line() {
  if (at_line_end()) return;
  fail_here(code::kLineEndExpected,
            fmt::format("the end of the line expected, not {}", described(current_)), remedy());
}

void Parser::add(Block& block, const Place& place, decltype(Statement::node) node) {
  count_node(place);
  block.push_back({place, std::move(node)});
}

}  // namespace rob::lang
