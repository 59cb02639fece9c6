#include <algorithm>
#include <utility>

#include <fmt/format.h>

#include "lang/syntax/parser_impl.h"
#include "lang/text/ascii.h"
#include "lang/text/codes.h"

/// The parser's rules for PROC, FUNC, RETURN and calls.
namespace rob::lang {

// routine = "PROC" NAME "(" [ parameters ] ")" eol block "ENDPROC" eol
//         | "FUNC" NAME "(" [ parameters ] ")" ":" type eol block "ENDFUNC" eol .
void Parser::routine() {
  const bool function = at(Keyword::Func);
  const OpenBlock open{function ? Keyword::Func : Keyword::Proc,
                       function ? Keyword::Endfunc : Keyword::Endproc, current_.place};
  if (!open_blocks_.empty()) {
    report(code::kMisplaced, current_.place,
           fmt::format("{} can only stand at the top level, outside of all blocks",
                       opener_of(open.closer)),
           fmt::format("move it behind the end of the {} of line {}",
                       opener_of(open_blocks_.front().closer), open_blocks_.front().place.line));
  }
  Routine routine;
  routine.place = open.place;
  routine.function = function;
  advance();
  try {
    routine_header(routine);
    header_end(opener_of(open.closer));
  } catch (const SyntaxError&) {
    routine.sound = false;
    skip_header();
  }
  routine.body = block_of(open);
  routine.end = current_.place;
  routine.whole = !diagnostics_.has_error_between(routine.place, routine.end);
  close(open);
  if (routine.name.empty()) return;
  count_node(routine.place);
  routine.index = routines_.size();
  routines_.push_back(std::move(routine));
}

// parameters = parameter { "," parameter } .
void Parser::routine_header(Routine& routine) {
  const std::string_view word = routine.function ? "FUNC" : "PROC";
  Declaration::Declared name = declared_name(word);
  routine.name = std::move(name.name);
  routine.name_place = name.place;
  if (!at(TokenKind::LeftParen)) {
    fail(code::kBracketExpected, behind_previous(),
         fmt::format("'(' expected after {}", shortened(routine.name)),
         fmt::format("without parameters: {} {}()", word, shortened(routine.name)));
  }
  advance();
  if (!at(TokenKind::RightParen)) {
    do {
      routine.parameters.push_back(parameters());
    } while (accept(TokenKind::Comma));
  }
  close_bracket("the parameters");
  if (routine.function) {
    if (!accept(TokenKind::Colon)) {
      fail(code::kWordExpected, behind_previous(), "':' and the type of the value expected",
           "a routine without a value is a PROC");
    }
    routine.result = type();
  } else if (at(TokenKind::Colon)) {
    fail_here(code::kLineEndExpected, "a PROC has no value", "a routine with a value is a FUNC");
  }
}

// parameter = [ "REF" ] NAME { "," NAME } ":" type [ "=" expr ] .
Routine::Parameters Parser::parameters() {
  Routine::Parameters group;
  group.by_reference = at_word("REF") && next_.kind == TokenKind::Word;
  if (group.by_reference) advance();
  do {
    count_node(current_.place);
    group.names.push_back(declared_name("the parenthesis"));
  } while (accept(TokenKind::Comma));
  if (!accept(TokenKind::Colon)) {
    fail(code::kWordExpected, behind_previous(), "':' and a type expected after the parameter",
         fmt::format("for example {}: LENGTH", shortened(group.names.back().name)));
  }
  group.type = type();
  if (accept(TokenKind::Assign)) group.value = expression();
  return group;
}

// call = NAME "(" [ argument { "," argument } ] ")" .
void Parser::call_statement(Block& block) {
  const Place place = current_.place;
  CallStatement node;
  node.call = postfix();
  add(block, place, std::move(node));
}

// control = "RETURN" [ expr ] .
void Parser::return_statement(Block& block) {
  const Place place = current_.place;
  Return node;
  advance();
  if (!at_line_end()) node.value = expression();
  add(block, place, std::move(node));
}

/// The names behind PROC, FUNC, TASK and RECORD anywhere in the text.
const Parser::DefinedNames& Parser::defined_names() {
  if (defined_names_) return *defined_names_;
  defined_names_.emplace();
  Lexer lexer = Lexer(source_, diagnostics_).quiet_copy();
  std::set<std::string>* names = nullptr;
  for (Token token = lexer.next(); token.kind != TokenKind::EndOfFile; token = lexer.next()) {
    if (names != nullptr && token.kind == TokenKind::Word) names->insert(to_upper(token.text));
    names = nullptr;
    if (token.kind != TokenKind::Reserved) continue;
    const bool routine = token.keyword == Keyword::Proc || token.keyword == Keyword::Func ||
                         token.keyword == Keyword::Task;
    if (routine) names = &defined_names_->routines;
    if (token.keyword == Keyword::Record) names = &defined_names_->records;
  }
  return *defined_names_;
}

/// Whether a PROC, FUNC or TASK of this name stands anywhere in the text, or in a file that it
/// USEs.
bool Parser::names_routine(std::string_view name) {
  const auto named = [&](const Routine& routine) { return same_word(routine.name, name); };
  // Where the files that are USEd are not read, as by the formatter, it may be one of theirs.
  if (imports_.empty() && !outline_.uses.empty()) return true;
  return defined_names().routines.contains(to_upper(name)) ||
         std::ranges::any_of(imports_, [&](const Import& import) {
           return std::ranges::any_of(import.program->routines, named);
         });
}

bool Parser::names_record(std::string_view name) {
  return defined_names().records.contains(to_upper(name)) ||
         types_->records.contains({file_, to_upper(name)});
}

}  // namespace rob::lang
