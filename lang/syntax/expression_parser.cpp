#include "lang/syntax/expression_parser.h"

#include <algorithm>
#include <optional>
#include <utility>

#include <fmt/format.h>

#include "lang/syntax/keywords.h"
#include "lang/text/ascii.h"
#include "lang/text/codes.h"

namespace rob::lang {

namespace {

/// A sum of up to so many terms is a tree. [choice] half of what a tree may be deep
constexpr int kMostDeepTerms = 100;

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
  if (token.keyword == Keyword::Bitand) return BinaryOp::BitAnd;
  if (token.keyword == Keyword::Shl) return BinaryOp::ShiftLeft;
  if (token.keyword == Keyword::Shr) return BinaryOp::ShiftRight;
  return std::nullopt;
}

std::optional<BinaryOp> addition(const Token& token) {
  if (token.kind == TokenKind::Plus) return BinaryOp::Add;
  if (token.kind == TokenKind::Minus) return BinaryOp::Subtract;
  if (token.kind != TokenKind::Reserved) return std::nullopt;
  if (token.keyword == Keyword::Bitor) return BinaryOp::BitOr;
  if (token.keyword == Keyword::Bitxor) return BinaryOp::BitXor;
  return std::nullopt;
}

std::optional<UnaryOp> sign(const Token& token) {
  if (token.kind == TokenKind::Minus) return UnaryOp::Negate;
  if (token.kind == TokenKind::Plus) return UnaryOp::Plus;
  const bool inverted = token.kind == TokenKind::Reserved && token.keyword == Keyword::Bitnot;
  return inverted ? std::optional(UnaryOp::BitNot) : std::nullopt;
}

/// `tools.grip` before its arguments, whatever `tools` is; empty where nothing is called.
std::string callee_of(const Expr& expr) {
  const auto* const member = std::get_if<Member>(&expr.node);
  const auto* const name = member == nullptr ? nullptr : std::get_if<Name>(&member->object->node);
  if (name == nullptr || name->index != nullptr) return "";
  if (name->text.find('.') != std::string::npos) return "";
  return fmt::format("{}.{}", name->text, member->field);
}

int height_of(const ExprPtr& expr) { return expr ? expr->height : 0; }

}  // namespace

// expr = conj { ( "OR" | "XOR" ) conj } .
ExprPtr ExpressionParser::expression() {
  ExprPtr left = conjunction();
  while (tokens_.at(Keyword::Or) || tokens_.at(Keyword::Xor)) {
    const BinaryOp op = tokens_.at(Keyword::Or) ? BinaryOp::Or : BinaryOp::Xor;
    const Place place = tokens_.place();
    tokens_.advance();
    ExprPtr right = conjunction();
    left = binary(op, place, std::move(left), std::move(right));
  }
  return left;
}

// conj = inv { "AND" inv } .
ExprPtr ExpressionParser::conjunction() {
  ExprPtr left = inversion();
  while (tokens_.at(Keyword::And)) {
    const Place place = tokens_.place();
    tokens_.advance();
    ExprPtr right = inversion();
    left = binary(BinaryOp::And, place, std::move(left), std::move(right));
  }
  return left;
}

// inv = "NOT" inv | rel .
ExprPtr ExpressionParser::inversion() {
  if (!tokens_.at(Keyword::Not)) return relation();
  const TreeBuilder::Level level(tree_);
  const Place place = tokens_.place();
  tokens_.advance();
  ExprPtr operand = inversion();
  const int height = operand->height + 1;
  return tree_.make(place, Unary{UnaryOp::Not, std::move(operand)}, height);
}

// rel = sum [ ( "==" | "<>" | "<" | "<=" | ">" | ">=" ) sum ] .
ExprPtr ExpressionParser::relation() {
  ExprPtr left = sum();
  if (tokens_.at(TokenKind::Assign)) {
    tokens_.report(code::kAssignInExpression, tokens_.place(), "'=' assigns, it does not compare",
                   "write ==");
    tokens_.take_for(TokenKind::Equal);
  }
  const auto op = comparison(tokens_.current().kind);
  if (!op) return left;
  const Place place = tokens_.place();
  tokens_.advance();
  ExprPtr right = sum();
  if (comparison(tokens_.current().kind) || tokens_.at(TokenKind::Assign)) {
    tokens_.fail_here(code::kChainedComparison, "two comparisons in a row have no meaning",
                      "write a < b AND b < c");
  }
  return binary(*op, place, std::move(left), std::move(right));
}

