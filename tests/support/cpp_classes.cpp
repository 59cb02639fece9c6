#include "tests/support/cpp_classes.h"

#include <algorithm>
#include <array>
#include <initializer_list>
#include <optional>
#include <stdexcept>
#include <string_view>
#include <utility>

namespace rob::test {

namespace {

constexpr std::string_view kUnnamed = "(unnamed)";

/// Reads the declarations of all class bodies. A position is the index of a token; a function that
/// reads something returns the position after it.
class ClassReader {
 public:
  explicit ClassReader(const std::vector<CppToken>& tokens)
      : tokens_(tokens), partners_(partners_of(tokens)) {}

  std::vector<CppClass> all() {
    walk(0, tokens_.size(), "");
    return std::move(found_);
  }

 private:
  struct Head {
    std::string name;
    std::size_t body = 0;  ///< its opening brace
  };

  /// What may declare values or a function.
  struct Declaration {
    std::size_t of = 0;     ///< the class, in found_
    std::size_t begin = 0;  ///< its first token
    std::size_t name = 0;   ///< the last word that may be the name
    bool is_static = false;
  };

  bool at(std::size_t i, std::string_view text) const {
    return i < tokens_.size() && tokens_[i].is(text);
  }
  bool at_any(std::size_t i, std::initializer_list<std::string_view> texts) const {
    return std::ranges::any_of(texts, [&](std::string_view text) { return at(i, text); });
  }
  bool at_word(std::size_t i) const {
    return i < tokens_.size() && tokens_[i].kind == CppToken::Kind::Word;
  }
  bool at_class(std::size_t i) const { return at_any(i, {"class", "struct", "union"}); }
  bool at_bracket(std::size_t i) const { return at_any(i, {"(", "[", "{"}); }
  /// Past the brackets that open here.
  std::size_t past(std::size_t i) const { return partners_[i] + 1; }

  /// Past template arguments or parameters, of which `<` is the first; `i` where it is a
  /// comparison.
  std::size_t past_angles(std::size_t i) const {
    int depth = 0;
    for (std::size_t j = i; j < tokens_.size(); ++j) {
      if (at(j, "<")) ++depth;
      if (at(j, ">") && --depth == 0) return j + 1;
      if (at_any(j, {";", ")", "]", "}"})) return i;
      if (at_bracket(j)) j = partners_[j];
    }
    return i;
  }
  /// Past A::B<c>::D.
  std::size_t past_name(std::size_t i) const {
    if (at(i, "::")) ++i;
    while (at_word(i)) {
      ++i;
      if (at(i, "<")) i = std::max(i, past_angles(i));
      if (!at(i, "::")) break;
      ++i;
    }
    return i;
  }
  /// Past the rest of what begins with `requires`.
  std::size_t past_constraint(std::size_t i) const {
    do {
      ++i;
      if (at(i, "requires")) {
        ++i;
        if (at(i, "(")) i = past(i);
        i = past(i);
      } else {
        i = at(i, "(") ? past(i) : past_name(i);
      }
    } while (at_any(i, {"&&", "||"}));
    return i;
  }
  std::size_t past_attributes(std::size_t i) const {
    for (;;) {
      if (at(i, "[")) {
        i = past(i);
      } else if (at_any(i, {"alignas", "__attribute__"})) {
        i = past(i + 1);
      } else {
        return i;
      }
    }
  }

  /// What begins with `class`, `struct` or `union`, if it has a body.
  std::optional<Head> head(std::size_t i) const {
    const std::size_t begin = past_attributes(i + 1);
    std::size_t end = at_word(begin) && !at(begin, "final") ? past_name(begin) : begin;
    Head found{"", end};
    for (std::size_t j = begin; j < end; ++j) found.name += tokens_[j].text;
    if (found.name.empty()) found.name = kUnnamed;
    if (at(end, "final")) ++end;
    if (at(end, ":")) {
      while (end < tokens_.size() && !at_any(end, {"{", ";", ")"})) {
        end = at(end, "<") ? std::max(end + 1, past_angles(end)) : end + 1;
      }
    }
    found.body = end;
    return at(end, "{") ? std::optional(found) : std::nullopt;
  }

  /// Finds the classes of a namespace, of a function or of an initialiser, however deep.
  void walk(std::size_t i, std::size_t end, const std::string& outer) {
    while (i < end) {
      if (at(i, "enum")) {
        i += at_class(i + 1) ? 2U : 1U;  // no class
      } else if (at_class(i) && head(i)) {
        read_class(*head(i), tokens_[i].line, outer);
        i = past(head(i)->body);
      } else {
        ++i;
      }
    }
  }

