#include "runtime/prompt/completion.h"

#include <algorithm>
#include <array>
#include <optional>
#include <set>

#include "lang/help/help.h"
#include "lang/machine/motion_words.h"
#include "lang/machine/reading.h"
#include "lang/syntax/clause_words.h"
#include "lang/syntax/keywords.h"
#include "lang/syntax/lexer.h"
#include "lang/text/ascii.h"
#include "lang/values/builtins.h"
#include "lang/values/units.h"
#include "runtime/prompt/commands.h"
#include "runtime/words/codes.h"

namespace rob::runtime {

namespace {

using lang::Keyword;
using lang::KeywordRole;
using lang::Token;
using lang::TokenKind;

bool begins_with(std::string_view word, std::string_view typed) {
  return word.size() >= typed.size() && lang::same_word(word.substr(0, typed.size()), typed);
}

/// Gathers what goes on with the word that begins at `begin`.
class Choice {
 public:
  Choice(std::string_view before, std::size_t begin)
      : begin_(begin), typed_(before.substr(begin)) {}

  void add(std::string_view word) {
    if (begins_with(word, typed_)) words_.emplace(word);
  }
  template <typename Words>
  void add_all(const Words& words) {
    for (const auto& word : words) add(word);
  }
  std::string_view typed() const { return typed_; }
  Completions taken(bool whole) const { return {begin_, {words_.begin(), words_.end()}, whole}; }