// sum = term { ( "+" | "-" | "BITOR" | "BITXOR" ) term } .
ExprPtr ExpressionParser::sum() {
  ExprPtr left = term();
  int terms = 1;
  while (const auto op = addition(tokens_.current())) {
    if (++terms > kMostDeepTerms) return chain(std::move(left));
    const Place place = tokens_.place();
    tokens_.advance();
    ExprPtr right = term();
    left = binary(*op, place, std::move(left), std::move(right));
  }
  return left;
}

/// The rest of a long sum: a tree of it would be too deep.
ExprPtr ExpressionParser::chain(ExprPtr first) {
  const Place place = tokens_.place();
  Chain sum;
  int height = first->height;
  sum.first = std::move(first);
  while (const auto op = addition(tokens_.current())) {
    const Place sign = tokens_.place();
    tokens_.advance();
    sum.steps.push_back({*op, sign, term()});
    height = std::max(height, sum.steps.back().term->height);
  }
  return tree_.make(place, std::move(sum), height + 1);
}

// term = unary { ( "*" | "/" | "DIV" | "MOD" | "BITAND" | "SHL" | "SHR" ) unary } .
ExprPtr ExpressionParser::term() {
  ExprPtr left = unary();
  while (const auto op = multiplication(tokens_.current())) {
    const Place place = tokens_.place();
    tokens_.advance();
    ExprPtr right = unary();
    left = binary(*op, place, std::move(left), std::move(right));
  }
  return left;
}

// unary = ( "-" | "+" | "BITNOT" ) unary | power .
ExprPtr ExpressionParser::unary() {
  const auto op = sign(tokens_.current());
  if (!op) return power();
  const TreeBuilder::Level level(tree_);
  const Place place = tokens_.place();
  tokens_.advance();
  if (*op == UnaryOp::Negate && at_least_int() && tokens_.next().kind != TokenKind::Caret) {
    NumberLiteral number = tokens_.current().number;
    number.value = -number.value;
    ExprPtr least = literal(number);
    least->place = place;
    return least;
  }
  ExprPtr operand = unary();
  const int height = operand->height + 1;
  return tree_.make(place, Unary{*op, std::move(operand)}, height);
}

bool ExpressionParser::at_least_int() const {
  return tokens_.at(TokenKind::Number) && tokens_.current().number.is_integer &&
         tokens_.current().number.integer < 0;
}

// power = postfix [ "^" unary ] .
ExprPtr ExpressionParser::power() {
  ExprPtr base = postfix();
  if (!tokens_.at(TokenKind::Caret)) return base;
  const TreeBuilder::Level level(tree_);
  const Place place = tokens_.place();
  tokens_.advance();
  ExprPtr exponent = unary();
  return binary(BinaryOp::Power, place, std::move(base), std::move(exponent));
}

// postfix = ( primary | foreign "(" [ args ] ")" ) { "." IDENT | "[" expr "]" } | channel .
// foreign = IDENT [ "." IDENT ] .
ExprPtr ExpressionParser::postfix() {
  if (at_channel()) {
    const Place place = tokens_.place();
    Name name = channel("");
    const int height = name.index->height + 1;
    return tree_.make(place, std::move(name), height);
  }
  const Place begin = tokens_.place();
  ExprPtr expr = names_.at_foreign() ? tree_.make(begin, Name{names_.foreign()}) : primary();
  if (tokens_.at(TokenKind::LeftParen) && std::holds_alternative<Name>(expr->node)) {
    expr = call(expr->place, std::move(std::get<Name>(expr->node).text));
  }
  while (tokens_.at(TokenKind::Dot) || tokens_.at(TokenKind::LeftBracket)) {
    expr = tokens_.at(TokenKind::Dot) ? member(std::move(expr)) : index(std::move(expr));
    const Place place = expr->place;
    const std::string callee = tokens_.at(TokenKind::LeftParen) ? callee_of(*expr) : "";
    if (!callee.empty()) expr = call(place, callee);
  }
  return expr;
}

/// "." IDENT
ExprPtr ExpressionParser::member(ExprPtr object) {
  const Place place = object->place;
  const int height = object->height + 1;
  tokens_.advance();
  // After the point a reserved word is a name like any other.
  if (!tokens_.at(TokenKind::Word) && !tokens_.at(TokenKind::Reserved)) {
    tokens_.fail_here(code::kNameExpected,
                      fmt::format("the name of a field expected after '.', not {}",
                                  described(tokens_.current())));
  }
  Member node{std::move(object), std::string(tokens_.text()), tokens_.place()};
  tokens_.advance();
  return tree_.make(place, std::move(node), height);
}

