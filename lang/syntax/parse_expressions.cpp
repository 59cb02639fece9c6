#include <algorithm>
#include <array>
#include <memory>
#include <optional>
#include <utility>

#include <fmt/format.h>

#include "lang/syntax/parser_impl.h"
#include "lang/text/ascii.h"
#include "lang/text/codes.h"

/// The parser's rules for expressions, from the weakest binding to the strongest.
namespace rob::lang {

namespace {

std::optional<BinaryOp> comparison(TokenKind kind) {
  switch (kind) {
    case TokenKind::Equal:
      return BinaryOp::Equal;
    case TokenKind::NotEqual:
      return BinaryOp::NotEqual;
    case TokenKind::Less:
      return BinaryOp::Less;
    case TokenKind::LessEqual:
      return BinaryOp::LessEqual;
    case TokenKind::Greater:
      return BinaryOp::Greater;
    case TokenKind::GreaterEqual:
      return BinaryOp::GreaterEqual;
    default:
      return std::nullopt;
  }
}

std::optional<BinaryOp> multiplication(const Token& token) {
  if (token.kind == TokenKind::Star) return BinaryOp::Multiply;
  if (token.kind == TokenKind::Slash) return BinaryOp::Divide;
  if (token.kind != TokenKind::Reserved) return std::nullopt;
  if (token.keyword == Keyword::Div) return BinaryOp::Div;
  if (token.keyword == Keyword::Mod) return BinaryOp::Mod;
  return std::nullopt;
}

int height_of(const ExprPtr& expr) { return expr ? expr->height : 0; }

}  // namespace

// expr = conj { ( "OR" | "XOR" ) conj } .
ExprPtr Parser::expression() {
  ExprPtr left = conjunction();
  while (at(Keyword::Or) || at(Keyword::Xor)) {
    const BinaryOp op = at(Keyword::Or) ? BinaryOp::Or : BinaryOp::Xor;
    const Place place = current_.place;
    advance();
    ExprPtr right = conjunction();
    left = binary(op, place, std::move(left), std::move(right));
  }
  return left;
}

// conj = inv { "AND" inv } .
ExprPtr Parser::conjunction() {
  ExprPtr left = inversion();
  while (at(Keyword::And)) {
    const Place place = current_.place;
    advance();
    ExprPtr right = inversion();
    left = binary(BinaryOp::And, place, std::move(left), std::move(right));
  }
  return left;
}

// inv = "NOT" inv | rel .
ExprPtr Parser::inversion() {
  if (!at(Keyword::Not)) return relation();
  const Level level(*this);
  const Place place = current_.place;
  advance();
  ExprPtr operand = inversion();
  const int height = operand->height + 1;
  return make(place, Unary{UnaryOp::Not, std::move(operand)}, height);
}

// rel = sum [ ( "==" | "<>" | "<" | "<=" | ">" | ">=" ) sum ] .
ExprPtr Parser::relation() {
  ExprPtr left = sum();
  if (at(TokenKind::Assign)) {
    report(code::kAssignInExpression, current_.place, "'=' assigns, it does not compare",
           "write ==");
    current_.kind = TokenKind::Equal;
  }
  const auto op = comparison(current_.kind);
  if (!op) return left;
  const Place place = current_.place;
  advance();
  ExprPtr right = sum();
  if (comparison(current_.kind) || at(TokenKind::Assign)) {
    fail_here(code::kChainedComparison, "two comparisons in a row have no meaning",
              "write a < b AND b < c");
  }
  return binary(*op, place, std::move(left), std::move(right));
}

// sum = term { ( "+" | "-" ) term } .
ExprPtr Parser::sum() {
  ExprPtr left = term();
  while (at(TokenKind::Plus) || at(TokenKind::Minus)) {
    const BinaryOp op = at(TokenKind::Plus) ? BinaryOp::Add : BinaryOp::Subtract;
    const Place place = current_.place;
    advance();
    ExprPtr right = term();
    left = binary(op, place, std::move(left), std::move(right));
  }
  return left;
}

// term = unary { ( "*" | "/" | "DIV" | "MOD" ) unary } .
ExprPtr Parser::term() {
  ExprPtr left = unary();
  while (const auto op = multiplication(current_)) {
    const Place place = current_.place;
    advance();
    ExprPtr right = unary();
    left = binary(*op, place, std::move(left), std::move(right));
  }
  return left;
}

// unary = ( "-" | "+" ) unary | power .
ExprPtr Parser::unary() {
  if (!at(TokenKind::Minus) && !at(TokenKind::Plus)) return power();
  const Level level(*this);
  const UnaryOp op = at(TokenKind::Minus) ? UnaryOp::Negate : UnaryOp::Plus;
  const Place place = current_.place;
  advance();
  if (op == UnaryOp::Negate && at_least_int() && next_.kind != TokenKind::Caret) {
    current_.number.value = -current_.number.value;
    ExprPtr least = literal(current_.number);
    least->place = place;
    return least;
  }
  ExprPtr operand = unary();
  const int height = operand->height + 1;
  return make(place, Unary{op, std::move(operand)}, height);
}

bool Parser::at_least_int() const {
  return at(TokenKind::Number) && current_.number.is_integer && current_.number.integer < 0;
}

// power = postfix [ "^" unary ] .
ExprPtr Parser::power() {
  ExprPtr base = postfix();
  if (!at(TokenKind::Caret)) return base;
  const Level level(*this);
  const Place place = current_.place;
  advance();
  ExprPtr exponent = unary();
  return binary(BinaryOp::Power, place, std::move(base), std::move(exponent));
}

// postfix = ( primary | foreign "(" [ args ] ")" ) { "." IDENT | "[" expr "]" } | channel .
// foreign = IDENT [ "." IDENT ] .
ExprPtr Parser::postfix() {
  if (at_channel()) {
    const Place place = current_.place;
    Name name = channel("");
    const int height = name.index->height + 1;
    return make(place, std::move(name), height);
  }
  const Place begin = current_.place;
  ExprPtr expr = at_foreign_name() ? make(begin, Name{foreign_name()}) : primary();
  if (at(TokenKind::LeftParen) && std::holds_alternative<Name>(expr->node)) {
    expr = call(expr->place, std::move(std::get<Name>(expr->node).text));
  }
  while (at(TokenKind::Dot) || at(TokenKind::LeftBracket)) {
    expr = at(TokenKind::Dot) ? member(std::move(expr)) : index(std::move(expr));
    const Place place = expr->place;
    const std::string callee = at(TokenKind::LeftParen) ? callee_of(*expr) : "";
    if (!callee.empty()) expr = call(place, callee);
  }
  return expr;
}

/// `tools.grip` before its arguments, whatever `tools` is; empty where nothing is called.
std::string Parser::callee_of(const Expr& expr) {
  const auto* const member = std::get_if<Member>(&expr.node);
  const auto* const name = member == nullptr ? nullptr : std::get_if<Name>(&member->object->node);
  if (name == nullptr || name->index != nullptr) return "";
  if (name->text.find('.') != std::string::npos) return "";
  return fmt::format("{}.{}", name->text, member->field);
}

/// "." IDENT
ExprPtr Parser::member(ExprPtr object) {
  const Place place = object->place;
  const int height = object->height + 1;
  advance();
  // Behind the point a reserved word is a name like any other.
  if (!at(TokenKind::Word) && !at(TokenKind::Reserved)) {
    fail_here(code::kNameExpected,
              fmt::format("the name of a field expected after '.', not {}", described(current_)));
  }
  Member node{std::move(object), std::string(current_.text), current_.place};
  advance();
  return make(place, std::move(node), height);
}

/// "[" expr "]"
ExprPtr Parser::index(ExprPtr object) {
  const Level level(*this);
  const Place place = object->place;
  advance();
  ExprPtr value = expression();
  if (!accept(TokenKind::RightBracket)) {
    fail(code::kBracketExpected, behind_previous(), "']' expected after the index", remedy());
  }
  const int height = std::max(object->height, value->height) + 1;
  return make(place, Index{std::move(object), std::move(value)}, height);
}

// primary = NUMBER | QUANTITY | STRING | "TRUE" | "FALSE" | "ON" | "OFF" | IDENT
//         | "(" element { "," element } ")" | "[" [ expr { "," expr } ] "]" .
ExprPtr Parser::primary() {
  if (at_least_int()) fail_here(code::kNumberTooLarge, "the number is too large", kLargestInt);
  if (at(TokenKind::Number)) return literal(current_.number);
  if (at(TokenKind::String)) return literal(StringLiteral{current_.string});
  if (at(TokenKind::Word)) return literal(Name{std::string(current_.text)});
  if (at(Keyword::True) || at(Keyword::On)) return literal(BoolLiteral{true});
  if (at(Keyword::False) || at(Keyword::Off)) return literal(BoolLiteral{false});
  if (at(TokenKind::LeftParen)) return parenthesized();
  if (at(TokenKind::LeftBracket)) return list();
  fail_value();
}

ExprPtr Parser::literal(decltype(Expr::node) node) {
  ExprPtr expr = make(current_.place, std::move(node));
  advance();
  return expr;
}

/// A group, or a tuple. A group leaves no trace in the tree.
ExprPtr Parser::parenthesized() {
  const Place place = current_.place;
  Tuple tuple_elements = elements("the expression");
  Tuple::Element& first = tuple_elements.elements.front();
  const bool group = tuple_elements.elements.size() == 1 && first.name.empty() && first.value;
  return group ? std::move(first.value) : tuple(place, std::move(tuple_elements));
}

ExprPtr Parser::tuple(const Place& place, Tuple elements) {
  int height = 0;
  for (const Tuple::Element& element : elements.elements) {
    height = std::max(height, height_of(element.value));
  }
  return make(place, std::move(elements), height + 1);
}

/// "(" element { "," element } ")"; `what` is what they make up, for the message.
Tuple Parser::elements(std::string_view what) {
  const Level level(*this);
  const Place place = current_.place;
  Tuple tuple;
  advance();
  if (at(TokenKind::RightParen)) {
    fail(code::kValueExpected, place, "there is nothing between the parentheses");
  }
  do {
    tuple.elements.push_back(element());
  } while (accept(TokenKind::Comma));
  close_bracket(what);
  return tuple;
}

// element = [ [ IDENT ":" ] expr ] .
Tuple::Element Parser::element() {
  Tuple::Element element;
  element.place = current_.place;
  if (at(TokenKind::Comma) || at(TokenKind::RightParen) || at_line_end()) {
    count_node(element.place);
    return element;
  }
  const bool assigned = next_.kind == TokenKind::Assign;
  if (at(TokenKind::Word) && (assigned || next_.kind == TokenKind::Colon)) {
    if (assigned) {
      report(code::kAssignInExpression, next_.place, "a component is named with ':', not with '='",
             fmt::format("write {}:", shortened(current_.text)));
    }
    element.name = current_.text;
    advance();
    advance();
  }
  element.value = expression();
  return element;
}

// "(" [ args ] ")"
ExprPtr Parser::call(const Place& place, std::string callee) {
  const Level level(*this);
  Call node;
  int height = 0;
  const std::string what = fmt::format("the arguments of {}", shortened(callee));
  node.callee = std::move(callee);
  advance();
  while (!at(TokenKind::RightParen)) {
    if (at(TokenKind::Word) && next_.kind == TokenKind::Colon) {
      node.names.emplace_back(current_.text);
      advance();
      advance();
    } else {
      node.names.emplace_back();
    }
    node.arguments.push_back(expression());
    height = std::max(height, node.arguments.back()->height);
    if (!accept(TokenKind::Comma)) break;
    if (at(TokenKind::RightParen)) fail_value();
  }
  close_bracket(what);
  return make(place, std::move(node), height + 1);
}

/// ")" behind what has been read, or what is missing there: the bracket or a comma.
void Parser::close_bracket(std::string_view what) {
  if (accept(TokenKind::RightParen)) return;
  const bool value = at(TokenKind::Number) || at(TokenKind::String) || at(TokenKind::Word);
  const bool clause =
      at_word("AT") || at_word("OVER") || at_word("TO") || at_word("STEP") || at_word("TIMEOUT");
  if (value && !clause && !at_new_statement()) {
    fail_here(code::kCommaExpected, fmt::format("',' expected before {}", described(current_)),
              remedy());
  }
  fail(code::kBracketExpected, behind_previous(), fmt::format("')' expected after {}", what),
       remedy());
}

void Parser::fail_value() {
  if (at_line_end()) {
    fail(code::kValueExpected, behind_previous(),
         fmt::format("a value expected after {}", described(previous_)));
  }
  if (at(TokenKind::Reserved)) {
    fail_here(code::kValueExpected,
              fmt::format("a value expected, {} is a reserved word", described(current_)));
  }
  fail_here(code::kValueExpected, fmt::format("a value expected, not {}", described(current_)));
}

// ---------------------------------------------------------------------- nodes

ExprPtr Parser::binary(BinaryOp op, const Place& place, ExprPtr left, ExprPtr right) {
  const int height = std::max(left->height, right->height) + 1;
  return make(place, Binary{op, std::move(left), std::move(right)}, height);
}

ExprPtr Parser::make(const Place& place, decltype(Expr::node) node, int height) {
  count_node(place);
  if (height > kMaxDepth) fail_too_deep(place);
  auto expr = std::make_unique<Expr>();
  expr->place = place;
  expr->node = std::move(node);
  expr->height = height;
  return expr;
}

void Parser::count_node(const Place& place) {
  if (++nodes_ <= kMaxNodes) return;
  report(code::kProgramTooLarge, place,
         fmt::format("the program is too large: more than {} statements and values", kMaxNodes));
  throw GiveUp{};
}

Parser::Level::Level(Parser& parser) : parser_(parser) {
  if (parser.level_ >= kMaxDepth) parser.fail_too_deep(parser.current_.place);
  ++parser.level_;
}

void Parser::fail_too_deep(const Place& place) {
  fail(code::kTooDeep, place,
       fmt::format("the expression is nested too deep: at most {} levels", kMaxDepth),
       "compute parts of it before, in variables");
}

}  // namespace rob::lang
