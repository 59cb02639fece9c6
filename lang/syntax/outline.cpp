#include "lang/syntax/outline.h"

#include <algorithm>

#include "lang/text/ascii.h"
#include "lang/text/utf8.h"

namespace rob::lang {
namespace {

void skip_blanks(std::string_view& text) {
  text.remove_prefix(std::min(text.find_first_not_of(" \t"), text.size()));
}

/// A word from the beginning of a text, which goes on after it; empty if none stands there.
std::string_view take_word(std::string_view& text) {
  if (text.empty() || !begins_word(text.front())) return {};
  const auto end = std::ranges::find_if_not(text, in_word);
  const std::string_view word = text.substr(0, static_cast<std::size_t>(end - text.begin()));
  text.remove_prefix(word.size());
  return word;
}

}  // namespace

bool Outline::names_file(std::string_view word) const {
  return std::ranges::any_of(uses,
                             [&](const UsedName& used) { return same_word(used.name, word); });
}

/// A line that begins with a reserved word begins a statement, inside brackets too, and no text
/// goes on in the next line: two words of each line are enough.
Outline outline_of(std::string_view source, std::uint32_t file, TextParts parts) {
  Outline outline;
  LineCount count(parts);
  std::size_t begin = source.starts_with(kByteOrderMark) ? kByteOrderMark.size() : 0;
  std::size_t behind = begin;
  for (; begin < source.size(); begin = behind, count.next(begin)) {
    const std::string_view whole =
        source.substr(begin, std::min(source.find('\n', begin), source.size()) - begin);
    behind = begin + whole.size() + 1;
    std::string_view rest = whole;
    skip_blanks(rest);
    const std::string_view word = take_word(rest);
    skip_blanks(rest);
    const auto column = static_cast<std::uint32_t>(whole.size() - rest.size() + 1);
    const std::string_view name = take_word(rest);
    if (name.empty()) continue;
    if (same_word(word, "USE")) {
      const auto length = static_cast<std::uint32_t>(name.size());
      outline.uses.push_back({std::string(name), {count.line(), column, length, file}});
    } else if (same_word(word, "FRAME") || same_word(word, "RECORD") || same_word(word, "ENUM")) {
      outline.types.insert(to_upper(name));
    }
  }
  return outline;
}

}  // namespace rob::lang
