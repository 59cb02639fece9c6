#include "lang/help/help.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <string>

#include "lang/compile/compile.h"
#include "lang/syntax/keywords.h"
#include "lang/text/codes.h"
#include "lang/values/builtins.h"
#include "lang/values/units.h"
#include "tests/support/gantry_signature.h"

using namespace rob::lang;

namespace {

bool explained(std::string_view word) {
  const auto entries = help_on(word);
  return std::ranges::any_of(entries, [](const HelpEntry& e) { return !e.explanation.empty(); });
}

}  // namespace

TEST_CASE("every code, statement, built-in function and unit is explained") {
  for (const CodeTitle& code : all_codes()) {
    CAPTURE(code.code);
    CHECK(explained(code.code));
  }
  for (const std::string_view word : statement_words()) {
    CAPTURE(word);
    const bool end_of_block = word.starts_with("END") && word != "END";
    CHECK((end_of_block || explained(word)));
  }
  for (const std::string_view name : builtin_names()) {
    CAPTURE(name);
    CHECK(explained(name));
  }
  for (const std::string_view unit : unit_names()) {
    CAPTURE(unit);
    CHECK(explained(unit));
  }
}

TEST_CASE("an explanation belongs to a code that exists, and to one topic once") {
  const auto entries = help_entries();
  for (const HelpEntry& entry : entries) {
    CAPTURE(entry.topic);
    const bool code = entry.topic.size() == 4 && entry.topic.find_first_of("0123456789") == 1;
    CHECK(code == !entry.title.empty());
    CHECK(std::ranges::count(entries, entry.topic, &HelpEntry::topic) == 1);
  }
}

namespace {

/// Every file can be USEd, and declares nothing.
struct EmptyFiles : Sources {
  SourceFile itself{"main.rob", "main", ""};
  const SourceFile& program() const override { return itself; }
  std::variant<SourceFile, NoSource> find(std::string_view name,
                                          const std::string& /*by*/) const override {
    return SourceFile{std::string(name), std::string(name), ""};
  }
};

}  // namespace

TEST_CASE("the example of a word is a program") {
  const EmptyFiles sources;
  RobotSignature robot = rob::test::gantry_signature();
  robot.force_sensor = true;  // what examples of force need
  for (const HelpEntry& entry : help_entries()) {
    if (!entry.title.empty()) continue;
    CAPTURE(entry.topic);
    CHECK_FALSE(entry.example.empty());
    const Compilation compilation = compile(entry.example, robot, {}, {}, &sources);
    CHECK(compilation.chunk.has_value());
  }
}

TEST_CASE("units are known as they are written, all other words in any case") {
  CHECK(help_on("move").size() == 1);
  CHECK(help_on("e207").size() == 1);
  CHECK(help_on("min").size() == 2);
  CHECK(help_on("MIN").size() == 1);
  CHECK(help_on("MM").empty());
}

TEST_CASE("an explanation is wrapped to 80 characters") {
  for (const HelpEntry& entry : help_entries()) {
    const std::string text = help_text(entry);
    for (std::size_t at = 0; at < text.size();) {
      const std::size_t end = text.find('\n', at);
      CHECK(end - at <= 100);  // bytes, and examples are not wrapped
      at = end + 1;
    }
  }
}
