#include "lang/syntax/keywords.h"

#include <algorithm>
#include <array>
#include <string>
#include <vector>

#include "lang/text/ascii.h"

namespace rob::lang {

namespace {

struct Entry {
  std::string_view spelling;
  Keyword keyword;
  KeywordRole role;
};

/// In the order of the enumeration.
constexpr auto kKeywords = std::to_array<Entry>({
#define ROB_KEYWORD(enumerator, spelling, role) {spelling, Keyword::enumerator, KeywordRole::role},
#include "lang/syntax/keywords.def"
#undef ROB_KEYWORD
});

/// For the search by halves; Entry::spelling ascending.
constexpr auto kByName = [] {
  auto sorted = kKeywords;
  std::ranges::sort(sorted, {}, &Entry::spelling);
  return sorted;
}();

constexpr std::size_t kLongest = std::ranges::max(kKeywords, {}, [](const Entry& entry) {
                                   return entry.spelling.size();
                                 }).spelling.size();

const Entry& entry_of(Keyword keyword) { return kKeywords[static_cast<std::size_t>(keyword)]; }

}  // namespace

std::optional<Keyword> find_keyword(std::string_view word) {
  if (word.size() > kLongest) return std::nullopt;
  const std::string upper = to_upper(word);
  const auto found = std::ranges::lower_bound(kByName, upper, {}, &Entry::spelling);
  if (found == kByName.end() || found->spelling != upper) return std::nullopt;
  if (found->keyword == Keyword::Endallow) return std::nullopt;
  return found->keyword;
}

std::string_view spelling(Keyword keyword) { return entry_of(keyword).spelling; }

KeywordRole role(Keyword keyword) { return entry_of(keyword).role; }

bool is_channel_word(std::string_view word) {
  return same_word(word, "DIN") || same_word(word, "DOUT") || same_word(word, "AIN") ||
         same_word(word, "AOUT");
}

std::span<const std::string_view> statement_words() {
  static const std::vector<std::string_view> words = [] {
    std::vector<std::string_view> result;
    for (const Entry& entry : kKeywords) {
      if (entry.role != KeywordRole::Value && entry.role != KeywordRole::Part) {
        result.push_back(entry.spelling);
      }
    }
    return result;
  }();
  return words;
}

}  // namespace rob::lang
