#include "runtime/prompt/entry_lines.h"

#include <algorithm>
#include <array>

#include "lang/syntax/keywords.h"
#include "lang/text/ascii.h"
#include "runtime/files/text_lines.h"

namespace rob::runtime {

namespace {

/// The first line of the blocks that do not begin with a header up to DO or THEN.
constexpr std::array<std::string_view, 8> kOpeners{"FUNC",   "LOOP", "PROC", "RECORD",
                                                   "SELECT", "TASK", "TEST", "TRY"};

bool opens_block(std::string_view first, std::string_view last) {
  const auto is_first = [&](std::string_view word) { return lang::same_word(word, first); };
  return std::ranges::any_of(kOpeners, is_first) || lang::same_word(last, "DO") ||
         lang::same_word(last, "THEN");
}

bool closes_block(std::string_view first) {
  constexpr std::string_view kEnd = "END";
  if (lang::same_word(first, lang::spelling(lang::Keyword::Endallow))) return true;
  const auto keyword = lang::find_keyword(first);
  return keyword && lang::role(*keyword) == lang::KeywordRole::Closer &&
         lang::same_word(first.substr(0, kEnd.size()), kEnd);
}

/// The part of a line outside of texts and comments.
struct Shape {
  std::string_view first;  ///< word, with which the line begins; empty if it does not
  std::string_view last;   ///< word, with which the line ends; the same
  int brackets = 0;        ///< that it leaves open, less those that it closes
};

/// A text is passed over up to its closing quote.
std::size_t behind_text(std::string_view line, std::size_t quote) {
  for (std::size_t i = quote + 1; i < line.size(); ++i) {
    if (line[i] == '"') return i + 1;
    if (line[i] == '\\') ++i;
  }
  return line.size();
}

Shape shape_of(std::string_view line) {
  Shape shape;
  bool begun = false;
  for (std::size_t i = 0; i < line.size();) {
    const char c = line[i];
    std::size_t end = i + 1;
    if (c == '/' && line.substr(i).starts_with("//")) break;
    if (c == '"') end = behind_text(line, i);
    while (lang::in_word(c) && end < line.size() && lang::in_word(line[end])) ++end;
    if (c == '(' || c == '[') ++shape.brackets;
    if (c == ')' || c == ']') --shape.brackets;
    if (c != ' ' && c != '\t' && c != '\r') {
      shape.last = lang::in_word(c) ? line.substr(i, end - i) : std::string_view();
      if (!begun) shape.first = shape.last;
      begun = true;
    }
    i = end;
  }
  return shape;
}

/// ELSE, CASE …: the next part of a block.
bool goes_on_with(std::string_view first) {
  constexpr std::array<std::string_view, 4> kParts{"CASE", "ELSE", "ELSIF", "RESCUE"};
  return std::ranges::any_of(kParts, [&](auto word) { return lang::same_word(word, first); });
}

}  // namespace

bool EntryLines::opens(std::string_view line) {
  const Shape shape = shape_of(line);
  return opens_block(shape.first, shape.last) || goes_on_with(shape.first);
}

bool EntryLines::ends_part(std::string_view line) {
  const std::string_view first = shape_of(line).first;
  return closes_block(first) || goes_on_with(first);
}

void EntryLines::add(std::string_view line) {
  if (lines_ > 0) text_ += '\n';
  text_ += line;
  ++lines_;
  const Shape shape = shape_of(line);
  brackets_ += shape.brackets;
  closes_ = closes_block(shape.first);
  blocks_ += closes_ ? -1 : opens_block(shape.first, shape.last) ? 1 : 0;
}

bool EntryLines::surely_goes_on() const {
  if (brackets_ > 0) return true;
  if (!in_block_) return false;
  if (!closes_) return true;
  // With a mistake in it `blocks_` may be wrong: then it is found out some lines later.
  return blocks_ > 0 && lines_ - compiled_ < compiled_ / 4;
}

bool EntryLines::brackets_open(std::string_view text) {
  int open = 0;
  while (!text.empty()) open += shape_of(take_line(text)).brackets;
  return open > 0;
}

void EntryLines::note_open_block() {
  in_block_ = brackets_ == 0;
  compiled_ = lines_;
}

}  // namespace rob::runtime
