#include "lang/syntax/statement_parser.h"

#include <algorithm>
#include <utility>

#include <fmt/format.h>

#include "lang/syntax/clause_words.h"
#include "lang/syntax/declarations.h"
#include "lang/syntax/keywords.h"
#include "lang/syntax/named_types.h"
#include "lang/text/ascii.h"
#include "lang/text/codes.h"
#include "lang/text/suggest.h"
#include "lang/values/builtins.h"

namespace rob::lang {

StatementParser::StatementParser(TokenReader& tokens, TreeBuilder& tree, TextNames& names,
                                 ExpressionParser& expressions, TypeParser& types,
                                 PlainMotionsAs plain_motions)
    : tokens_(tokens),
      tree_(tree),
      names_(names),
      plain_motions_(plain_motions),
      blocks_(tokens, expressions, *this),
      header_(tokens),
      declarations_(tokens, tree, names, expressions, types, blocks_),
      routines_(tokens, tree, names, expressions, types, blocks_),
      clauses_(tokens, tree, expressions),
      motions_(tokens, tree, expressions, clauses_),
      block_statements_(tokens, tree, names, expressions, clauses_, blocks_, *this),
      watches_(tokens, tree, names, expressions, blocks_, routines_, *this),
      actions_(tokens, tree, names, expressions),
      hints_(tokens, names, routines_) {}

void StatementParser::finish(Program& program) {
  program.header = header_.read();
  program.taught = actions_.take_taught();
  program.surroundings = clauses_.any_surroundings();
  program.routines = routines_.take();
}

void StatementParser::statement(Block& block) {
  try {
    any_statement(block);
  } catch (const SyntaxError&) {
    tokens_.recover();
  }
}

void StatementParser::value_alone(Block& block) {
  try {
    actions_.value_alone(block);
    tokens_.end_of_line();
  } catch (const SyntaxError&) {
    tokens_.recover();
  }
}

// statement = simple eol | compound .   block = { decl | statement } .
void StatementParser::any_statement(Block& block) {
  if (hints_.skip()) return;
  if (tokens_.at(TokenKind::Reserved) && tokens_.next().kind == TokenKind::Assign) {
    tokens_.fail_reserved();
  }
  if (!block_statement(block)) simple(block);
  // At the beginning of a line stands the end of a block, for the rule of that block.
  if (!tokens_.current().first_on_line) tokens_.end_of_line();
}

/// Reads a statement that cannot stand after THEN on the same line; false if none stands here.
bool StatementParser::block_statement(Block& block) {
  if (!tokens_.at(TokenKind::Reserved)) return false;
  switch (tokens_.current().keyword) {
    case Keyword::If:
      block_statements_.if_statement(block);
      return true;
    case Keyword::While:
      block_statements_.while_statement(block);
      return true;
    case Keyword::For:
      block_statements_.for_statement(block);
      return true;
    case Keyword::When:
      watches_.when(block);
      return true;
    case Keyword::Signal:
      declarations_.signal(block);
      return true;
    case Keyword::Use:
      declarations_.use(block);
      return true;
    case Keyword::Point:
      declarations_.point(block);
      return true;
    case Keyword::Record:
      declarations_.record(block);
      return true;
    case Keyword::Loop:
      block_statements_.loop_statement(block);
      return true;
    case Keyword::Select:
      block_statements_.select_statement(block);
      return true;
    case Keyword::Try:
      block_statements_.try_statement(block);
      return true;
    case Keyword::With:
      block_statements_.with_statement(block);
      return true;
    case Keyword::Proc:
    case Keyword::Func:
    case Keyword::Task:
    case Keyword::Test:
      routines_.routine();
      return true;
    case Keyword::Var:
    case Keyword::Const:
      declarations_.variables(block);
      return true;
    default:
      return false;
  }
}

// simple = action | motion [ until ] | wait .
void StatementParser::simple(Block& block) {
  if (motions_.at_motion()) return motion(block);
  if (tokens_.at(Keyword::Wait)) return watches_.wait(block);
  if (tokens_.at(TokenKind::Word)) return word_statement(block);
  if (!actions_.reserved(block)) fail_statement();
}

void StatementParser::motion(Block& block) {
  const bool first = tokens_.current().first_on_line;
  // The clauses of a PATH are its own.
  const bool plain = first && plain_motions_ == PlainMotionsAs::Numbers && !blocks_.in_path();
  if (plain && motions_.plain_motion(block)) return;
  motions_.move(block);
  watches_.behind_motion(block, first);
}

/// No statement stands here.
void StatementParser::fail_statement() {
  const std::string found = described(tokens_.current());
  if (!tokens_.at(TokenKind::Reserved)) {
    tokens_.fail_here(code::kStatementExpected,
                      fmt::format("a statement begins with a word, not with {}", found),
                      tokens_.remedy());
  }
  switch (role(tokens_.current().keyword)) {
    case KeywordRole::Closer:
      blocks_.fail_stray_closer();
    case KeywordRole::Statement:
      tokens_.fail_here(
          code::kMisplaced, fmt::format("{} cannot stand on the line of another statement", found),
          "begin a new line with it; where it has to depend on a condition, inside a block");
    default:
      tokens_.fail_here(code::kStatementExpected,
                        fmt::format("no statement begins with {}", found));
  }
}

/// A statement that begins with a word that is not reserved: an assignment, a statement known by
/// its place at the beginning of a line, or a mistake.
void StatementParser::word_statement(Block& block) {
  if (at_placed_word("ROBOT") || at_placed_word("UNITS") || at_placed_word("LAW")) {
    return header_.header(block, !blocks_.none());
  }
  if (at_placed_word("DEFAULT") && tokens_.next().kind != TokenKind::LeftParen) {
    return default_statement(block);
  }
  if (at_placed_word("FRAME") || at_placed_word("TOOL")) return declarations_.frame_or_tool(block);
  if (at_placed_word("ENUM")) return declarations_.enumeration(block);
  if (tokens_.at_word("ENDALLOW") && tokens_.next().kind == TokenKind::EndOfLine) {
    tokens_.take_for(Keyword::Endallow);
    blocks_.fail_stray_closer();
  }
  if (at_naming_word("OBSTACLE")) return declarations_.obstacle(block);
  if (at_naming_word("ALLOW")) return block_statements_.allow_statement(block);
  if (at_placed_word("PATH")) return block_statements_.path_statement(block);
  if (at_placed_word("PRESS")) return block_statements_.press_statement(block);
  if (at_placed_word("OVERRIDE")) return actions_.override_statement(block);
  if (at_placed_word("LOAD")) return actions_.load_statement(block);
  if (blocks_.in_path() && (at_placed_word("AFTER") || at_placed_word("BEFORE"))) {
    const Place place = tokens_.place();
    return tree_.add(block, place, watches_.path_event());
  }
  if (at_file_word("PERSIST")) return declarations_.persist(block);
  if (at_file_word("DEVICE")) return declarations_.device(block);
  if (at_file_word("SEND")) return actions_.send_statement(block);
  if (at_file_word("RECEIVE")) return watches_.receive(block);
  if (at_file_word("READ")) return actions_.read_statement(block);
  if (at_file_word("WRITE")) return actions_.write_statement(block);
  if (at_placed_word("ZERO")) return actions_.zero_statement(block);
  if (at_placed_word("START")) return actions_.start_statement(block);
  switch (tokens_.next().kind) {
    case TokenKind::Assign:
    case TokenKind::PlusAssign:
    case TokenKind::MinusAssign:
    case TokenKind::StarAssign:
    case TokenKind::SlashAssign:
    case TokenKind::Equal:
    case TokenKind::Dot:
    case TokenKind::LeftBracket:
      return actions_.assignment(block);
    case TokenKind::LeftParen:
      return looks_misspelt() ? unknown_word(block) : actions_.call_statement(block);
    default:
      return unknown_word(block);
  }
}

// "DEFAULT" clause { clause } eol
void StatementParser::default_statement(Block& block) {
  const Place place = tokens_.place();
  if (!blocks_.none() || !std::ranges::all_of(block, is_declaration)) {
    tokens_.fail(code::kHeaderTooLate, place,
                 "DEFAULT holds for the whole program and must stand before its first statement",
                 "move it to the beginning; WITH … DO gives the motions of a block their own");
  }
  tokens_.advance();
  if (tokens_.at_line_end()) {
    tokens_.fail_behind(code::kWordExpected, "a clause expected after DEFAULT",
                        "DEFAULT AT 200mm/s ZONE 1mm ACCEL 50%");
  }
  Defaults node;
  clauses_.clauses(node.clauses);
  tree_.add(block, place, std::move(node));
}

/// MOVE( or PRINT(, nearly, where no routine is called so.
bool StatementParser::looks_misspelt() {
  return find_builtin(tokens_.text(), 1) == nullptr &&
         !suggest(tokens_.text(), statement_words()).empty() &&
         !names_.names_routine(tokens_.text());
}

/// A word that begins a statement by its place alone, and is a name where something is made of it:
/// before a parenthesis, where a routine is called so.
bool StatementParser::at_placed_word(std::string_view word) {
  if (!tokens_.at_word(word)) return false;
  switch (tokens_.next().kind) {
    case TokenKind::Assign:
    case TokenKind::PlusAssign:
    case TokenKind::MinusAssign:
    case TokenKind::StarAssign:
    case TokenKind::SlashAssign:
    case TokenKind::Equal:
    case TokenKind::Dot:
    case TokenKind::LeftBracket:
      return false;
    case TokenKind::LeftParen:
      return !names_.names_routine(word);
    default:
      return true;
  }
}

/// The same, but before a parenthesis it is a name, too.
bool StatementParser::at_file_word(std::string_view word) {
  return tokens_.next().kind != TokenKind::LeftParen && at_placed_word(word);
}

/// A word that begins a statement before a name alone.
bool StatementParser::at_naming_word(std::string_view word) {
  return tokens_.at_word(word) && tokens_.next().kind == TokenKind::Word;
}

/// Reports the word, then goes on as if the word that was meant stood there; the line has had its
/// message. The head of a block is taken for one only if its line ends like one: a block opened
/// by mistake would swallow the rest of the program.
void StatementParser::unknown_word(Block& block) {
  const std::string message = fmt::format("{} is no statement", described(tokens_.current()));
  if (named_type(tokens_.text()) != nullptr && tokens_.next().kind == TokenKind::Word) {
    tokens_.report(code::kUnknownStatement, tokens_.place(), message,
                   fmt::format("a variable is declared so: VAR {}: {}",
                               shortened(tokens_.next().text), tokens_.text()));
    tokens_.advance();
    declarations_.unknown(block);
    throw SyntaxError{};
  }
  if (!clause_word(tokens_.current()).empty()) {
    tokens_.fail_here(code::kUnknownStatement, message,
                      "a clause stands on the line of its motion");
  }
  const std::string_view meant = statement_meant();
  if (meant.empty()) {
    const std::string_view placed = suggest(tokens_.text(), kPlacedWords);
    tokens_.fail_here(code::kUnknownStatement, message,
                      placed.empty()
                          ? "a line begins with a statement's word, or with a name and '='"
                          : did_you_mean(placed));
  }
  tokens_.report(code::kUnknownStatement, tokens_.place(), message, did_you_mean(meant));
  tokens_.mute_line();
  const auto reserved = find_keyword(meant);
  const Keyword keyword = reserved ? *reserved : Keyword::Endallow;
  if (!can_stand_for(keyword)) throw SyntaxError{};
  tokens_.take_for(keyword);
  if (!blocks_.at_closer()) any_statement(block);
}

/// Whether the line goes on as after `keyword`, for which its word may have been meant.
bool StatementParser::can_stand_for(Keyword keyword) const {
  switch (keyword) {
    case Keyword::End:
      return false;
    case Keyword::Proc:
    case Keyword::Func:
    case Keyword::Record:
    case Keyword::Task:
      return tokens_.next().kind == TokenKind::Word;
    case Keyword::Loop:
    case Keyword::Try:
      return tokens_.next().kind == TokenKind::EndOfLine;
    case Keyword::While:
    case Keyword::For:
    case Keyword::With:
      return tokens_.line_ends_with(Keyword::Do);
    case Keyword::If:
      return tokens_.line_ends_with(Keyword::Then);
    default:
      return true;
  }
}

/// The statement's word nearest to the current one; where it is as near, the end of the open block.
std::string_view StatementParser::statement_meant() const {
  const std::string_view nearest = suggest(tokens_.text(), statement_words());
  if (nearest.empty() || blocks_.none()) return nearest;
  const std::string_view closer = spelling(blocks_.innermost_closer());
  const bool closes =
      edit_distance(tokens_.text(), closer) <= edit_distance(tokens_.text(), nearest);
  return closes ? closer : nearest;
}

}  // namespace rob::lang
