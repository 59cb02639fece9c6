#include "lang/syntax/action_parser.h"

#include <optional>
#include <utility>

#include <fmt/format.h>

#include "lang/syntax/keywords.h"
#include "lang/text/ascii.h"
#include "lang/text/codes.h"
#include "lang/text/utf8.h"

namespace rob::lang {

namespace {

std::optional<BinaryOp> compound_operation(TokenKind kind) {
  switch (kind) {
    case TokenKind::PlusAssign:
      return BinaryOp::Add;
    case TokenKind::MinusAssign:
      return BinaryOp::Subtract;
    case TokenKind::StarAssign:
      return BinaryOp::Multiply;
    case TokenKind::SlashAssign:
      return BinaryOp::Divide;
    default:
      return std::nullopt;
  }
}

constexpr const char* kSimulateExample = "SIMULATE part_here = ON AFTER 2s";

}  // namespace

bool ActionParser::reserved(Block& block) {
  if (!tokens_.at(TokenKind::Reserved)) return false;
  switch (tokens_.current().keyword) {
    case Keyword::Print:
      print(block);
      return true;
    case Keyword::Pulse:
      pulse(block);
      return true;
    case Keyword::Expect:
      expect_statement(block);
      return true;
    case Keyword::Simulate:
      simulate_statement(block);
      return true;
    case Keyword::Stop:
      word_alone(block, Stop{});
      return true;
    case Keyword::Brake:
      word_alone(block, Brake{});
      return true;
    case Keyword::Exit:
      word_alone(block, Exit{});
      return true;
    case Keyword::Next:
      word_alone(block, Next{});
      return true;
    case Keyword::Halt:
      halt_statement(block);
      return true;
    case Keyword::Ask:
      ask_statement(block);
      return true;
    case Keyword::Teach:
      teach_statement(block);
      return true;
    case Keyword::Return:
      return_statement(block);
      return true;
    case Keyword::Assert:
      assert_statement(block);
      return true;
    case Keyword::Raise:
      raise_statement(block);
      return true;
    default:
      return false;
  }
}

void ActionParser::word_alone(Block& block, decltype(Statement::node) node) {
  const Place place = tokens_.place();
  tokens_.advance();
  tree_.add(block, place, std::move(node));
}

/// Also a call of another file's routine, which begins like an assignment to a part.
// assign = place "=" expr | place ( "+=" | "-=" | "*=" | "/=" ) expr .
void ActionParser::assignment(Block& block) {
  const Place place = tokens_.place();
  Assign assign;
  assign.target = expressions_.postfix();
  const bool call = std::holds_alternative<Call>(assign.target->node);
  if (call && !tokens_.at(TokenKind::Assign) && !tokens_.at(TokenKind::Equal)) {
    return tree_.add(block, place, CallStatement{std::move(assign.target)});  // of a USEd file
  }
  if (const auto op = compound_operation(tokens_.current().kind)) {
    const Place sign = tokens_.place();
    tokens_.advance();
    ExprPtr current = tree_.copy(*assign.target);
    assign.value = expressions_.binary(*op, sign, std::move(current), expressions_.expression());
    assign.compound = true;
    return tree_.add(block, place, std::move(assign));
  }
  if (!tokens_.at(TokenKind::Assign) && !tokens_.at(TokenKind::Equal)) {
    tokens_.fail_here(code::kAssignExpected,
                      fmt::format("'=' expected, not {}", described(tokens_.current())));
  }
  if (tokens_.at(TokenKind::Equal)) {
    tokens_.report(code::kAssignExpected, tokens_.place(), "'==' compares, it does not assign",
                   "write =");
  }
  tokens_.advance();
  assign.value = expressions_.expression();
  tree_.add(block, place, std::move(assign));
}

// call = NAME "(" [ argument { "," argument } ] ")" .
void ActionParser::call_statement(Block& block) {
  const Place place = tokens_.place();
  CallStatement node;
  node.call = expressions_.postfix();
  tree_.add(block, place, std::move(node));
}

// panel = "PRINT" expr { "," expr } .
void ActionParser::print(Block& block) {
  const Place place = tokens_.place();
  Print print;
  tokens_.advance();
  do {
    print.values.push_back(expressions_.expression());
  } while (tokens_.accept(TokenKind::Comma));
  tree_.add(block, place, std::move(print));
}

void ActionParser::value_alone(Block& block) {
  const Place place = tokens_.place();
  Print print;
  print.values.push_back(expressions_.expression());
  tree_.add(block, place, std::move(print));
}

// panel = "PULSE" ( foreign | channel ) expr .
void ActionParser::pulse(Block& block) {
  const Place place = tokens_.place();
  tokens_.advance();
  Pulse pulse;
  pulse.target_place = tokens_.place();
  if (expressions_.at_channel()) {
    pulse.target = expressions_.channel("PULSE");
  } else if (tokens_.at(TokenKind::Word) && tokens_.next().kind == TokenKind::Dot) {
    pulse.target.text = names_.foreign();
  } else if (tokens_.at(TokenKind::Word)) {
    pulse.target.text = tokens_.text();
    tokens_.advance();
  } else {
    tokens_.fail_here(code::kNameExpected,
                      fmt::format("the name of an output expected after PULSE, not {}",
                                  described(tokens_.current())),
                      "PULSE gripper 50ms");
  }
  if (tokens_.at_line_end()) {
    tokens_.fail_behind(code::kValueExpected, "a time expected: how long the output is ON",
                        fmt::format("PULSE {} 50ms", shortened(pulse.target.text)));
  }
  pulse.time = expressions_.expression();
  tree_.add(block, place, std::move(pulse));
}

// control = "ASSERT" expr .
void ActionParser::assert_statement(Block& block) {
  const Place place = tokens_.place();
  Assert node;
  tokens_.advance();
  const std::size_t begin = tokens_.current().offset;
  node.condition = expressions_.expression();
  node.text = source_text(begin);
  tree_.add(block, place, std::move(node));
}

// control = "EXPECT" expr .
void ActionParser::expect_statement(Block& block) {
  const Place place = tokens_.place();
  Expect node;
  tokens_.advance();
  const std::size_t begin = tokens_.current().offset;
  node.condition = expressions_.expression();
  node.text = source_text(begin);
  tree_.add(block, place, std::move(node));
}

/// The text read from `begin` on, for messages: on one line, and not too long for one.
std::string ActionParser::source_text(std::size_t begin) const {
  const std::size_t end = tokens_.previous().offset + tokens_.previous().text.size();
  constexpr std::size_t kMost = 80;  // [choice] the message still fits two lines of a terminal
  std::string text;
  for (const char c : tokens_.source().substr(begin, end - begin)) {
    const bool blank = c == ' ' || c == '\t' || c == '\n' || c == '\r';
    if (!blank) text += c;
    if (blank && !text.ends_with(' ')) text += ' ';
  }
  if (text.size() <= kMost) return text;
  std::size_t cut = kMost;
  while (is_utf8_continuation(text[cut])) --cut;
  return text.substr(0, cut) + "\u2026";
}

// control = "RAISE" [ expr ] .
void ActionParser::raise_statement(Block& block) {
  const Place place = tokens_.place();
  Raise node;
  tokens_.advance();
  if (!tokens_.at_line_end()) node.value = expressions_.expression();
  tree_.add(block, place, std::move(node));
}

// control = "RETURN" [ expr ] .
void ActionParser::return_statement(Block& block) {
  const Place place = tokens_.place();
  Return node;
  tokens_.advance();
  if (!tokens_.at_line_end()) node.value = expressions_.expression();
  tree_.add(block, place, std::move(node));
}

// control = "START" foreign .
void ActionParser::start_statement(Block& block) {
  const Place place = tokens_.place();
  tokens_.advance();
  if (!tokens_.at(TokenKind::Word)) {
    tokens_.fail_here(code::kNameExpected,
                      fmt::format("the name of a TASK expected after START, not {}",
                                  described(tokens_.current())));
  }
  Start start;
  start.task_place = tokens_.place();
  if (tokens_.next().kind == TokenKind::Dot) {  // the checker knows whether a file is called so
    start.task.text = names_.foreign();
  } else {
    start.task.text = tokens_.text();
    tokens_.advance();
  }
  tree_.add(block, place, std::move(start));
}

// control = "HALT" [ expr ] .
void ActionParser::halt_statement(Block& block) {
  const Place place = tokens_.place();
  Halt halt;
  tokens_.advance();
  if (!tokens_.at_line_end() && !tokens_.at(Keyword::Else)) halt.text = expressions_.expression();
  tree_.add(block, place, std::move(halt));
}

// panel = "ASK" expr "INTO" place .
void ActionParser::ask_statement(Block& block) {
  const Place place = tokens_.place();
  Ask ask;
  tokens_.advance();
  ask.text = expressions_.expression();
  if (!tokens_.at_word("INTO")) {
    tokens_.fail_here(
        code::kWordExpected,
        fmt::format("INTO and a variable expected, not {}", described(tokens_.current())),
        "for example ASK \"how many? \" INTO count");
  }
  tokens_.advance();
  ask.target = expressions_.postfix();
  tree_.add(block, place, std::move(ask));
}

// control = "TEACH" IDENT .
void ActionParser::teach_statement(Block& block) {
  const Place place = tokens_.place();
  tokens_.advance();
  if (!tokens_.at(TokenKind::Word)) {
    tokens_.fail_here(code::kNameExpected,
                      fmt::format("the name of a POINT expected after TEACH, not {}",
                                  described(tokens_.current())));
  }
  Teach teach;
  teach.target.text = tokens_.text();
  teach.target_place = tokens_.place();
  taught_.insert(to_upper(tokens_.text()));
  tokens_.advance();
  tree_.add(block, place, std::move(teach));
}

// robot = "ZERO" "force" .
void ActionParser::zero_statement(Block& block) {
  const Place place = tokens_.place();
  tokens_.advance();
  if (!tokens_.at_word("force")) {
    tokens_.fail_here(
        code::kNotZeroed,
        fmt::format("ZERO sets the force sensor to zero, not {}", described(tokens_.current())),
        "write ZERO force");
  }
  tokens_.advance();
  tree_.add(block, place, ZeroForce{});
}

// "OVERRIDE" expr
void ActionParser::override_statement(Block& block) {
  const Place place = tokens_.place();
  tokens_.advance();
  SetOverride node;
  node.share = expressions_.expression();
  tree_.add(block, place, std::move(node));
}

// "LOAD" expr [ "COG" expr ]
void ActionParser::load_statement(Block& block) {
  const Place place = tokens_.place();
  tokens_.advance();
  Load node;
  node.mass = expressions_.expression();
  if (tokens_.at_word("COG")) {
    tokens_.advance();
    node.cog = expressions_.expression();
  }
  tree_.add(block, place, std::move(node));
}

// "WRITE" expr ":" expr { "," expr }
void ActionParser::write_statement(Block& block) {
  const Place place = tokens_.place();
  tokens_.advance();
  Write node;
  node.file = expressions_.expression();
  if (!tokens_.accept(TokenKind::Colon)) {
    tokens_.fail_here(
        code::kWriteIncomplete,
        fmt::format("':' and what is written expected after the file of WRITE, not {}",
                    described(tokens_.current())),
        "for example WRITE \"log.csv\": count, \",\", t");
  }
  do {
    node.values.push_back(expressions_.expression());
  } while (tokens_.accept(TokenKind::Comma));
  tree_.add(block, place, std::move(node));
}

// "SEND" foreign ":" expr { "," expr }
void ActionParser::send_statement(Block& block) {
  const Place place = tokens_.place();
  tokens_.advance();
  Send node;
  node.device_place = tokens_.place();
  node.device.text = device_name(tokens_, names_, "SEND");
  if (!tokens_.accept(TokenKind::Colon)) {
    tokens_.fail_here(code::kSendIncomplete,
                      fmt::format("':' and a text expected after the device of SEND, not {}",
                                  described(tokens_.current())),
                      "for example SEND scale: \"W\"");
  }
  do {
    node.values.push_back(expressions_.expression());
  } while (tokens_.accept(TokenKind::Comma));
  tree_.add(block, place, std::move(node));
}

// "READ" expr "INTO" place
void ActionParser::read_statement(Block& block) {
  const Place place = tokens_.place();
  Read node;
  tokens_.advance();
  node.file = expressions_.expression();
  if (!tokens_.at_word("INTO")) {
    tokens_.fail_here(
        code::kWordExpected,
        fmt::format("INTO and a variable expected, not {}", described(tokens_.current())),
        "for example READ \"parts.csv\" INTO parts");
  }
  tokens_.advance();
  node.target = expressions_.postfix();
  tree_.add(block, place, std::move(node));
}

// control = "SIMULATE" ( IDENT [ "." IDENT ] | channel | "GO" | "ANSWER" ) "=" expr
//           [ "AFTER" expr ] .
void ActionParser::simulate_statement(Block& block) {
  const Place place = tokens_.place();
  Simulate node;
  tokens_.advance();
  node.target_place = tokens_.place();
  if (operators_simulation(node)) {
    tokens_.advance();
  } else if (expressions_.at_channel()) {
    node.target = expressions_.channel("SIMULATE");
  } else if (tokens_.at(TokenKind::Word)) {
    node.target.text = tokens_.text();
    tokens_.advance();
  } else {
    tokens_.fail_here(code::kNameExpected,
                      fmt::format("the name of an input expected after SIMULATE, not {}",
                                  described(tokens_.current())),
                      kSimulateExample);
  }
  if (node.target.index == nullptr && tokens_.accept(TokenKind::Dot)) {
    node.part = tokens_.text();
    node.part_place = tokens_.place();
    if (!tokens_.at(TokenKind::Word)) {
      tokens_.fail_here(
          code::kNameExpected,
          fmt::format("x, y or z expected after the '.', not {}", described(tokens_.current())),
          "SIMULATE force.z = 5N AFTER 2s");
    }
    tokens_.advance();
  }
  if (!tokens_.accept(TokenKind::Assign)) {
    tokens_.fail_here(code::kAssignExpected,
                      fmt::format("'=' expected, not {}", described(tokens_.current())),
                      kSimulateExample);
  }
  node.value = expressions_.expression();
  if (tokens_.at_word("AFTER")) {
    tokens_.advance();
    node.after = expressions_.expression();
  }
  tree_.add(block, place, std::move(node));
}

/// Whether the word after SIMULATE means the operator. GO and ANSWER always do there, as in a
/// signal script.
bool ActionParser::operators_simulation(Simulate& node) {
  if (tokens_.next().kind != TokenKind::Assign) return false;
  if (tokens_.at_word("GO")) node.what = Simulate::What::Go;
  if (tokens_.at_word("ANSWER")) node.what = Simulate::What::Answer;
  return node.what != Simulate::What::Input;
}

}  // namespace rob::lang
