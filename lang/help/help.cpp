#include "lang/help/help.h"

#include <algorithm>
#include <array>
#include <optional>
#include <span>

#include <fmt/format.h>

#include "lang/help/manual.h"
#include "lang/help/terminal_text.h"
#include "lang/text/ascii.h"
#include "lang/text/codes.h"
#include "lang/values/units.h"

namespace rob::lang {
namespace {

using Kind = ManualBlock::Kind;
using Words = std::vector<std::string_view>;

/// Without their titles, which only help_on() looks for: a start of Rob does not wait for them.
constexpr auto kCodes = std::to_array<CodeHelp>({
#define ROB_HELP(code, explanation, example) {code, {}, explanation, example},
#include "lang/help/help_codes.def"
#undef ROB_HELP
});

bool is_unit(std::string_view word) {
  return std::ranges::find(unit_names(), word) != unit_names().end();
}

/// A word of the language where it is named, not used: TO_FRAME, and not p or D.
bool is_name(std::string_view word) {
  return word.size() > 1 && word.front() >= 'A' && word.front() <= 'Z' &&
         std::ranges::all_of(word, [](char c) { return in_word(c) && c == to_upper(c); });
}

std::string_view first_word(std::string_view text) {
  const auto end = std::ranges::find_if_not(text, [](char c) { return in_word(c); });
  return text.substr(0, static_cast<std::size_t>(end - text.begin()));
}

/// STOP, BRAKE and END; or, of another heading, nothing.
Words names_in(std::string_view heading) {
  Words names;
  while (!heading.empty()) {
    const std::string_view word = first_word(heading);
    if (is_name(word)) names.push_back(word);
    heading.remove_prefix(std::max<std::size_t>(word.size(), 1));
  }
  return names;
}

/// The text between ` and ` in a line.
Words quoted_in(std::string_view line) {
  Words quoted;
  for (std::size_t open = line.find('`'); open != line.npos; open = line.find('`', open)) {
    const std::size_t close = std::min(line.find('`', open + 1), line.size());
    quoted.push_back(line.substr(open + 1, close - open - 1));
    open = std::min(close + 1, line.size());
  }
  return quoted;
}

/// ASIN, ACOS and ATAN, where a row begins with `ASIN(x)` `ACOS(x)` `ATAN(x)`.
Words names_before(std::string_view row) {
  Words names;
  for (const std::string_view quoted : quoted_in(cells_of(row).front())) {
    if (is_name(first_word(quoted))) names.push_back(first_word(quoted));
  }
  return names;
}

bool mentions(std::string_view text, std::string_view word) {
  for (std::size_t at = text.find(word); at != text.npos; at = text.find(word, at + 1)) {
    const std::string_view behind = text.substr(at + word.size());
    const bool begins = at == 0 || !in_word(text[at - 1]);
    if (begins && (behind.empty() || !in_word(behind.front()))) return true;
  }
  return false;
}

/// In prose a name stands out by its capitals, any other word by its quotes.
bool speaks_of(std::string_view line, std::string_view word) {
  if (is_name(word)) return mentions(line, word);
  return std::ranges::any_of(quoted_in(line),
                             [&](std::string_view quoted) { return mentions(quoted, word); });
}

/// The part of a table that is about a word: the rows that begin with it, or else mention it.
std::optional<ManualBlock> rows_about(const ManualBlock& table, std::string_view word) {
  ManualBlock found{Kind::Table, {table.lines.front()}};
  const std::span rows = std::span(table.lines).subspan(1);
  const auto take = [&](const auto& is_meant) {
    if (found.lines.size() == 1)
      std::ranges::copy_if(rows, std::back_inserter(found.lines), is_meant);
  };
  take([&](std::string_view row) { return std::ranges::count(names_before(row), word) > 0; });
  take([&](std::string_view row) { return speaks_of(row, word); });
  if (found.lines.size() == 1) return std::nullopt;
  return found;
}

std::optional<ManualBlock> part_about(const ManualBlock& block, std::string_view word) {
  if (block.kind == Kind::Table) return rows_about(block, word);
  const bool program = block.kind == Kind::Code;
  const bool about = std::ranges::any_of(block.lines, [&](std::string_view line) {
    return program ? mentions(line, word) : speaks_of(line, word);
  });
  return about ? std::optional(block) : std::nullopt;
}

/// The words that a section explains among others.
Words explained_in(const ManualSection& section) {
  Words words = section.words;
  for (const ManualBlock& block : section.blocks) {
    if (block.kind != Kind::Table) continue;
    for (const std::string_view row : std::span(block.lines).subspan(1)) {
      std::ranges::copy(names_before(row), std::back_inserter(words));
    }
  }
  return words;
}

/// Blocks with an empty line between them; items of a list, and rows, stand close.
std::string shown(const std::vector<ManualBlock>& blocks) {
  std::string text;
  bool item = false;
  for (const ManualBlock& block : blocks) {
    const bool next = block.kind == Kind::Item;
    if (!text.empty() && !(item && next)) text += "\n";
    text += shown(block);
    item = next;
  }
  return text;
}

/// The whole section, and those below it.
std::string whole(std::span<const ManualSection> sections) {
  std::string text =
      fmt::format("{}\n\n{}", sections.front().heading, shown(sections.front().blocks));
  for (const ManualSection& section : sections.subspan(1)) {
    if (section.depth <= sections.front().depth) break;
    text += fmt::format("\n{}\n\n{}", section.heading, shown(section.blocks));
  }
  return text;
}

std::string extract(const ManualSection& section, std::string_view word) {
  if (is_unit(word)) return whole({&section, 1});
  std::vector<ManualBlock> parts;
  for (const ManualBlock& block : section.blocks) {
    if (auto part = part_about(block, word)) parts.push_back(*std::move(part));
  }
  return fmt::format("{} ({})\n\n{}", word, section.heading, shown(parts));
}

bool is_headed(const ManualSection& section, std::string_view word) {
  const bool named = std::ranges::any_of(
      names_in(section.heading), [&](std::string_view name) { return same_word(name, word); });
  return section.depth > 1 && (named || same_word(section.heading, word));
}

/// All that the manual says of a word.
std::vector<std::string> manual_on(std::string_view word) {
  const std::vector<ManualSection> sections = read_manual(embedded_manual());
  std::vector<std::string> texts;
  for (std::size_t i = 0; i < sections.size(); ++i) {
    if (is_headed(sections[i], word)) texts.push_back(whole(std::span(sections).subspan(i)));
  }
  const bool headed = !texts.empty();
  for (const ManualSection& section : sections) {
    Words seen;
    for (const std::string_view name : explained_in(section)) {
      const bool meant = is_unit(name) ? name == word : !headed && same_word(name, word);
      if (!meant || std::ranges::count(seen, name) > 0) continue;
      seen.push_back(name);
      texts.push_back(extract(section, name));
    }
  }
  return texts;
}

}  // namespace

std::string help_text(const CodeHelp& help) {
  std::string text = fmt::format("{}: {}\n\n{}", help.code, help.title, wrapped(help.explanation));
  if (!help.example.empty()) text += "\n" + indented(help.example);
  return text;
}

std::string help_on(std::string_view word) {
  std::vector<std::string> texts = manual_on(word);
  for (CodeHelp help : kCodes) {
    if (!same_word(help.code, word)) continue;
    help.title = title_of(help.code);
    texts.push_back(help_text(help));
  }
  return fmt::format("{}", fmt::join(texts, "\n"));
}

std::vector<std::string_view> help_topics() {
  Words topics;
  for (const CodeHelp& help : kCodes) topics.push_back(help.code);
  for (const ManualSection& section : read_manual(embedded_manual())) {
    if (section.depth > 1) std::ranges::copy(names_in(section.heading), std::back_inserter(topics));
    std::ranges::copy(explained_in(section), std::back_inserter(topics));
  }
  Words once;
  for (const std::string_view topic : topics) {
    if (std::ranges::find(once, topic) == once.end()) once.push_back(topic);
  }
  return once;
}

}  // namespace rob::lang