/// "[" expr "]"
ExprPtr ExpressionParser::index(ExprPtr object) {
  const TreeBuilder::Level level(tree_);
  const Place place = object->place;
  tokens_.advance();
  ExprPtr value = expression();
  if (!tokens_.accept(TokenKind::RightBracket)) {
    tokens_.fail_behind(code::kBracketExpected, "']' expected after the index", tokens_.remedy());
  }
  const int height = std::max(object->height, value->height) + 1;
  return tree_.make(place, Index{std::move(object), std::move(value)}, height);
}

// primary = NUMBER | QUANTITY | STRING | "TRUE" | "FALSE" | "ON" | "OFF" | IDENT
//         | "(" element { "," element } ")" | "[" [ expr { "," expr } ] "]" .
ExprPtr ExpressionParser::primary() {
  if (at_least_int()) {
    tokens_.fail_here(code::kNumberTooLarge, "the number is too large", kLargestInt);
  }
  if (tokens_.at(TokenKind::Number)) return literal(tokens_.current().number);
  if (tokens_.at(TokenKind::String)) return literal(StringLiteral{tokens_.current().string});
  if (tokens_.at(TokenKind::Word)) return literal(Name{std::string(tokens_.text())});
  if (tokens_.at(Keyword::True) || tokens_.at(Keyword::On)) return literal(BoolLiteral{true});
  if (tokens_.at(Keyword::False) || tokens_.at(Keyword::Off)) return literal(BoolLiteral{false});
  if (tokens_.at(TokenKind::LeftParen)) return parenthesized();
  if (tokens_.at(TokenKind::LeftBracket)) return list();
  fail_value();
}

ExprPtr ExpressionParser::literal(decltype(Expr::node) node) {
  ExprPtr expr = tree_.make(tokens_.place(), std::move(node));
  tokens_.advance();
  return expr;
}

// primary = "[" expr { "," expr } "]" .
ExprPtr ExpressionParser::list() {
  const TreeBuilder::Level level(tree_);
  const Place place = tokens_.place();
  List list;
  int height = 0;
  tokens_.advance();
  if (tokens_.accept(TokenKind::RightBracket)) return tree_.make(place, std::move(list));
  do {
    list.elements.push_back(expression());
    height = std::max(height, list.elements.back()->height);
  } while (tokens_.accept(TokenKind::Comma));
  if (!tokens_.accept(TokenKind::RightBracket)) {
    tokens_.fail_behind(code::kBracketExpected, "']' expected after the list", tokens_.remedy());
  }
  return tree_.make(place, std::move(list), height + 1);
}

/// A group, or a tuple. A group leaves no trace in the tree.
ExprPtr ExpressionParser::parenthesized() {
  const Place place = tokens_.place();
  Tuple tuple_elements = elements("the expression");
  Tuple::Element& first = tuple_elements.elements.front();
  const bool group = tuple_elements.elements.size() == 1 && first.name.empty() && first.value;
  return group ? std::move(first.value) : tuple_of(place, std::move(tuple_elements));
}

ExprPtr ExpressionParser::tuple(std::string_view what) {
  const Place place = tokens_.place();
  return tuple_of(place, elements(what));
}

ExprPtr ExpressionParser::tuple_of(const Place& place, Tuple elements) {
  int height = 0;
  for (const Tuple::Element& element : elements.elements) {
    height = std::max(height, height_of(element.value));
  }
  return tree_.make(place, std::move(elements), height + 1);
}

/// "(" element { "," element } ")"
Tuple ExpressionParser::elements(std::string_view what) {
  const TreeBuilder::Level level(tree_);
  const Place place = tokens_.place();
  Tuple tuple;
  tokens_.advance();
  if (tokens_.at(TokenKind::RightParen)) {
    tokens_.fail(code::kValueExpected, place, "there is nothing between the parentheses");
  }
  do {
    tuple.elements.push_back(element());
  } while (tokens_.accept(TokenKind::Comma));
  close_bracket(what);
  return tuple;
}

// element = [ [ IDENT ":" ] expr ] .
Tuple::Element ExpressionParser::element() {
  Tuple::Element element;
  element.place = tokens_.place();
  if (tokens_.at(TokenKind::Comma) || tokens_.at(TokenKind::RightParen) || tokens_.at_line_end()) {
    tree_.count(element.place);
    return element;
  }
  const bool assigned = tokens_.next().kind == TokenKind::Assign;
  if (tokens_.at(TokenKind::Word) && (assigned || tokens_.next().kind == TokenKind::Colon)) {
    if (assigned) {
      tokens_.report(code::kAssignInExpression, tokens_.next().place,
                     "a component is named with ':', not with '='",
                     fmt::format("write {}:", shortened(tokens_.text())));
    }
    element.name = tokens_.text();
    tokens_.advance();
    tokens_.advance();
  }
  element.value = expression();
  return element;
}

