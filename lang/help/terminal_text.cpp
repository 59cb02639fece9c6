#include "lang/help/terminal_text.h"

#include <algorithm>
#include <cstddef>

#include <fmt/format.h>

#include "lang/text/utf8.h"

namespace rob::lang {
namespace {

constexpr std::size_t kWidth = 80;  // characters; a terminal that nobody has widened
/// [choice] columns that leave less than this for the last one are written below each other.
constexpr std::size_t kLeastColumn = 36;

std::string blanks(std::size_t count) { return std::string(count, ' '); }

/// The same with a beginning that takes the place of the first line's blanks.
std::string wrapped_behind(const std::string& beginning, std::string_view text,
                           std::size_t indent) {
  if (text.empty()) return beginning.substr(0, beginning.find_last_not_of(' ') + 1) + "\n";
  return beginning + wrapped(text, indent).substr(indent);
}

std::string joined(const std::vector<std::string_view>& lines) {
  std::string text;
  for (std::string_view line : lines) {
    line.remove_prefix(std::min(line.find_first_not_of(' '), line.size()));
    if (!text.empty()) text += ' ';
    text += line;
  }
  return text;
}

using Row = std::vector<std::string>;

/// Side by side, the last column wrapped.
std::string columns(const std::vector<Row>& rows, const std::vector<std::size_t>& widths) {
  std::string text;
  for (const Row& row : rows) {
    std::string line = "  ";
    for (std::size_t i = 0; i + 1 < row.size(); ++i) {
      line += row[i] + blanks(widths[i] + 2 - count_code_points(row[i]));
    }
    const std::size_t indent = count_code_points(line);
    const bool empty = std::ranges::all_of(row, [](const auto& cell) { return cell.empty(); });
    if (!empty) text += wrapped_behind(line, row.back(), indent);
  }
  return text;
}

/// Below each other, each cell after the word that heads its column.
std::string stacked(const std::vector<Row>& rows) {
  std::string text;
  for (std::size_t r = 1; r < rows.size(); ++r) {
    text += wrapped(rows[r].front());
    for (std::size_t i = 1; i < rows[r].size(); ++i) {
      if (rows[r][i].empty()) continue;
      const std::string& head = rows.front()[i];
      text += wrapped(head.empty() ? rows[r][i] : fmt::format("{}: {}", head, rows[r][i]), 6);
    }
  }
  return text;
}

std::string table(const ManualBlock& block) {
  std::vector<Row> rows;
  std::vector<std::size_t> widths;
  for (const std::string_view line : block.lines) {
    Row& row = rows.emplace_back();
    for (const std::string_view cell : cells_of(line)) row.push_back(unmarked(cell));
    widths.resize(std::max(widths.size(), row.size()));
    for (std::size_t i = 0; i < row.size(); ++i) {
      widths[i] = std::max<std::size_t>(widths[i], count_code_points(row[i]));
    }
  }
  std::size_t before = 2;
  for (std::size_t i = 0; i + 1 < widths.size(); ++i) before += widths[i] + 2;
  return before + kLeastColumn <= kWidth ? columns(rows, widths) : stacked(rows);
}

}  // namespace

std::string wrapped(std::string_view text, std::size_t indent) {
  std::string lines;
  std::size_t width = kWidth;
  while (!text.empty()) {
    const std::string_view word = text.substr(0, text.find(' '));
    const std::size_t length = count_code_points(word);
    const bool fits = width + 1 + length <= kWidth;
    lines += fits ? " " : (lines.empty() ? "" : "\n") + blanks(indent);
    width = fits ? width + 1 + length : indent + length;
    lines += word;
    text.remove_prefix(std::min(word.size() + 1, text.size()));
  }
  return lines + "\n";
}

std::string indented(std::string_view program) {
  std::string lines;
  while (!program.empty()) {
    const std::string_view line = program.substr(0, program.find('\n'));
    lines += line.empty() ? "\n" : fmt::format("      {}\n", line);
    program.remove_prefix(std::min(line.size() + 1, program.size()));
  }
  return lines;
}

std::string unmarked(std::string_view markdown) {
  std::string text;
  bool code = false;
  bool link = false;
  for (std::size_t i = 0; i < markdown.size(); ++i) {
    const std::string_view rest = markdown.substr(i);
    if (rest.front() == '`') {
      code = !code;
    } else if (!code && rest.starts_with("**")) {
      ++i;
    } else if (!code && rest.front() == '[' && rest.find("](") != rest.npos) {
      link = true;
    } else if (!code && link && rest.starts_with("](")) {
      link = false;
      i += std::min(rest.find(')'), rest.size() - 1);
    } else {
      text += rest.front();
    }
  }
  return text;
}

std::vector<std::string_view> cells_of(std::string_view row) {
  std::vector<std::string_view> cells;
  row.remove_prefix(1);
  while (!row.empty()) {
    const std::string_view cell = row.substr(0, row.find('|'));
    row.remove_prefix(std::min(cell.size() + 1, row.size()));
    const std::size_t first = std::min(cell.find_first_not_of(' '), cell.size());
    cells.push_back(cell.substr(first, cell.find_last_not_of(' ') + 1 - first));
  }
  return cells;
}

std::string shown(const ManualBlock& block) {
  switch (block.kind) {
    case ManualBlock::Kind::Paragraph:
      return wrapped(unmarked(joined(block.lines)));
    case ManualBlock::Kind::Item: {
      const std::string text = joined(block.lines);
      const std::size_t mark = text.find(' ') + 1;  // "- ", "3. "
      return wrapped_behind("  " + text.substr(0, mark), unmarked(text.substr(mark)), 2 + mark);
    }
    case ManualBlock::Kind::Code: {
      std::string text;
      for (const std::string_view line : block.lines) text += indented(fmt::format("{}\n", line));
      return text;
    }
    case ManualBlock::Kind::Table:
      return table(block);
  }
  return "";
}

}  // namespace rob::lang
