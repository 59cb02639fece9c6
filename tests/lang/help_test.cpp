#include "lang/help/help.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <regex>
#include <set>
#include <sstream>
#include <string>

#include "lang/help/manual.h"
#include "lang/help/terminal_text.h"
#include "lang/syntax/keywords.h"
#include "lang/text/codes.h"
#include "lang/text/utf8.h"
#include "lang/values/builtins.h"
#include "lang/values/units.h"

using namespace rob::lang;

namespace {

std::string page(const char* name) {
  std::ifstream file(std::filesystem::path(ROB_SOURCE_DIR) / "docs" / name);
  std::ostringstream text;
  text << file.rdbuf();
  return text.str();
}

bool closes_block(std::string_view word) { return word.starts_with("END") && word != "END"; }

/// The words of the grammar, without those that close a block.
std::set<std::string> words_of_the_grammar() {
  const std::string grammar = page("rob.ebnf");
  const std::regex word("\"([A-Z]{2,}|force)\"");
  std::set<std::string> words;
  for (std::sregex_iterator at(grammar.begin(), grammar.end(), word), end; at != end; ++at) {
    if (!closes_block((*at)[1].str())) words.insert((*at)[1]);
  }
  return words;
}

/// How many texts there are about a word: each has a line of its own that begins it.
auto texts_on(std::string_view word) {
  const std::string text = "\n" + help_on(word);
  const std::regex title("\n(?=[^ \n])");
  return std::distance(std::sregex_iterator(text.begin(), text.end(), title), {});
}

}  // namespace

TEST_CASE("every code, statement, word of the grammar, built-in function and unit is explained") {
  for (const CodeTitle& code : all_codes()) {
    CAPTURE(code.code);
    CHECK_FALSE(help_on(code.code).empty());
  }
  for (const std::string_view word : statement_words()) {
    CAPTURE(word);
    CHECK((closes_block(word) || !help_on(word).empty()));
  }
  const std::set<std::string> words = words_of_the_grammar();
  CHECK(words.size() > 80);
  for (const std::string& word : words) {
    CAPTURE(word);
    CHECK_FALSE(help_on(word).empty());
  }
  for (const std::string_view name : builtin_names()) {
    CAPTURE(name);
    CHECK_FALSE(help_on(name).empty());
  }
  for (const std::string_view unit : unit_names()) {
    CAPTURE(unit);
    CHECK_FALSE(help_on(unit).empty());
  }
}

TEST_CASE("what help knows it explains, with more than a title") {
  for (const std::string_view topic : help_topics()) {
    CAPTURE(topic);
    const std::string text = help_on(topic);
    CHECK(std::ranges::count(text, '\n') >= 3);
    CHECK(text.find("\n  ") != text.npos);
  }
}

TEST_CASE("the manual inside the library is docs/language.md") {
  std::string embedded;
  for (const std::string_view chapter : embedded_manual()) embedded += chapter;
  CHECK(embedded == page("language.md"));
}

TEST_CASE(
    "a word of a heading shows its section and the parts of it, another word what is about it") {
  const std::string when = help_on("when");
  CHECK(when.starts_with("WHEN\n\n"));
  CHECK(when.find("\nHandlers\n\n") != when.npos);
  CHECK(when.find("STOP, BRAKE and END") == when.npos);
  const std::string floor = help_on("Floor");
  CHECK(floor.starts_with("FLOOR (Built-in functions)\n\n"));
  CHECK(floor.find("FLOOR(x, step)") != floor.npos);
  CHECK(floor.find("SQRT") == floor.npos);
  CHECK(help_on("side").empty());
  CHECK(help_on("").empty());
}

TEST_CASE("units are known as they are written, all other words in any case") {
  CHECK(texts_on("move") == 1);
  CHECK(help_on("e207") == help_on("E207"));
  CHECK(texts_on("min") == 3);
  CHECK(texts_on("MIN") == 2);
  CHECK(help_on("MM").empty());
}

TEST_CASE("the marks of Markdown are taken away") {
  CHECK(unmarked("`v[i]` is **not** [what](#it) was, [1]") == "v[i] is not what was, [1]");
  CHECK(wrapped("a b", 2) == "  a b\n");
  using Kind = ManualBlock::Kind;
  CHECK(shown({Kind::Item, {"- one `AT`", "  two"}}) == "  - one AT two\n");
  CHECK(shown({Kind::Code, {"IF x THEN", "", "ENDIF"}}) == "      IF x THEN\n\n      ENDIF\n");
  CHECK(shown({Kind::Table, {"| word | is |", "| `AT` | a speed |", "| `OVER` | |"}}) ==
        "  word  is\n  AT    a speed\n  OVER\n");
}

TEST_CASE("prose is wrapped to 80 characters") {
  for (const std::string_view topic : help_topics()) {
    std::istringstream text(help_on(topic));
    for (std::string line; std::getline(text, line);) {
      const bool program = line.starts_with("      ");
      CAPTURE(line);
      CHECK((program || count_code_points(line) <= 80));
      CHECK_FALSE(line.ends_with(' '));
    }
  }
}
