#include "tests/support/grammar.h"

#include <algorithm>
#include <cctype>
#include <stdexcept>

#include "tests/support/token_classes.h"

namespace rob::test {
namespace {

using Node = Grammar::Node;
using Kind = Node::Kind;

bool in_name(char c) { return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_'; }

/// Recursive descent, as the notation describes itself:
/// rule = NAME "=" choice "." . choice = sequence { "|" sequence } . sequence = part { part } .
class NotationReader {
 public:
  explicit NotationReader(std::string_view text) : text_(text) {}

  std::map<std::string, Node> rules() {
    std::map<std::string, Node> rules;
    for (skip(); at_ < text_.size(); skip()) {
      const std::string name = take_name();
      expect('=');
      if (!rules.emplace(name, choice()).second) fail("the rule stands twice");
      expect('.');
    }
    return rules;
  }

 private:
  Node choice() {
    std::vector<Node> ways{sequence()};
    while (accept('|')) ways.push_back(sequence());
    if (ways.size() == 1) return std::move(ways.front());
    return {Kind::Choice, "", std::move(ways)};
  }

  Node sequence() {
    Node node;
    for (skip();
         at_ < text_.size() && std::string_view("|.)]}").find(text_[at_]) == std::string_view::npos;
         skip()) {
      node.parts.push_back(part());
    }
    if (node.parts.size() == 1) return Node(node.parts.front());
    return node;
  }

  Node part() {
    if (accept('(')) return closed(choice(), ')');
    if (accept('[')) return closed({Kind::Option, "", {choice()}}, ']');
    if (accept('{')) return closed({Kind::Repetition, "", {choice()}}, '}');
    const char quote = text_[at_];
    if (quote != '"' && quote != '\'') return {Kind::Named, take_name(), {}};
    const std::size_t end = text_.find(quote, at_ + 1);
    if (end == std::string_view::npos) fail("a quote is not closed");
    Node node{Kind::Written, std::string(text_.substr(at_ + 1, end - at_ - 1)), {}};
    at_ = end + 1;
    return node;
  }

  Node closed(Node node, char bracket) {
    expect(bracket);
    return node;
  }

  std::string take_name() {
    skip();
    const std::size_t begin = at_;
    while (at_ < text_.size() && in_name(text_[at_])) ++at_;
    if (at_ == begin) fail("a name expected");
    return std::string(text_.substr(begin, at_ - begin));
  }

  bool accept(char sign) {
    skip();
    if (at_ >= text_.size() || text_[at_] != sign) return false;
    ++at_;
    return true;
  }
  void expect(char sign) {
    if (!accept(sign)) fail(std::string("expected ") + sign);
  }

  /// Blanks and (* comments *).
  void skip() {
    for (;;) {
      while (at_ < text_.size() && std::isspace(static_cast<unsigned char>(text_[at_])) != 0) ++at_;
      if (!text_.substr(at_).starts_with("(*")) return;
      const std::size_t end = text_.find("*)", at_);
      if (end == std::string_view::npos) fail("a comment is not closed");
      at_ = end + 2;
    }
  }

  [[noreturn]] void fail(const std::string& what) const {
    const auto line = std::ranges::count(text_.substr(0, at_), '\n') + 1;
    throw std::runtime_error("grammar, line " + std::to_string(line) + ": " + what);
  }

  std::string_view text_;
  std::size_t at_ = 0;
};

void check_names(const Node& node, const std::map<std::string, Node>& rules) {
  if (node.kind == Kind::Named && !rules.contains(node.text) && !is_token_class(node.text)) {
    throw std::runtime_error("grammar: there is no rule " + node.text);
  }
  for (const Node& part : node.parts) check_names(part, rules);
}

}  // namespace

Grammar::Grammar(std::string_view text) : rules_(NotationReader(text).rules()) {
  // What the lexer cuts out as one token is made of characters, not of tokens.
  std::erase_if(rules_, [](const auto& rule) { return is_token_class(rule.first); });
  for (const auto& [name, node] : rules_) check_names(node, rules_);
  settle_heights();
}

std::vector<std::string> Grammar::rules() const {
  std::vector<std::string> names;
  for (const auto& [name, node] : rules_) names.push_back(name);
  return names;
}

namespace {
constexpr int kNoHeight = 1000;  // of a rule that is not known yet; no rule is so high
}  // namespace

/// Heights are worked out again until none becomes less.
void Grammar::settle_heights() {
  for (auto& [name, node] : rules_) node.height = kNoHeight;
  for (bool changed = true; changed;) {
    changed = false;
    for (auto& [name, node] : rules_) {
      const int before = node.height;
      node.height = height_of(node);
      changed = changed || node.height != before;
    }
  }
}

int Grammar::height_of(Node& node) const {
  int least = kNoHeight;
  int most = 0;
  for (Node& part : node.parts) {
    part.height = height_of(part);
    least = std::min(least, part.height);
    most = std::max(most, part.height);
  }
  switch (node.kind) {
    case Kind::Written:
    case Kind::Option:
    case Kind::Repetition:
      return 0;
    case Kind::Named:
      return is_token_class(node.text) ? 0 : std::min(rules_.at(node.text).height + 1, kNoHeight);
    case Kind::Sequence:
      return most;
    case Kind::Choice:
      return least;
  }
  return 0;
}

}  // namespace rob::test