// "(" [ args ] ")"
ExprPtr ExpressionParser::call(const Place& place, std::string callee) {
  const TreeBuilder::Level level(tree_);
  Call node;
  int height = 0;
  const std::string what = fmt::format("the arguments of {}", shortened(callee));
  node.callee = std::move(callee);
  tokens_.advance();
  while (!tokens_.at(TokenKind::RightParen)) {
    if (tokens_.at(TokenKind::Word) && tokens_.next().kind == TokenKind::Colon) {
      node.names.emplace_back(tokens_.text());
      tokens_.advance();
      tokens_.advance();
    } else {
      node.names.emplace_back();
    }
    const bool reference = tokens_.at_word("REF") && tokens_.next().kind == TokenKind::Word;
    if (reference) tokens_.advance();
    node.references.push_back(reference);
    node.arguments.push_back(reference ? postfix() : expression());
    height = std::max(height, node.arguments.back()->height);
    if (!tokens_.accept(TokenKind::Comma)) break;
    if (tokens_.at(TokenKind::RightParen)) fail_value();
  }
  close_bracket(what);
  return tree_.make(place, std::move(node), height + 1);
}

/// ")" after what has been read, or what is missing there: the bracket or a comma.
void ExpressionParser::close_bracket(std::string_view what) {
  if (tokens_.accept(TokenKind::RightParen)) return;
  const bool value =
      tokens_.at(TokenKind::Number) || tokens_.at(TokenKind::String) || tokens_.at(TokenKind::Word);
  const bool clause = tokens_.at_word("AT") || tokens_.at_word("OVER") || tokens_.at_word("TO") ||
                      tokens_.at_word("STEP") || tokens_.at_word("TIMEOUT");
  if (value && !clause && !tokens_.at_new_statement()) {
    tokens_.fail_here(code::kCommaExpected,
                      fmt::format("',' expected before {}", described(tokens_.current())),
                      tokens_.remedy());
  }
  tokens_.fail_behind(code::kBracketExpected, fmt::format("')' expected after {}", what),
                      tokens_.remedy());
}

bool ExpressionParser::at_channel() const {
  return tokens_.at(TokenKind::Word) && is_channel_word(tokens_.text()) &&
         tokens_.next().kind == TokenKind::LeftBracket;
}

// channel = ( "DIN" | "DOUT" | "AIN" | "AOUT" ) "[" expr "]" .
Name ExpressionParser::channel(std::string_view behind, ExprPtr* last) {
  if (!at_channel()) {
    tokens_.fail_here(code::kValueExpected,
                      fmt::format("DIN[n], DOUT[n], AIN[n] or AOUT[n] expected after {}, not {}",
                                  behind, described(tokens_.current())),
                      "SIGNAL part_here = DIN[1]");
  }
  const TreeBuilder::Level level(tree_);
  Name name;
  name.text = to_upper(tokens_.text());
  tokens_.advance();
  tokens_.advance();
  name.index = expression();
  if (tokens_.at(TokenKind::Range)) {
    if (last == nullptr) {
      tokens_.fail_here(code::kBracketExpected, "several channels have one value in a SIGNAL only",
                        "SIGNAL code: INT = DIN[1..8]");
    }
    tokens_.advance();
    *last = expression();
  }
  if (!tokens_.accept(TokenKind::RightBracket)) {
    tokens_.fail_behind(code::kBracketExpected,
                        fmt::format("']' expected after the number of {}", name.text),
                        tokens_.remedy());
  }
  return name;
}

void ExpressionParser::fail_value() {
  if (tokens_.at_line_end()) {
    tokens_.fail_behind(code::kValueExpected,
                        fmt::format("a value expected after {}", described(tokens_.previous())));
  }
  if (tokens_.at(TokenKind::Reserved)) {
    tokens_.fail_here(code::kValueExpected, fmt::format("a value expected, {} is a reserved word",
                                                        described(tokens_.current())));
  }
  tokens_.fail_here(code::kValueExpected,
                    fmt::format("a value expected, not {}", described(tokens_.current())));
}

ExprPtr ExpressionParser::binary(BinaryOp op, const Place& place, ExprPtr left, ExprPtr right) {
  const int height = std::max(left->height, right->height) + 1;
  return tree_.make(place, Binary{op, std::move(left), std::move(right)}, height);
}

}  // namespace rob::lang
