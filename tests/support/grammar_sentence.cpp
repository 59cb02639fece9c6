#include <array>

#include "tests/support/grammar.h"
#include "tests/support/token_classes.h"

/// Sentences out of a Grammar.
namespace rob::test {
namespace {

using Node = Grammar::Node;
using Kind = Node::Kind;

/// [choice] deep enough for a block in a block with an expression in brackets: the rules of an
/// expression alone are ten below one another.
constexpr int kDeepest = 34;
constexpr std::size_t kMostRepeated = 4;

constexpr std::array<std::string_view, 6> kNumbers{"0", "1", "2", "7", "2.5", "1e3"};
constexpr std::array<std::string_view, 8> kQuantities{"20mm", "40mm", "5deg",   "0.5s",
                                                      "50%",  "3N",   "30mm/s", "2m/s^2"};
constexpr std::array<std::string_view, 4> kStrings{R"("text")", R"("")", R"("a \"b\" \n")",
                                                   R"("\u{20AC}")"};
constexpr std::array<std::string_view, 5> kUnits{"mm", "deg", "s", "mm / s", "N / mm ^ 2"};

class Writer {
 public:
  Writer(const std::map<std::string, Node>& rules, Decisions& decisions,
         const std::vector<std::string>& names, const Grammar::Shape& shape)
      : rules_(rules), decisions_(decisions), names_(names), shape_(shape) {}

  void write(const Node& node, int depth) {
    const bool deep = depth + node.height >= kDeepest || text_.size() >= shape_.longest;
    switch (node.kind) {
      case Kind::Written:
        return put(node.text);
      case Kind::Named:
        return is_token_class(node.text) ? put_token(node.text)
                                         : write(rules_.at(node.text), depth + 1);
      case Kind::Sequence:
        for (const Node& part : node.parts) write(part, depth);
        return;
      case Kind::Choice:
        return write(deep ? lowest(node) : node.parts[decisions_.below(node.parts.size())], depth);
      case Kind::Option:
        if (!deep && more()) write(node.parts.front(), depth);
        return;
      case Kind::Repetition:
        for (std::size_t i = 0; !deep && i < kMostRepeated && more(); ++i) {
          write(node.parts.front(), depth);
        }
        return;
    }
  }

  const std::string& text() const { return text_; }

 private:
  bool more() { return decisions_.below(shape_.one_of) == 0; }

  static const Node& lowest(const Node& choice) {
    return *std::ranges::min_element(choice.parts, {}, &Node::height);
  }

  template <typename Words>
  void put_one_of(const Words& words) {
    put(words[decisions_.below(words.size())]);
  }

  void put_token(const std::string& token) {
    if (token == "NL") return put("\n");
    if (token == "NAME") return put_one_of(names_);
    if (token == "NUMBER") return put_one_of(kNumbers);
    if (token == "QUANTITY") return put_one_of(kQuantities);
    if (token == "STRING") return put_one_of(kStrings);
    if (token == "UNIT") return put_one_of(kUnits);
  }

  void put(std::string_view token) {
    if (!text_.empty() && text_.back() != '\n' && token != "\n") text_ += ' ';
    text_ += token;
  }

  const std::map<std::string, Node>& rules_;
  Decisions& decisions_;
  const std::vector<std::string>& names_;
  const Grammar::Shape& shape_;
  std::string text_;
};

}  // namespace

std::string Grammar::sentence(const std::string& rule, Decisions& decisions,
                              const std::vector<std::string>& names, const Shape& shape) const {
  Writer writer(rules_, decisions, names, shape);
  writer.write(rules_.at(rule), 0);
  return writer.text();
}

}  // namespace rob::test