 private:
  std::size_t begin_;
  std::string_view typed_;
  std::set<std::string, std::less<>> words_;
};

/// Where the last word begins, of characters for which `belongs` holds.
template <typename Belongs>
std::size_t begin_of_last(std::string_view text, Belongs belongs) {
  std::size_t begin = text.size();
  while (begin > 0 && belongs(text[begin - 1])) --begin;
  return begin;
}

/// Files that end so, and folders. A blank may not follow: a folder may go on.
Completions files(std::string_view before, std::size_t begin, std::string_view ending,
                  const Vocabulary& known) {
  Completions found{begin, {}, false};
  const std::string_view typed = before.substr(begin);
  const std::size_t name = typed.rfind('/') + 1;  // 0 where there is none
  const std::string folder(typed.substr(0, name));
  for (const std::string& file : known.files ? known.files(folder) : std::vector<std::string>{}) {
    const bool hidden = file.starts_with('.') && !typed.substr(name).starts_with('.');
    const bool meant = file.ends_with('/') || file.ends_with(ending);
    if (meant && !hidden && file.starts_with(typed.substr(name)))
      found.words.push_back(folder + file);
  }
  std::ranges::sort(found.words);
  return found;
}

// ---------------------------------------------------------------------------------------------
// Colon commands

/// "[NAME|FILE.toml]" → NAME, FILE.toml
std::vector<std::string_view> alternatives(std::string_view takes) {
  std::vector<std::string_view> words;
  constexpr std::string_view kBetween = "[]|, ";
  for (std::size_t begin = takes.find_first_not_of(kBetween); begin != std::string_view::npos;
       begin = takes.find_first_not_of(kBetween)) {
    takes.remove_prefix(begin);
    words.push_back(takes.substr(0, takes.find_first_of(kBetween)));
    takes.remove_prefix(words.back().size());
  }
  return words;
}

/// Commands say what they take: words in small letters as they are, in capitals what stands for
/// them.
Completions argument_of(const Command& command, std::string_view before, const Vocabulary& known) {
  const std::size_t begin = begin_of_last(before, [](char c) { return c != ' ' && c != '\t'; });
  Choice choice(before, begin);
  std::vector<std::string> named_files;
  for (const std::string_view word : alternatives(command.takes)) {
    if (word.starts_with("FILE")) {
      const std::string_view ending = word.substr(4);
      const auto found = files(before, begin, ending.empty() ? ".rob" : ending, known).words;
      named_files.insert(named_files.end(), found.begin(), found.end());
    } else if (word == "WORD") {
      choice.add_all(lang::help_topics());
      for (const CodeText& code : all_codes()) choice.add(code.code);
    } else if (word == "POINT") {
      choice.add_all(known.points);
    } else if (word == "NAME" && std::string_view(command.name) == "robot") {
      choice.add_all(known.robots);
    } else if (std::ranges::all_of(word, [](char c) { return c >= 'a' && c <= 'z'; })) {
      choice.add(word);
    }
  }
  Completions found = choice.taken(named_files.empty());
  found.words.insert(found.words.end(), named_files.begin(), named_files.end());
  return found;
}

Completions colon_command(std::string_view before, std::size_t colon, const Vocabulary& known) {
  const std::string_view line = before.substr(colon + 1);
  const std::size_t blank = line.find_first_of(" \t");
  if (blank == std::string_view::npos) {
    Choice choice(before, colon + 1);
    for (const Command& one : commands()) choice.add(one.name);
    return choice.taken(true);
  }
  for (const Command& one : commands()) {
    if (line.substr(0, blank) == one.name) return argument_of(one, before, known);
  }
  return {before.size(), {}, false};
}

// ---------------------------------------------------------------------------------------------
// Statements

/// Where the unit of a number begins that stands last: "10m" → 2; npos where there is none.
std::size_t begin_of_unit(std::string_view before) {
  const std::size_t number = begin_of_last(before, [](char c) {
    return lang::in_word(c) || c == '.' || c == '/' || c == '^' || c == '*' || c == '%';
  });
  if (number == before.size() || !lang::is_digit(before[number])) return std::string_view::npos;
  std::size_t unit = number;
  while (unit < before.size() && (lang::is_digit(before[unit]) || before[unit] == '.')) ++unit;
  return unit;
}

/// Those of the table, and of lengths and angles what they are a second, and a second squared.
Completions unit(std::string_view before, std::size_t begin) {
  Choice choice(before, begin);
  const std::string_view typed = before.substr(begin);
  for (const std::string_view name : lang::unit_names()) {
    if (!name.starts_with(typed) && !typed.starts_with(name)) continue;  // units know capitals
    choice.add(name);
    const lang::Dimension dimension = lang::find_unit(name)->dimension;
    if (dimension != lang::kLength && dimension != lang::kAngle) continue;
    for (const char* per : {"/s", "/s^2"}) choice.add(std::string(name) + per);
  }
  return choice.taken(false);
}

/// The tokens of the statement in which `before` ends, its last word aside.
std::vector<Token> statement_of(std::string_view before) {
  lang::Diagnostics unheard;
  lang::Lexer lexer(before, unheard);
  std::vector<Token> tokens;
  for (Token token = lexer.next(); token.kind != TokenKind::EndOfFile; token = lexer.next()) {
    const bool action = token.kind == TokenKind::Reserved &&
                        (token.keyword == Keyword::Then || token.keyword == Keyword::Else ||
                         (token.keyword == Keyword::Do && !tokens.empty()));
    const bool trigger = token.kind == TokenKind::Colon && !tokens.empty() &&
                         tokens.front().kind == TokenKind::Reserved &&
                         tokens.front().keyword == Keyword::When;
    if (action || trigger) {
      tokens.clear();
    } else if (token.kind != TokenKind::EndOfLine) {
      tokens.push_back(token);
    }
  }
  return tokens;
}

bool is_motion(const Token& token) {
  return std::ranges::any_of(lang::kMotionWords,
                             [&](auto word) { return lang::same_word(word, token.text); });
}

int depth_of(const std::vector<Token>& tokens) {
  int depth = 0;
  for (const Token& token : tokens) {
    if (token.kind == TokenKind::LeftParen || token.kind == TokenKind::LeftBracket) ++depth;
    if (token.kind == TokenKind::RightParen || token.kind == TokenKind::RightBracket) --depth;
  }
  return depth;
}

bool is_clause_word(const Token& token) {
  return std::ranges::any_of(lang::kMotionClauseWords,
                             [&](auto word) { return lang::same_word(word, token.text); });
}

/// Whether a value ends there, so that a clause or an operator may follow.
bool ends_value(const Token& token) {
  switch (token.kind) {
    case TokenKind::Reserved:
      return token.keyword == Keyword::On || token.keyword == Keyword::Off ||
             token.keyword == Keyword::True || token.keyword == Keyword::False;
    case TokenKind::Word:
      return !is_clause_word(token) || lang::same_word(token.text, "FINE") ||
             lang::same_word(token.text, "EULER");
    case TokenKind::Number:
    case TokenKind::String:
    case TokenKind::RightParen:
    case TokenKind::RightBracket:
      return true;
    default:
      return false;
  }
}

void add_values(Choice& choice, const Vocabulary& known) {
  choice.add_all(known.names);
  choice.add_all(lang::builtin_names());
  choice.add_all(lang::kReadingNames);
  for (const Keyword word :
       {Keyword::True, Keyword::False, Keyword::On, Keyword::Off, Keyword::Not}) {
    choice.add(lang::spelling(word));
  }
}

/// After a value: what a motion may have after its target, elsewhere what joins values or goes on
/// with the statement.
void add_followers(Choice& choice, bool motion) {
  if (motion) {
    choice.add_all(lang::kMotionClauseWords);
    choice.add_all(lang::kChoiceWords);
    for (const Keyword word : {Keyword::With, Keyword::In, Keyword::Until, Keyword::Do})
      choice.add(lang::spelling(word));
    return;
  }
  for (const Keyword word : {Keyword::And, Keyword::Or, Keyword::Xor, Keyword::Div, Keyword::Mod,
                             Keyword::Then, Keyword::Do, Keyword::In}) {
    choice.add(lang::spelling(word));
  }
  choice.add("TIMEOUT");
}

Completions word_of_statement(std::string_view before, const Vocabulary& known) {
  const std::size_t begin = begin_of_last(before, lang::in_word);
  Choice choice(before, begin);
  const std::vector<Token> tokens = statement_of(before.substr(0, begin));
  if (tokens.empty()) {
    choice.add_all(lang::statement_words());
    choice.add_all(lang::kFileWords);
    choice.add_all(lang::kNamingWords);
    choice.add_all(known.names);
    return choice.taken(true);
  }
  const Token& last = tokens.back();
  if (last.kind == TokenKind::Dot) return choice.taken(false);
  const auto begins_with_word = [&](std::string_view word) {
    return tokens.front().kind == TokenKind::Word && lang::same_word(tokens.front().text, word);
  };
  if (begins_with_word("ALLOW") && (tokens.size() == 1 || last.kind == TokenKind::Comma)) {
    choice.add_all(known.bodies);
    return choice.taken(false);
  }
  if (begins_with_word("OBSTACLE") && last.kind == TokenKind::Assign) {
    for (const char* shape : {"BOX", "CAPSULE", "MESH", "SPHERE"}) choice.add(shape);
    return choice.taken(false);
  }
  const bool motion = is_motion(tokens.front());
  const bool chooses =
      motion && tokens.size() > 2 && std::ranges::any_of(lang::kChoiceWords, [&](auto word) {
        return lang::same_word(word, last.text);
      });
  if (tokens.size() > 1 && ends_value(last) && !chooses) {
    add_followers(choice, motion && depth_of(tokens) == 0);
    return choice.taken(true);
  }
  if (lang::same_word(last.text, "PROFILE")) {
    choice.add_all(lang::kProfileWords);
  } else if (chooses && lang::same_word(last.text, "FREE")) {
    choice.add_all(lang::kFreeWords);
  } else if (lang::same_word(last.text, "JOG")) {
    choice.add_all(lang::kJogWords);
  } else {
    add_values(choice, known);
  }
  return choice.taken(false);
}

/// Whether a text is open at the end.
bool in_text(std::string_view before) {
  bool open = false;
  for (std::size_t i = 0; i < before.size(); ++i)
    open ^= before[i] == '"' && (i == 0 || before[i - 1] != '\\');
  return open;
}

/// Where the name after USE begins.
std::optional<std::size_t> begin_of_used(std::string_view before) {
  const std::size_t name = begin_of_last(before, lang::in_word);
  const std::string_view line = before.substr(0, name);
  const std::size_t end = line.find_last_not_of(" \t") + 1;
  const std::size_t first = line.find_first_not_of(" \t");
  if (end == name || first == std::string_view::npos) return std::nullopt;
  const bool use = lang::same_word(line.substr(first, end - first), lang::spelling(Keyword::Use));
  return use ? std::optional(name) : std::nullopt;
}

/// Programs beside this one, and in its folder lib, without their ending.
Completions used(std::string_view before, std::size_t begin, const Vocabulary& known) {
  constexpr std::string_view kEnding = ".rob";
  Choice choice(before, begin);
  for (const char* const folder : {"", "lib/"}) {
    for (const std::string& file : known.files ? known.files(folder) : std::vector<std::string>{}) {
      if (file.ends_with(kEnding) && !file.starts_with('.'))
        choice.add(file.substr(0, file.size() - kEnding.size()));
    }
  }
  return choice.taken(true);
}

}  // namespace

Completions complete(std::string_view before, const Vocabulary& known) {
  const std::size_t first = before.find_first_not_of(" \t");
  if (first != std::string_view::npos && before[first] == ':')
    return colon_command(before, first, known);
  if (in_text(before) || before.find("//") != std::string_view::npos)
    return {before.size(), {}, false};
  if (const auto begin = begin_of_used(before)) return used(before, *begin, known);
  const std::size_t unit_begin = begin_of_unit(before);
  if (unit_begin != std::string_view::npos) return unit(before, unit_begin);
  return word_of_statement(before, known);
}

}  // namespace rob::runtime
