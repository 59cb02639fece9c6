#include "lang/syntax/block_parser.h"

#include <algorithm>
#include <array>
#include <iterator>
#include <utility>

#include <fmt/format.h>

#include "lang/syntax/keywords.h"
#include "lang/text/ascii.h"
#include "lang/text/codes.h"

namespace rob::lang {

namespace {

/// Words that cannot stand on the line of THEN.
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

}  // namespace

// "IF" expr "THEN" simple eol
// "IF" expr "THEN" eol block { "ELSIF" expr "THEN" eol block } [ "ELSE" eol block ] "ENDIF" eol
void BlockParser::if_statement(Block& block) {
  const OpenBlock open{Keyword::Endif, tokens_.place()};
  If node;
  tokens_.advance();
  node.branches.push_back({blocks_.condition(Keyword::Then), {}});
  Block& body = node.branches.back().body;
  if (tokens_.at_line_end()) {
    body = blocks_.read(open);
    further_branches(node, open);
    blocks_.close(open);
  } else {
    behind_then(body);
  }
  tree_.add(block, open.place, std::move(node));
}

/// A statement on the line of a CASE. Where it cannot be read the next lines are.
void BlockParser::on_line_of(std::string_view word, Block& body) {
  try {
    if (tokens_.at(TokenKind::Reserved) && takes_lines(tokens_.current().keyword)) {
      tokens_.fail_here(
          code::kLineEndExpected,
          fmt::format("{} cannot stand on the line of {}", described(tokens_.current()), word),
          "begin a new line before it");
    }
    statements_.simple(body);
    tokens_.end_of_line();
  } catch (const SyntaxError&) {
    tokens_.skip_line();
  }
}

/// The one statement on the line of THEN.
void BlockParser::behind_then(Block& body) {
  if (tokens_.at(TokenKind::Reserved) && takes_lines(tokens_.current().keyword)) {
    tokens_.fail_here(
        code::kLineEndExpected,
        fmt::format("{} cannot stand on the line of THEN", spelling(tokens_.current().keyword)),
        "begin a new line after THEN, and close with ENDIF");
  }
  statements_.simple(body);
  if (tokens_.at(Keyword::Else)) {
    tokens_.fail_here(code::kLineEndExpected, "an IF with ELSE takes several lines",
                      "begin new lines after THEN and around ELSE, and close with ENDIF");
  }
  if (tokens_.at(Keyword::Endif)) {
    tokens_.fail_here(code::kLineEndExpected, "an IF on one line has no ENDIF", "leave ENDIF out");
  }
}

void BlockParser::further_branches(If& node, const OpenBlock& open) {
  bool had_else = false;
  while (tokens_.at(Keyword::Elsif) || tokens_.at(Keyword::Else)) {
    const Place place = tokens_.place();
    const std::string_view word = spelling(tokens_.current().keyword);
    const bool split =
        tokens_.next().kind == TokenKind::Reserved && tokens_.next().keyword == Keyword::If;
    if (had_else) {
      tokens_.report(code::kStrayCloser, place,
                     fmt::format("{} after the ELSE of the IF of line {}", word, open.place.line));
    } else if (tokens_.at(Keyword::Else) && split) {
      tokens_.report(code::kLineEndExpected, place, "ELSE IF is written as one word",
                     "write ELSIF");
    }
    const bool conditional = tokens_.at(Keyword::Elsif) || split;
    if (tokens_.at(Keyword::Else) && split) tokens_.advance();
    tokens_.advance();
    if (conditional) {
      node.branches.push_back({blocks_.condition(Keyword::Then), {}});
      node.branches.back().body = blocks_.read(open);
    } else {
      had_else = node.has_else = true;
      node.otherwise = blocks_.read(open);
    }
  }
}

// "WHILE" expr "DO" eol block "ENDWHILE" eol
void BlockParser::while_statement(Block& block) {
  const OpenBlock open{Keyword::Endwhile, tokens_.place()};
  While loop;
  tokens_.advance();
  loop.condition = blocks_.condition(Keyword::Do);
  loop.body = blocks_.read(open);
  blocks_.close(open);
  tree_.add(block, open.place, std::move(loop));
}

// "FOR" IDENT ( "=" expr "TO" expr [ "STEP" expr ] | "IN" expr ) "DO" eol block "ENDFOR" eol
void BlockParser::for_statement(Block& block) {
  const OpenBlock open{Keyword::Endfor, tokens_.place()};
  For loop;
  tokens_.advance();
  try {
    for_header(loop);
  } catch (const SyntaxError&) {
    tokens_.recover_until(Keyword::Do);
    const NumberLiteral one{.value = 1, .integer = 1, .is_integer = true, .dimension = {}};
    loop.elements = nullptr;
    if (!loop.from) loop.from = TreeBuilder::stand_in(open.place, one);
    if (!loop.to) loop.to = TreeBuilder::stand_in(open.place, one);
  }
  loop.body = blocks_.read(open);
  blocks_.close(open);
  tree_.add(block, open.place, std::move(loop));
}

void BlockParser::for_header(For& loop) {
  Declaration::Declared variable = names_.declared("FOR");
  loop.variable = std::move(variable.name);
  loop.variable_place = variable.place;
  if (tokens_.at(Keyword::In)) {
    tokens_.advance();
    loop.elements = expressions_.expression();
    return blocks_.header_word(Keyword::Do, "what FOR goes through");
  }
  if (!tokens_.accept(TokenKind::Assign)) {
    tokens_.fail_here(code::kAssignExpected,
                      fmt::format("'=' expected after {}", shortened(loop.variable)));
  }
  loop.from = expressions_.expression();
  if (!tokens_.at_word("TO")) {
    tokens_.fail_behind(code::kWordExpected, "TO expected after the first value of FOR",
                        "FOR i = 1 TO 10 DO");
  }
  tokens_.advance();
  loop.to = expressions_.expression();
  if (tokens_.at_word("STEP")) {
    tokens_.advance();
    loop.step = expressions_.expression();
  }
  blocks_.header_word(Keyword::Do, "the values of FOR");
}

// "LOOP" eol block "ENDLOOP" eol
void BlockParser::loop_statement(Block& block) {
  const OpenBlock open{Keyword::Endloop, tokens_.place()};
  Loop loop;
  tokens_.advance();
  blocks_.header_end("LOOP");
  loop.body = blocks_.read(open);
  blocks_.close(open);
  tree_.add(block, open.place, std::move(loop));
}

// "SELECT" expr eol { "CASE" expr { "," expr } ":" [ simple ] eol block } [ "ELSE" eol block ]
// "ENDSELECT" eol
void BlockParser::select_statement(Block& block) {
  const OpenBlock open{Keyword::Endselect, tokens_.place()};
  Select node;
  tokens_.advance();
  try {
    node.selector = expressions_.expression();
    blocks_.header_end("SELECT");
  } catch (const SyntaxError&) {
    tokens_.skip_line();
  }
  const Block before = blocks_.read(open);
  if (!before.empty()) {
    tokens_.report(code::kMisplaced, before.front().place,
                   "nothing may stand between SELECT and CASE",
                   "move it after a CASE, or before SELECT");
  }
  select_branches(node, open);
  blocks_.close(open);
  tree_.add(block, open.place, std::move(node));
}

void BlockParser::select_branches(Select& node, const OpenBlock& open) {
  while (tokens_.at(Keyword::Case) || tokens_.at(Keyword::Else)) {
    if (node.has_else) {
      tokens_.report(code::kStrayCloser, tokens_.place(),
                     fmt::format("{} after the ELSE of the SELECT of line {}",
                                 spelling(tokens_.current().keyword), open.place.line),
                     "ELSE stands last");
    }
    if (tokens_.at(Keyword::Case)) {
      node.cases.push_back({tokens_.place(), {}, {}});
      Select::Case& branch = node.cases.back();
      tokens_.advance();
      case_values(branch);
      if (!tokens_.at_line_end()) on_line_of("CASE", branch.body);
      std::ranges::move(blocks_.read(open), std::back_inserter(branch.body));
    } else {
      tokens_.advance();
      tokens_.accept(TokenKind::Colon);  // as after CASE; it changes nothing
      blocks_.header_end("ELSE");
      node.has_else = true;
      node.otherwise = blocks_.read(open);
    }
  }
}

void BlockParser::case_values(Select::Case& branch) {
  try {
    do {
      branch.values.push_back(expressions_.expression());
    } while (tokens_.accept(TokenKind::Comma));
    if (!tokens_.accept(TokenKind::Colon)) {
      tokens_.fail_behind(code::kWordExpected, "':' expected after the values of CASE",
                          tokens_.remedy());
    }
  } catch (const SyntaxError&) {
    tokens_.skip_line();
  }
}

// "TRY" eol block "RESCUE" [ NAME ] eol block "ENDTRY" eol
void BlockParser::try_statement(Block& block) {
  const OpenBlock open{Keyword::Endtry, tokens_.place()};
  Try node;
  tokens_.advance();
  blocks_.header_end("TRY");
  node.body = blocks_.read(open);
  if (tokens_.at(Keyword::Rescue)) {
    rescue_header(node);
    node.rescue = blocks_.read(open);
    while (tokens_.at(Keyword::Rescue)) {
      tokens_.report(code::kStrayCloser, tokens_.place(),
                     fmt::format("a second RESCUE in the TRY of line {}", open.place.line),
                     "one RESCUE handles all errors; IF and SELECT distinguish them");
      rescue_header(node);
      blocks_.read(open);
    }
  } else if (tokens_.at(Keyword::Endtry)) {
    tokens_.report(code::kRescueMissing, tokens_.place(),
                   fmt::format("the TRY of line {} has no RESCUE", open.place.line),
                   "RESCUE, on a line of its own, begins what is done when something goes wrong");
  }
  blocks_.close(open);
  tree_.add(block, open.place, std::move(node));
}

void BlockParser::rescue_header(Try& node) {
  tokens_.advance();
  if (!tokens_.at_line_end()) {
    try {
      node.why = names_.declared("RESCUE");
    } catch (const SyntaxError&) {
      return tokens_.skip_line();
    }
  }
  blocks_.header_end("RESCUE");
}

// "WITH" ( IDENT | clause ) { clause } "DO" eol block "ENDWITH" eol
void BlockParser::with_statement(Block& block) {
  const OpenBlock open{Keyword::Endwith, tokens_.place()};
  With node;
  blocks_.header_up_to_do([&] { clauses_.with_header(node.clauses); });
  node.body = blocks_.read(open);
  blocks_.close(open);
  tree_.add(block, open.place, std::move(node));
}

// "ALLOW" IDENT { "," IDENT } "DO" eol block "ENDALLOW" eol
void BlockParser::allow_statement(Block& block) {
  const OpenBlock open{Keyword::Endallow, tokens_.place()};
  if (!tokens_.current().first_on_line) {
    tokens_.fail_here(code::kMisplaced, "ALLOW cannot stand on the line of another statement",
                      "begin a new line before it");
  }
  Allow node;
  blocks_.header_up_to_do([&] {
    tokens_.advance();
    do {
      node.bodies.push_back(allowed_body());
    } while (tokens_.accept(TokenKind::Comma));
  });
  node.body = blocks_.read(open);
  blocks_.close(open);
  tree_.add(block, open.place, std::move(node));
}

Declaration::Declared BlockParser::allowed_body() {
  if (!tokens_.at(TokenKind::Word)) {
    tokens_.fail_here(code::kNameExpected,
                      fmt::format("the name of a body expected after ALLOW, not {}",
                                  described(tokens_.current())),
                      "ALLOW gripper, part DO");
  }
  Declaration::Declared body{std::string(tokens_.text()), tokens_.place()};
  tokens_.advance();
  return body;
}

// "PATH" { clause } "DO" eol pathblock "ENDPATH" eol
void BlockParser::path_statement(Block& block) {
  const OpenBlock open{Keyword::Endpath, tokens_.place()};
  if (!tokens_.current().first_on_line) {
    tokens_.fail_here(code::kMisplaced, "PATH cannot stand on the line of another statement",
                      "begin a new line before it");
  }
  PathBlock node;
  blocks_.header_up_to_do([&] {
    tokens_.advance();
    clauses_.clauses(node.clauses);
  });
  node.body = blocks_.read(open);
  blocks_.close(open);
  tree_.add(block, open.place, std::move(node));
}

// "PRESS" IDENT expr [ "LIMIT" expr ] [ "IN" refframe ] "DO" eol block "ENDPRESS" eol
void BlockParser::press_statement(Block& block) {
  const OpenBlock open{Keyword::Endpress, tokens_.place()};
  if (!tokens_.current().first_on_line) {
    tokens_.fail_here(code::kMisplaced, "PRESS cannot stand on the line of another statement",
                      "begin a new line before it");
  }
  Press node;
  blocks_.header_up_to_do([&] { press_header(node); });
  node.body = blocks_.read(open);
  blocks_.close(open);
  tree_.add(block, open.place, std::move(node));
}

void BlockParser::press_header(Press& press) {
  constexpr std::array<std::string_view, 3> kAxes{"X", "Y", "Z"};
  tokens_.advance();
  press.axis = -1;
  for (std::size_t i = 0; i < kAxes.size(); ++i) {
    if (tokens_.at_word(kAxes[i])) press.axis = static_cast<int>(i);
  }
  if (press.axis < 0) {
    tokens_.fail_here(
        code::kNoPressAxis,
        fmt::format("PRESS needs the axis X, Y or Z, not {}", described(tokens_.current())),
        "PRESS Z 10N DO");
  }
  tokens_.advance();
  press.force = expressions_.expression();
  if (tokens_.at_word("LIMIT")) {
    tokens_.advance();
    press.limit = expressions_.expression();
  }
  if (tokens_.at(Keyword::In)) clauses_.in_frame(press.surroundings);
}

}  // namespace rob::lang
