#pragma once

#include <cstddef>
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "lang/syntax/token.h"

/// A grammar in Wirth's notation, as it stands in docs/rob.ebnf: { } repeats, [ ] may be left out,
/// ( ) groups, | chooses, "…" or '…' is written so, and a rule ends with a point.
namespace rob::test {

/// Decides whatever a sentence leaves open.
class Decisions {
 public:
  virtual ~Decisions() = default;
  /// A number from 0 to `count` - 1.
  virtual std::size_t below(std::size_t count) = 0;
};

class Grammar {
 public:
  /// Throws std::runtime_error, with the place, where the text is no grammar, or names a rule
  /// that it does not have and that is no class of tokens (NAME, NUMBER, …).
  explicit Grammar(std::string_view text);

  /// How much a sentence has of what it may have. Behind `longest` bytes it comes to its end by the
  /// shortest way; of so many things that may be left out or repeated, one is there.
  struct Shape {
    std::size_t longest = 600;
    std::size_t one_of = 2;
  };
  /// A sentence of a rule, as text; `names` are those that it uses.
  std::string sentence(const std::string& rule, Decisions& decisions,
                       const std::vector<std::string>& names, const Shape& shape) const;

  /// Whether a text, in tokens without the ends of lines inside brackets, is a sentence of a rule.
  /// Otherwise `furthest` is the token behind which no sentence goes on.
  bool derives(const std::string& rule, const std::vector<lang::Token>& tokens,
               std::size_t& furthest) const;

  /// All rules, for tests that each of them is met.
  std::vector<std::string> rules() const;

  /// One side of a rule.
  struct Node {
    enum class Kind { Written, Named, Sequence, Choice, Option, Repetition };
    Kind kind = Kind::Sequence;
    std::string text;  ///< of Written and Named
    std::vector<Node> parts;
    int height = 0;  ///< least number of rules that a sentence of it goes through
  };

 private:
  void settle_heights();
  int height_of(Node& node) const;

  std::map<std::string, Node> rules_;
};

/// The tokens of a program that derives() takes.
std::vector<lang::Token> tokens_of(std::string_view source);

}  // namespace rob::test
