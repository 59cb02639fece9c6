#include <algorithm>
#include <set>

#include "lang/syntax/lexer.h"
#include "lang/text/ascii.h"
#include "lang/values/units.h"
#include "tests/support/grammar.h"
#include "tests/support/token_classes.h"

/// Whether a text is a sentence of a Grammar.
namespace rob::test {
namespace {

using Node = Grammar::Node;
using Kind = Node::Kind;
using lang::Token;
using lang::TokenKind;

/// Places between tokens; a part of the grammar leads from one to some.
using Places = std::set<std::size_t>;

/// All ways at once, each part at each place looked at once.
class Derivation {
 public:
  Derivation(const std::map<std::string, Node>& rules, const std::vector<Token>& tokens)
      : rules_(rules), tokens_(tokens) {}

  Places ends(const Node& node, std::size_t at) {
    switch (node.kind) {
      case Kind::Written:
        return step(at, written_at(node.text, at));
      case Kind::Named:
        return is_token_class(node.text) ? ends_of_class(node.text, at) : ends_of_rule(node, at);
      case Kind::Sequence: {
        Places places{at};
        for (const Node& part : node.parts) places = behind(part, places);
        return places;
      }
      case Kind::Choice: {
        Places places;
        for (const Node& part : node.parts) places.merge(ends(part, at));
        return places;
      }
      case Kind::Option: {
        Places places = ends(node.parts.front(), at);
        places.insert(at);
        return places;
      }
      case Kind::Repetition:
        return repeated(node.parts.front(), at);
    }
    return {};
  }

  std::size_t furthest() const { return furthest_; }

 private:
  Places behind(const Node& node, const Places& from) {
    Places places;
    for (const std::size_t at : from) places.merge(ends(node, at));
    return places;
  }

  Places repeated(const Node& node, std::size_t at) {
    Places all{at};
    for (Places open{at}; !open.empty();) {
      Places next;
      for (const std::size_t place : behind(node, open)) {
        if (all.insert(place).second) next.insert(place);
      }
      open = std::move(next);
    }
    return all;
  }

  Places ends_of_rule(const Node& named, std::size_t at) {
    const auto key = std::pair(std::string_view(named.text), at);
    if (const auto known = known_.find(key); known != known_.end()) return known->second;
    Places places = ends(rules_.at(named.text), at);
    return known_[key] = std::move(places);
  }

  Places ends_of_class(std::string_view name, std::size_t at) {
    if (at >= tokens_.size()) return {};
    if (name == "UNIT") return units(at);
    const Token& token = tokens_[at];
    const bool number = token.kind == TokenKind::Number;
    return step(at, (name == "NL" && token.kind == TokenKind::EndOfLine) ||
                        (name == "NAME" && token.kind == TokenKind::Word) ||
                        (name == "NUMBER" && number && !token.has_unit) ||
                        (name == "QUANTITY" && number && token.has_unit) ||
                        (name == "STRING" && token.kind == TokenKind::String));
  }

  /// A unit is spelt by one token or several.
  Places units(std::size_t at) {
    Places places;
    std::string text;
    for (std::size_t end = at; end < tokens_.size(); ++end) {
      if (tokens_[end].kind == TokenKind::EndOfLine) break;
      text += tokens_[end].text;
      if (lang::find_unit(text)) places.merge(step(end, true));
    }
    return places;
  }

  bool written_at(std::string_view text, std::size_t at) const {
    return at < tokens_.size() && lang::same_word(tokens_[at].text, text);
  }

  Places step(std::size_t at, bool taken) {
    if (!taken) return {};
    furthest_ = std::max(furthest_, at + 1);
    return {at + 1};
  }

  const std::map<std::string, Node>& rules_;
  const std::vector<Token>& tokens_;
  std::map<std::pair<std::string_view, std::size_t>, Places> known_;
  std::size_t furthest_ = 0;
};

}  // namespace

bool Grammar::derives(const std::string& rule, const std::vector<Token>& tokens,
                      std::size_t& furthest) const {
  Derivation derivation(rules_, tokens);
  const Places ends = derivation.ends(rules_.at(rule), 0);
  furthest = derivation.furthest();
  return ends.contains(tokens.size());
}

std::vector<Token> tokens_of(std::string_view source) {
  lang::Diagnostics unheard;
  lang::Lexer lexer(source, unheard);
  std::vector<Token> tokens;
  int brackets = 0;
  for (Token token = lexer.next(); token.kind != TokenKind::EndOfFile; token = lexer.next()) {
    const TokenKind kind = token.kind;
    if (kind == TokenKind::LeftParen || kind == TokenKind::LeftBracket) ++brackets;
    if (kind == TokenKind::RightParen || kind == TokenKind::RightBracket) --brackets;
    if (kind != TokenKind::EndOfLine || brackets <= 0) tokens.push_back(std::move(token));
  }
  return tokens;
}

}  // namespace rob::test
