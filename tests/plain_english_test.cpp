// Counts the words that make English tiring to read, in all that people read: the manual, and the
// messages and comments of the product.

#include <doctest/doctest.h>

#include <algorithm>
#include <filesystem>
#include <regex>
#include <sstream>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "tests/support/source_files.h"

namespace {

namespace fs = std::filesystem;
using rob::test::layers;
using rob::test::prose_of;
using rob::test::SourceFile;
using rob::test::text_of;

/// The strings of more than one word in a line of code.
void add_strings(const std::string& code, std::vector<std::string>& texts) {
  static const std::regex quoted(R"re("((?:[^"\\]|\\.)*)")re");
  if (code.starts_with("#include")) return;
  for (std::sregex_iterator at(code.begin(), code.end(), quoted), end; at != end; ++at) {
    const std::string text = (*at)[1];
    if (text.find(' ') != std::string::npos) texts.push_back(text);
  }
}

/// Strings, and comments: each block is one text.
std::vector<std::string> texts_in_source(const std::string& source) {
  std::vector<std::string> texts;
  std::string block;
  std::istringstream lines(source);
  for (std::string line; std::getline(lines, line);) {
    const std::size_t comment = line.find("//");
    if (comment != std::string::npos) {
      const std::size_t begin = line.find_first_not_of("/!< ", comment);
      block += begin == std::string::npos ? "\n\n" : line.substr(begin) + '\n';
    } else if (!block.empty()) {
      texts.push_back(std::exchange(block, ""));
    }
    add_strings(line.substr(0, comment), texts);
  }
  if (!block.empty()) texts.push_back(block);
  return texts;
}

/// As one text.
std::string prose_text(const std::string& page) {
  std::string text;
  for (const std::string& line : prose_of(page)) text += line + '\n';
  return text;
}

/// In one line each, with the sign that ends them. An item, a cell of a table, and what stands
/// after a colon count as sentences.
std::vector<std::string> sentences_in(const std::string& text) {
  static const std::regex stop(R"([.:;!?]\s+|\n\s*[-*|]\s*|\n\s*\n|\|)");
  std::vector<std::string> sentences;
  auto from = text.begin();
  const auto add = [&](std::string sentence) {
    std::ranges::replace(sentence, '\n', ' ');
    sentence.erase(0, std::min(sentence.find_first_not_of(" *`>-"), sentence.size()));
    if (!sentence.empty()) sentences.push_back(std::move(sentence));
  };
  for (std::sregex_iterator at(text.begin(), text.end(), stop), end; at != end; ++at) {
    add({from, (*at)[0].first + 1});
    from = (*at)[0].second;
  }
  add({from, text.end()});
  return sentences;
}

/// The bounds are near to where the texts stand: they may only become smaller.
struct Rule {
  const char* what;
  const char* pattern;  ///< sought in each sentence
  std::size_t most;
};
const std::vector<Rule> kRules{
    {"'behind', where 'after' is meant", R"(\b[Bb]ehind\b)", 15},
    {"sentences that begin with 'Of' or 'What'", R"(^(Of|What)\b)", 40},
    {"'present', where 'current' is meant", R"(\b[Pp]resent (?!in\b|at\b)\w)", 5},
    {"'has to be', 'have to be'", R"(\b(has|have) to be\b)", 15},
    {"'is to be', 'are to be'", R"(\b(is|are) to be\b)", 15},
    {"'tell', 'tells', 'told'", R"(\b([Tt]ell|[Tt]ells|[Tt]old)\b)", 60},
};

std::vector<std::string> found_by(const Rule& rule, const std::vector<std::string>& texts) {
  const std::regex pattern(rule.pattern);
  std::vector<std::string> found;
  for (const std::string& text : texts) {
    for (const std::string& sentence : sentences_in(text)) {
      const bool question = sentence.ends_with('?');
      if (!question && std::regex_search(sentence, pattern)) found.push_back(sentence);
    }
  }
  return found;
}

std::vector<std::string> pages() {
  std::vector<std::string> paths{"README.md", "CONTRIBUTING.md"};
  for (const auto& entry : fs::directory_iterator(fs::path(ROB_SOURCE_DIR) / "docs")) {
    const fs::path& path = entry.path();
    if (path.extension() == ".md") paths.push_back("docs/" + path.filename().string());
  }
  std::ranges::sort(paths);
  return paths;
}

}  // namespace

TEST_CASE("what people read keeps to plain English") {
  for (const Rule& rule : kRules) {
    std::size_t count = 0;
    std::ostringstream list;
    const auto count_in = [&](const std::string& path, const std::vector<std::string>& texts) {
      for (const std::string& sentence : found_by(rule, texts)) {
        ++count;
        list << "  " << path << ": " << sentence << '\n';
      }
    };
    for (const std::string& page : pages()) count_in(page, {prose_text(text_of(page))});
    for (const SourceFile& file : layers()) count_in(file.path, texts_in_source(file.text));
    INFO(rule.what << ": " << count << ", at most " << rule.most << ":\n" << list.str());
    CHECK(count <= rule.most);
  }
}

TEST_CASE("the count finds what it looks for, in comments, messages and pages") {
  const std::string source =
      "#include \"behind a name\"\n"
      "int a;  ///< Of a leg: stands\n"
      "        ///< behind it\n"
      "say(\"it has to be told\"); say(\"told\");\n";
  const std::vector<std::string> texts = texts_in_source(source);
  CHECK(found_by(kRules[0], texts) == std::vector<std::string>{"stands behind it "});
  CHECK(found_by(kRules[1], texts) == std::vector<std::string>{"Of a leg:"});
  CHECK(found_by(kRules[3], texts) == std::vector<std::string>{"it has to be told"});
  CHECK(found_by(kRules[5], texts).size() == 1);
  const std::string page =
      "What is it? The present value. It is present in all.\n"
      "```text\nbehind\n```\n"
      "| a | What a cell |\n";
  CHECK(found_by(kRules[0], {prose_text(page)}).empty());
  CHECK(found_by(kRules[1], {prose_text(page)}) == std::vector<std::string>{"What a cell |"});
  CHECK(found_by(kRules[2], {prose_text(page)}) == std::vector<std::string>{"The present value."});
}
