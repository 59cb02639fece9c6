#include "lang/syntax/routine_parser.h"

#include <utility>

#include <fmt/format.h>

#include "lang/syntax/keywords.h"
#include "lang/text/ascii.h"
#include "lang/text/codes.h"

namespace rob::lang {

namespace {

/// `opener`: the word that a routine begins with.
Keyword closer_of(Keyword opener) {
  switch (opener) {
    case Keyword::Func:
      return Keyword::Endfunc;
    case Keyword::Task:
      return Keyword::Endtask;
    case Keyword::Test:
      return Keyword::Endtest;
    default:
      return Keyword::Endproc;
  }
}

}  // namespace

// routine = "PROC" NAME "(" [ parameters ] ")" eol block "ENDPROC" eol
//         | "FUNC" NAME "(" [ parameters ] ")" ":" type eol block "ENDFUNC" eol
//         | "TASK" IDENT eol block "ENDTASK" eol
//         | "TEST" STRING eol block "ENDTEST" eol .
void RoutineParser::routine() {
  const OpenBlock open{closer_of(tokens_.current().keyword), tokens_.place()};
  const std::string_view word = opener_of(open.closer);
  blocks_.check_routine(word);
  Routine routine;
  routine.place = open.place;
  routine.function = tokens_.at(Keyword::Func);
  routine.task = tokens_.at(Keyword::Task);
  routine.test = tokens_.at(Keyword::Test);
  tokens_.advance();
  try {
    header(routine);
    blocks_.header_end(word);
  } catch (const SyntaxError&) {
    routine.sound = false;
    keep_named_parameters(routine);
  }
  routine.body = blocks_.read(open);
  routine.end = tokens_.place();
  routine.whole = !tokens_.has_error_between(routine.place, routine.end);
  blocks_.close(open);
  if (routine.name.empty() && !routine.test) return;
  tree_.count(routine.place);
  keep(std::move(routine));
}

void RoutineParser::header(Routine& routine) {
  if (routine.test) return test_header(routine);
  Declaration::Declared name = names_.declared(routine.task       ? "TASK"
                                               : routine.function ? "FUNC"
                                                                  : "PROC");
  routine.name = std::move(name.name);
  routine.name_place = name.place;
  routine.task ? task_header() : proc_or_func_header(routine);
}

void RoutineParser::test_header(Routine& test) {
  if (!tokens_.at(TokenKind::String)) {
    tokens_.fail_here(
        code::kNameExpected,
        fmt::format("the name of the TEST expected, not {}", described(tokens_.current())),
        "TEST \"the lift comes up\"");
  }
  test.name = tokens_.current().string;
  test.name_place = tokens_.place();
  tokens_.advance();
}

void RoutineParser::task_header() {
  if (!tokens_.at(TokenKind::LeftParen)) return;
  tokens_.fail_here(code::kLineEndExpected, "a TASK has no parameters",
                    "it sees the variables of the program's top level");
}

// parameters = parameter { "," parameter } .
void RoutineParser::proc_or_func_header(Routine& routine) {
  if (!tokens_.at(TokenKind::LeftParen)) {
    tokens_.fail_behind(code::kBracketExpected,
                        fmt::format("'(' expected after {}", shortened(routine.name)),
                        fmt::format("without parameters: {} {}()",
                                    routine.function ? "FUNC" : "PROC", shortened(routine.name)));
  }
  tokens_.advance();
  if (!tokens_.at(TokenKind::RightParen)) {
    do {
      Routine::Parameters group = parameters(routine);
      if (!group.names.empty()) routine.parameters.push_back(std::move(group));
    } while (tokens_.accept(TokenKind::Comma));
  }
  expressions_.close_bracket("the parameters");
  if (routine.function) {
    if (!tokens_.accept(TokenKind::Colon)) {
      tokens_.fail_behind(code::kWordExpected, "':' and the type of the value expected",
                          "a routine without a value is a PROC");
    }
    routine.result = types_.type();
  } else if (tokens_.at(TokenKind::Colon)) {
    tokens_.fail_here(code::kLineEndExpected, "a PROC has no value",
                      "a routine with a value is a FUNC");
  }
}

// parameter = [ "REF" ] NAME { "," NAME } ":" type [ "=" expr ] .
void RoutineParser::read_parameters(Routine::Parameters& group) {
  const TokenKind next = tokens_.next().kind;
  group.by_reference =
      tokens_.at_word("REF") && (next == TokenKind::Word || next == TokenKind::Reserved);
  if (group.by_reference) tokens_.advance();
  do {
    tree_.count(tokens_.place());
    group.names.push_back(names_.declared("the parenthesis"));
  } while (tokens_.accept(TokenKind::Comma));
  if (!tokens_.accept(TokenKind::Colon)) {
    tokens_.fail_behind(code::kWordExpected, "':' and a type expected after the parameter",
                        fmt::format("for example {}: LENGTH", shortened(group.names.back().name)));
  }
  group.type = types_.type();
  if (tokens_.accept(TokenKind::Assign)) group.value = expressions_.expression();
}

/// Where a parameter cannot be read its name is known all the same, with any type.
Routine::Parameters RoutineParser::parameters(Routine& routine) {
  Routine::Parameters group;
  try {
    read_parameters(group);
  } catch (const SyntaxError&) {
    routine.sound = false;
    group.type = {};
    group.value = nullptr;
    tokens_.misname();
    skip_parameters();
  }
  return group;
}

/// To the comma or the bracket after a faulty parameter, or to the end of the line.
void RoutineParser::skip_parameters() {
  int open = 0;
  for (; !tokens_.at_line_end(); tokens_.advance()) {
    const bool opens = tokens_.at(TokenKind::LeftParen) || tokens_.at(TokenKind::LeftBracket);
    const bool closes = tokens_.at(TokenKind::RightParen) || tokens_.at(TokenKind::RightBracket);
    if (open == 0 && (closes || tokens_.at(TokenKind::Comma))) return;
    open += opens ? 1 : closes ? -1 : 0;
  }
}

/// The rest of a header that could not be read: its parameters are known, with any type.
void RoutineParser::keep_named_parameters(Routine& routine) {
  for (; !tokens_.at_line_end(); tokens_.advance()) {
    const bool named = tokens_.at(TokenKind::Word) && tokens_.next().kind == TokenKind::Colon;
    if (!named || routine.name.empty()) continue;
    Routine::Parameters group;
    group.names.push_back({.name = std::string(tokens_.text()), .place = tokens_.place()});
    routine.parameters.push_back(std::move(group));
  }
  tokens_.skip_line();
}

void RoutineParser::add_unread(const Place& place, const Token& name) {
  Routine routine;
  routine.place = place;
  routine.end = place;
  routine.name = std::string(name.text);
  routine.name_place = name.place;
  routine.sound = routine.whole = false;
  keep(std::move(routine));
}

void RoutineParser::add_handler(const Place& place, const Place& end) {
  Routine routine;
  routine.place = place;
  routine.end = end;
  routine.handler = true;
  routine.name = "WHEN";
  keep(std::move(routine));
}

void RoutineParser::keep(Routine routine) {
  routine.index = routines_.size();
  routines_.push_back(std::move(routine));
}

}  // namespace rob::lang