  /// Returns its place in found_.
  std::size_t read_class(const Head& head, int line, const std::string& outer) {
    const std::size_t place = found_.size();
    const std::string name = outer.empty() ? head.name : outer + "::" + head.name;
    found_.push_back({name, line});
    const std::size_t end = partners_[head.body];
    for (std::size_t i = head.body + 1; i < end;) i = read_declaration(i, place);
    return place;
  }

  std::size_t read_declaration(std::size_t i, std::size_t of) {
    if (at(i, ";")) return i + 1;
    if (at_any(i, {"public", "protected", "private"}) && at(i + 1, ":")) return i + 2;
    while (at(i, "template")) {
      i = past_angles(i + 1);
      if (at(i, "requires")) i = past_constraint(i);
    }
    if (at(i, "friend")) return read_friend(i, of);
    if (at_any(i, {"using", "typedef", "static_assert"})) return read_to_end(i, of);
    return read_member(i, of);
  }
  std::size_t read_friend(std::size_t i, std::size_t of) {
    while (!at_any(i, {";", "{"})) i = at(i, "(") ? past(i) : i + 1;
    if (at(i, ";")) return i + 1;
    walk(i, past(i), found_[of].name);
    return past(i);
  }
  std::size_t read_to_end(std::size_t i, std::size_t of) {
    const std::size_t begin = i;
    while (!at(i, ";")) i = at_bracket(i) ? past(i) : i + 1;
    walk(begin, i, found_[of].name);
    return i + 1;
  }

  /// A type, a value or a function. Looks for the token that says which.
  std::size_t read_member(std::size_t i, std::size_t of) {
    Declaration read{of, i, i};
    while (i < tokens_.size()) {
      if (at_any(i, {"alignas", "decltype", "explicit", "noexcept", "__attribute__"}) &&
          at(i + 1, "(")) {
        i = past(i + 1);
      } else if (at(i, "enum") || at_class(i)) {
        i = at(i, "enum") ? past_enum(i) : read_inner_class(i, of);
        if (at(i, ";")) return i + 1;
      } else if (at(i, "operator")) {
        read.name = i;
        return read_functions(parameters_of_operator(i), read);
      } else if (at(i, "<")) {
        i = std::max(i + 1, past_angles(i));
      } else if (at(i, "(")) {
        if (!is_pointer_to_function(i)) return read_functions(i, read);
        read.name = word_from(past_name(i + 1));
        i = past(i);
        if (at(i, "(")) i = past(i);
      } else if (at_any(i, {";", ",", "=", "{", ":"})) {
        return read_values(i, read);
      } else {
        read.is_static = read.is_static || at(i, "static");
        if (at_word(i)) read.name = i;
        i = at(i, "[") ? past(i) : i + 1;
      }
    }
    throw std::runtime_error("a declaration does not end");
  }
  std::size_t word_from(std::size_t i) const {
    while (i < tokens_.size() && !at_word(i)) ++i;
    return i;
  }
  std::size_t past_enum(std::size_t i) const {
    i = past_name(past_attributes(at_class(i + 1) ? i + 2 : i + 1));
    if (!at_any(i, {":", "{"})) return i;
    while (!at_any(i, {"{", ";"})) ++i;
    return at(i, "{") ? past(i) : i;
  }
  /// Past the class itself: its body, or its name where it has none.
  std::size_t read_inner_class(std::size_t i, std::size_t of) {
    const std::optional<Head> inner = head(i);
    if (!inner) return past_name(past_attributes(i + 1));
    const std::size_t place = read_class(*inner, tokens_[i].line, found_[of].name);
    const std::size_t end = past(inner->body);
    if (inner->name == kUnnamed && at(end, ";")) add(std::vector(found_[place].members), of);
    return end;
  }
  std::size_t parameters_of_operator(std::size_t i) const {
    ++i;
    if (at(i, "(")) return past(i);
    while (!at(i, "(")) {
      const bool typed = at(i, "<") && at_word(i - 1) && !at(i - 1, "operator");
      i = typed ? std::max(i + 1, past_angles(i)) : i + 1;
    }
    return i;
  }
  /// (*name), (&name) or (Class::*name)
  bool is_pointer_to_function(std::size_t i) const {
    const std::size_t end = past_name(i + 1);
    return at_any(end, {"*", "&", "&&"}) && (end == i + 1 || at(end - 1, "::"));
  }

