#include "tests/support/cpp_tokens.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <map>
#include <set>
#include <stdexcept>
#include <utility>

#include "tests/support/source_files.h"

namespace rob::test {

namespace {

using Kind = CppToken::Kind;

bool is_digit(char c) { return std::isdigit(static_cast<unsigned char>(c)) != 0; }
bool is_of_word(char c) { return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_'; }

/// Cuts a text into tokens; each directive is one.
class Cutter {
 public:
  Cutter(std::string_view text, int line) : text_(text), line_(line) {}

  std::vector<CppToken> all() {
    while (skip_space(), at_ < text_.size()) {
      const std::size_t begin = at_;
      const int line = line_;
      const Kind kind = pass_token();
      first_of_line_ = false;
      tokens_.push_back({kind, std::string(text_.substr(begin, at_ - begin)), line});
    }
    return std::move(tokens_);
  }

 private:
  bool meets(std::string_view what) const { return text_.substr(at_).starts_with(what); }
  char here() const { return at_ < text_.size() ? text_[at_] : '\0'; }

  void step() {
    if (text_[at_] == '\n') {
      ++line_;
      first_of_line_ = true;
    }
    ++at_;
  }
  void step_to(std::size_t end) {
    for (end = std::min(end, text_.size()); at_ < end;) step();
  }
  /// Behind the next `what`.
  void pass(std::string_view what) {
    const std::size_t found = text_.find(what, at_);
    if (found == std::string_view::npos) {
      throw std::runtime_error("line " + std::to_string(line_) + ": no " + std::string(what));
    }
    step_to(found + what.size());
  }

  void skip_space() {
    while (at_ < text_.size()) {
      if (meets("//")) {
        step_to(end_of_line());
      } else if (meets("/*")) {
        pass("*/");
      } else if (meets("\\\n")) {
        at_ += 2;
        ++line_;
      } else if (std::isspace(static_cast<unsigned char>(here())) != 0) {
        step();
      } else {
        return;
      }
    }
  }
  /// A line ends at the first end of line without a backslash before it.
  std::size_t end_of_line() const {
    std::size_t end = text_.find('\n', at_);
    while (end != std::string_view::npos && end > 0 && text_[end - 1] == '\\') {
      end = text_.find('\n', end + 1);
    }
    return std::min(end, text_.size());
  }

  Kind pass_token() {
    if (here() == '#' && first_of_line_) {
      step_to(end_of_line());
      return Kind::Directive;
    }
    if (is_digit(here()) || (here() == '.' && at_ + 1 < text_.size() && is_digit(text_[at_ + 1]))) {
      pass_number();
      return Kind::Number;
    }
    if (is_of_word(here())) return pass_word();
    if (here() == '"' || here() == '\'') {
      pass_quoted();
      return Kind::Text;
    }
    pass_sign();
    return Kind::Sign;
  }
  void pass_number() {
    char last = '\0';
    const auto goes_on = [&] {
      if ((here() == '+' || here() == '-') && std::string_view("eEpP").find(last) != kNone) {
        return true;
      }
      return is_of_word(here()) || here() == '.' || here() == '\'';
    };
    while (at_ < text_.size() && goes_on()) last = text_[at_++];
  }
  Kind pass_word() {
    const std::size_t begin = at_;
    while (is_of_word(here())) ++at_;
    const std::string_view word = text_.substr(begin, at_ - begin);
    constexpr std::array<std::string_view, 4> kPrefixes{"u8", "u", "U", "L"};
    const bool raw = word.ends_with('R') && here() == '"';
    const std::string_view prefix = raw ? word.substr(0, word.size() - 1) : word;
    const bool prefixed = std::ranges::find(kPrefixes, prefix) != kPrefixes.end();
    if (raw && (prefixed || prefix.empty())) {
      const std::size_t open = text_.find('(', at_);
      pass(")" + std::string(text_.substr(at_ + 1, open - at_ - 1)) + "\"");
      return Kind::Text;
    }
    if (!prefixed || (here() != '"' && here() != '\'')) return Kind::Word;
    pass_quoted();
    return Kind::Text;
  }
  void pass_quoted() {
    const char quote = text_[at_];
    for (++at_; at_ < text_.size() && here() != quote && here() != '\n'; step()) {
      if (here() == '\\') step();
    }
    if (here() != quote) {
      throw std::runtime_error("line " + std::to_string(line_) + ": an open quote");
    }
    ++at_;
  }
  void pass_sign() {
    constexpr std::array<std::string_view, 11> kLong{
        "...", "::", "->", "##", "<<", "<=", ">=", "==", "!=", "&&", "||"};
    const auto* const found = std::ranges::find_if(kLong, [&](auto sign) { return meets(sign); });
    at_ += found == kLong.end() ? 1 : found->size();
  }

  static constexpr std::size_t kNone = std::string_view::npos;

  std::string_view text_;
  int line_;
  std::size_t at_ = 0;
  bool first_of_line_ = true;
  std::vector<CppToken> tokens_;
};

/// Follows the directives of a text as far as its own tokens depend on them.
class Preprocessor {
 public:
  explicit Preprocessor(const ReadIncluded& read) : read_(read) {}

  void take(const std::vector<CppToken>& tokens) {
    for (std::size_t i = 0; i < tokens.size(); ++i) {
      if (tokens[i].kind == Kind::Directive) {
        follow(tokens[i]);
      } else if (is_used_macro(tokens, i)) {
        i = replace(tokens, i);
      } else {
        made_.push_back(tokens[i]);
      }
    }
  }
  std::vector<CppToken> made() { return std::move(made_); }

 private:
  struct Macro {
    bool called = false;  ///< by a list of arguments
    std::vector<std::string> parameters;
    std::vector<CppToken> body;
  };
  using Tokens = std::vector<CppToken>;

  void follow(const CppToken& directive) {
    const Tokens words = Cutter(std::string_view(directive.text).substr(1), directive.line).all();
    if (words.size() < 2) return;
    if (words[0].is("define")) define(words, directive.text);
    if (words[0].is("undef")) macros_.erase(words[1].text);
    if (words[0].is("include")) include(directive.text);
  }
  void include(const std::string& directive) {
    for (const Include& one : includes_of(directive)) {
      const bool piece = one.path.ends_with(".inc") || one.path.ends_with(".def");
      if (!one.angled && piece) take(Cutter(read_(one.path), 1).all());
    }
  }
  void define(const Tokens& words, const std::string& directive) {
    Macro macro;
    const std::string& name = words[1].text;
    // The list of parameters follows the name without a space.
    const std::size_t behind = directive.find(name, directive.find("define") + 6) + name.size();
    std::size_t i = 2;
    if (behind < directive.size() && directive[behind] == '(') {
      macro.called = true;
      for (++i; !words.at(i).is(")"); ++i) {
        if (!words[i].is(",")) macro.parameters.push_back(words[i].text);
      }
      ++i;
    }
    macro.body.assign(words.begin() + static_cast<std::ptrdiff_t>(i), words.end());
    macros_[name] = macro;
  }

  bool is_used_macro(const Tokens& tokens, std::size_t i) const {
    if (tokens[i].kind != Kind::Word || in_use_.contains(tokens[i].text)) return false;
    const auto found = macros_.find(tokens[i].text);
    if (found == macros_.end()) return false;
    return !found->second.called || (i + 1 < tokens.size() && tokens[i + 1].is("("));
  }
  /// Returns the last token of the use.
  std::size_t replace(const Tokens& tokens, std::size_t i) {
    const CppToken name = tokens[i];
    const Macro macro = macros_.at(name.text);
    std::vector<Tokens> arguments;
    if (macro.called) i = read_arguments(tokens, i + 1, arguments);
    in_use_.insert(name.text);
    take(filled(macro, arguments, name.line));
    in_use_.erase(name.text);
    return i;
  }
  /// From the opening bracket on; returns the closing one.
  static std::size_t read_arguments(const Tokens& tokens, std::size_t i,
                                    std::vector<Tokens>& arguments) {
    arguments.emplace_back();
    int depth = 0;
    for (; i < tokens.size(); ++i) {
      if (tokens[i].is(")") && --depth == 0) return i;
      if (tokens[i].is(",") && depth == 1) {
        arguments.emplace_back();
      } else if (depth > 0) {
        arguments.back().push_back(tokens[i]);
      }
      if (tokens[i].is("(")) ++depth;
    }
    throw std::runtime_error("a macro's arguments do not end");
  }
  static Tokens argument(const Macro& macro, const std::vector<Tokens>& arguments,
                         const CppToken& parameter) {
    const auto found = std::ranges::find(macro.parameters, parameter.text);
    const auto index = static_cast<std::size_t>(found - macro.parameters.begin());
    if (parameter.kind == Kind::Word && index < arguments.size() &&
        found != macro.parameters.end()) {
      return arguments[index];
    }
    return {parameter};
  }
  static Tokens filled(const Macro& macro, const std::vector<Tokens>& arguments, int line) {
    Tokens made;
    bool joins = false;
    bool quotes = false;
    for (const CppToken& token : macro.body) {
      if (token.is("##")) {
        joins = true;
      } else if (token.is("#") && macro.called) {
        quotes = true;
      } else {
        Tokens pieces = argument(macro, arguments, token);
        if (quotes) pieces = {{Kind::Text, "\"\"", line}};
        if (joins && !made.empty() && !pieces.empty()) {
          made.back().text += pieces.front().text;
          pieces.erase(pieces.begin());
        }
        made.insert(made.end(), pieces.begin(), pieces.end());
        joins = quotes = false;
      }
    }
    for (CppToken& token : made) token.line = line;
    return made;
  }

  const ReadIncluded& read_;
  std::map<std::string, Macro, std::less<>> macros_;
  std::set<std::string, std::less<>> in_use_;
  Tokens made_;
};

}  // namespace

std::vector<CppToken> tokens_of(std::string_view text, const ReadIncluded& read) {
  Preprocessor preprocessor(read);
  preprocessor.take(Cutter(text, 1).all());
  return preprocessor.made();
}

}  // namespace rob::test
