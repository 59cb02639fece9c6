#include "lang/help/help.h"

#include <algorithm>
#include <array>

#include <fmt/format.h>

#include "lang/syntax/lexer.h"
#include "lang/syntax/parser.h"
#include "lang/text/ascii.h"
#include "lang/text/codes.h"
#include "lang/text/utf8.h"
#include "lang/values/builtins.h"
#include "lang/values/units.h"

namespace rob::lang {

namespace {

constexpr std::size_t kWidth = 80;  // characters; a terminal that nobody has widened

const auto kEntries = std::to_array<HelpEntry>({
#define ROB_HELP(topic, explanation, example) {topic, title_of(topic), explanation, example},
#include "lang/help/help_codes.def"
#undef ROB_HELP
#define ROB_HELP(topic, explanation, example) {topic, "", explanation, example},
#include "lang/help/help_words.def"
#undef ROB_HELP
});

bool is_unit(std::string_view topic) {
  return std::ranges::find(unit_names(), topic) != unit_names().end();
}

/// Breaks the text between words; each line begins with two blanks.
std::string wrapped(std::string_view text) {
  std::string lines;
  std::size_t width = kWidth;
  while (!text.empty()) {
    const std::string_view word = text.substr(0, text.find(' '));
    const std::size_t length = count_code_points(word);
    const bool fits = width + 1 + length <= kWidth;
    lines += fits ? " " : lines.empty() ? "  " : "\n  ";
    width = fits ? width + 1 + length : 2 + length;
    lines += word;
    text.remove_prefix(std::min(word.size() + 1, text.size()));
  }
  return lines + "\n";
}

std::string indented(std::string_view program) {
  std::string lines;
  while (!program.empty()) {
    const std::string_view line = program.substr(0, program.find('\n'));
    lines += fmt::format("      {}\n", line);
    program.remove_prefix(std::min(line.size() + 1, program.size()));
  }
  return lines;
}

}  // namespace

std::span<const HelpEntry> help_entries() { return kEntries; }

std::vector<HelpEntry> help_on(std::string_view word) {
  std::vector<HelpEntry> found;
  for (const HelpEntry& entry : kEntries) {
    const bool meant = is_unit(entry.topic) ? entry.topic == word : same_word(entry.topic, word);
    if (meant) found.push_back(entry);
  }
  return found;
}

std::string help_text(const HelpEntry& entry) {
  const bool is_word = entry.title.empty();
  std::string text = is_word ? fmt::format("{}\n\n", entry.topic)
                             : fmt::format("{}: {}\n\n", entry.topic, entry.title);
  text += wrapped(entry.explanation);
  if (!entry.example.empty()) text += "\n" + indented(entry.example);
  return text;
}

}  // namespace rob::lang