  /// From the brackets of the parameters on.
  std::size_t read_functions(std::size_t i, const Declaration& read) {
    CppMethod method{tokens_[read.name].text, i, i};
    bool counts = true;
    for (i = past(i); !at_any(i, {";", "{", ","});) {
      if (at(i, "=") && at_any(i + 1, {"default", "delete"})) {
        counts = false;
        ++i;
      } else if (at(i, "requires")) {
        i = past_constraint(i);
      } else if (at(i, "<")) {
        i = std::max(i + 1, past_angles(i));
      } else if (at(i, ":")) {
        i = read_initialisers(i + 1, read.of);
      } else {
        i = at_bracket(i) ? past(i) : i + 1;
      }
    }
    const std::size_t end = at(i, "{") ? past(i) : i + 1;
    walk(i, end, found_[read.of].name);
    method.end = end;
    if (counts) found_[read.of].methods.push_back(method);
    if (!at(i, ",")) return end;
    return read_functions(word_from(i) + 1, {read.of, read.begin, word_from(i)});
  }
  /// Of a constructor, up to its body.
  std::size_t read_initialisers(std::size_t i, std::size_t of) {
    for (;;) {
      i = past_name(i);
      walk(i, past(i), found_[of].name);
      i = past(i);
      if (at(i, "...")) ++i;
      if (!at(i, ",")) return i;
      ++i;
    }
  }

  /// From the end of the first name on.
  std::size_t read_values(std::size_t i, const Declaration& read) {
    std::vector<CppMember> members{{tokens_[read.name].text, text(read.begin, read.name)}};
    const std::size_t begin = i;
    while (!at(i, ";")) {
      if (at(i, "<") && at_word(i - 1)) {
        i = past_arguments_in_value(i);
      } else if (at(i, ",")) {
        i = word_from(i);
        members.push_back({tokens_[i].text, members.front().type});
      } else {
        i = at_bracket(i) ? past(i) : i + 1;
      }
    }
    walk(begin, i, found_[read.of].name);
    if (!read.is_static) add(members, read.of);
    return i + 1;
  }
  void add(const std::vector<CppMember>& members, std::size_t to) {
    found_[to].members.insert(found_[to].members.end(), members.begin(), members.end());
  }
  /// The tokens with a space between words that would else be one.
  std::string text(std::size_t begin, std::size_t end) const {
    std::string joined;
    for (std::size_t i = begin; i < end; ++i) {
      if (i > begin && at_word(i - 1) && at_word(i)) joined += ' ';
      joined += tokens_[i].text;
    }
    return joined;
  }
  /// In an expression `<` may compare. Behind arguments of a template stands no operand.
  std::size_t past_arguments_in_value(std::size_t i) const {
    const std::size_t end = past_angles(i);
    return end != i && at_any(end, {"(", "{", "::", ";", ",", ")", "}", ">"}) ? end : i + 1;
  }

  const std::vector<CppToken>& tokens_;
  std::vector<std::size_t> partners_;
  std::vector<CppClass> found_;
};

}  // namespace

std::vector<std::size_t> partners_of(const std::vector<CppToken>& tokens) {
  constexpr std::array<std::pair<std::string_view, std::string_view>, 3> kBrackets{
      {{"(", ")"}, {"[", "]"}, {"{", "}"}}};
  std::vector<std::size_t> partners(tokens.size(), 0);
  std::vector<std::size_t> open;
  for (std::size_t i = 0; i < tokens.size(); ++i) {
    for (const auto& [opening, closing] : kBrackets) {
      if (tokens[i].is(opening)) open.push_back(i);
      if (!tokens[i].is(closing)) continue;
      if (open.empty() || !tokens[open.back()].is(opening)) {
        throw std::runtime_error("line " + std::to_string(tokens[i].line) + ": no partner of " +
                                 std::string(closing));
      }
      partners[open.back()] = i;
      partners[i] = open.back();
      open.pop_back();
    }
  }
  if (!open.empty()) {
    throw std::runtime_error("line " + std::to_string(tokens[open.back()].line) +
                             ": an open bracket");
  }
  return partners;
}

std::vector<CppClass> classes_in(const std::vector<CppToken>& tokens) {
  return ClassReader(tokens).all();
}

}  // namespace rob::test
