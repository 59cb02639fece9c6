#include "lang/values/text_functions.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdlib>
#include <cstring>
#include <utility>

#include <fmt/format.h>

#include "lang/text/utf8.h"
#include "lang/values/units.h"

namespace rob::lang::text_functions {
namespace {

constexpr std::string_view kBlanks = " \t\r\n";

std::string_view without_blanks(std::string_view text) {
  const std::size_t first = std::min(text.find_first_not_of(kBlanks), text.size());
  text.remove_prefix(first);
  return text.substr(0, text.find_last_not_of(kBlanks) + 1);
}

/// How many of eight bytes begin a character.
std::int64_t beginnings(const char* bytes) {
  constexpr std::uint64_t kOnes = 0x0101010101010101;
  std::uint64_t eight = 0;
  std::memcpy(&eight, bytes, sizeof eight);
  const std::uint64_t others = eight >> 7 & ~eight >> 6 & kOnes;  // 10xxxxxx
  return 8 - static_cast<std::int64_t>(others * kOnes >> 56);
}

/// The byte at which a character begins, counted from 0; the end of the text if there are fewer.
std::size_t byte_of(std::string_view text, std::int64_t character) {
  std::size_t at = 0;
  for (; character >= 8 && at + 8 <= text.size(); at += 8) character -= beginnings(&text[at]);
  for (; at < text.size(); ++at) {
    if (is_utf8_continuation(text[at])) continue;
    if (character-- == 0) break;
  }
  return at;
}

/// A capital or small letter of Latin-1; between their two rows lie 32 places. The rows begin at
/// 0xC0 and 0xE0, and hold one sign of arithmetic each.
bool has_case_in_latin1(char32_t c, char32_t row) {
  constexpr char32_t kSignInRow = 0x17;
  return c >= row && c <= row + 0x1E && c != row + kSignInRow;
}

/// `from` and `to`: the rows of the letters to be changed and of what they become.
struct Case {
  char first;
  char last;
  char32_t latin1_row;
  int step;
};
constexpr Case kSmall{'a', 'z', 0xE0, -32};
constexpr Case kCapital{'A', 'Z', 0xC0, +32};

/// In place: a letter and its other form take equally many bytes.
void change_case(std::string& text, const Case& from) {
  for (std::size_t at = 0; at < text.size(); ++at) {
    if (text[at] >= from.first && text[at] <= from.last) {
      text[at] = static_cast<char>(text[at] + from.step);
    } else if (at + 1 < text.size() && text[at] == '\xC3') {
      // U+00C0 to U+00FF are C3 80 to C3 BF: both rows share the first byte.
      const CodePoint point = decode_utf8(std::string_view(text).substr(at));
      ++at;
      if (has_case_in_latin1(point.value, from.latin1_row)) {
        text[at] = static_cast<char>(text[at] + from.step);
      }
    }
  }
}

bool is_digit(char c) { return c >= '0' && c <= '9'; }

/// Takes digits from the beginning; false if there is none.
bool skip_digits(std::string_view& text) {
  const std::size_t count =
      static_cast<std::size_t>(std::ranges::find_if_not(text, is_digit) - text.begin());
  text.remove_prefix(count);
  return count > 0;
}

/// digits [ "." digits ] [ ("e"|"E") ["+"|"-"] digits ]: a number as programs write it.
bool is_number(std::string_view text) {
  if (!skip_digits(text)) return false;
  if (text.starts_with('.')) {
    text.remove_prefix(1);
    if (!skip_digits(text)) return false;
  }
  if (text.starts_with('e') || text.starts_with('E')) {
    text.remove_prefix(1);
    if (text.starts_with('+') || text.starts_with('-')) text.remove_prefix(1);
    if (!skip_digits(text)) return false;
  }
  return text.empty();
}

}  // namespace

std::string_view part_of(std::string_view text, std::int64_t from, std::int64_t count) {
  // No text is longer, so counts and positions beyond mean the same; and their sum is an INT.
  constexpr std::int64_t kBeyond = std::int64_t{1} << 32;
  from = std::clamp(from, -kBeyond, kBeyond);
  const std::int64_t end = from + std::clamp(count, std::int64_t{0}, 2 * kBeyond);
  const std::int64_t before = std::max<std::int64_t>(from - 1, 0);
  text.remove_prefix(byte_of(text, before));
  return text.substr(0, byte_of(text, std::max<std::int64_t>(end - 1 - before, 0)));
}

std::int64_t position_in(std::string_view text, std::string_view part) {
  const std::size_t at = text.find(part);
  return at == text.npos ? 0 : std::int64_t{count_code_points(text.substr(0, at))} + 1;
}

Error length(Slot* numbers, std::string* texts) {
  numbers[0].integer = count_code_points(texts[0]);
  return Error::None;
}

Error middle(Slot* numbers, std::string* texts) {
  texts[0] = std::string(part_of(texts[0], numbers[0].integer, numbers[1].integer));
  return Error::None;
}

Error find(Slot* numbers, std::string* texts) {
  numbers[0].integer = position_in(texts[0], texts[1]);
  return Error::None;
}

Error upper(Slot*, std::string* texts) {
  change_case(texts[0], kSmall);
  return Error::None;
}

Error lower(Slot*, std::string* texts) {
  change_case(texts[0], kCapital);
  return Error::None;
}

Error trimmed(Slot*, std::string* texts) {
  texts[0] = std::string(without_blanks(texts[0]));
  return Error::None;
}

Error replaced(Slot*, std::string* texts) {
  const std::string& part = texts[1];
  if (part.empty()) return Error::None;
  std::string result;
  std::size_t from = 0;
  for (std::size_t at = texts[0].find(part); at != std::string::npos;
       at = texts[0].find(part, from)) {
    result.append(texts[0], from, at - from);
    result += texts[2];
    from = at + part.size();
    if (result.size() > kMostText) return Error::TextTooLong;
  }
  result.append(texts[0], from);
  if (result.size() > kMostText) return Error::TextTooLong;
  texts[0] = std::move(result);
  return Error::None;
}

Error padded(Slot* numbers, std::string* texts) {
  constexpr std::int64_t kMost{kMostText};
  const std::int64_t wanted = std::clamp(numbers[0].integer, -kMost - 1, kMost + 1);
  const std::int64_t missing = std::abs(wanted) - std::int64_t{count_code_points(texts[0])};
  if (missing <= 0) return Error::None;
  const auto count = static_cast<std::size_t>(missing);
  if (texts[0].size() + count > kMostText) return Error::TextTooLong;
  texts[0].insert(wanted < 0 ? 0 : texts[0].size(), count, ' ');
  return Error::None;
}

Error character(Slot* numbers, std::string* texts) {
  const std::int64_t number = numbers[0].integer;
  const bool surrogate = number >= 0xD800 && number <= 0xDFFF;
  if (number < 1 || number > 0x10FFFF || surrogate) return Error::NoCharacter;
  texts[0].clear();
  append_utf8(texts[0], static_cast<char32_t>(number));
  return Error::None;
}

Error code_point(Slot* numbers, std::string* texts) {
  if (texts[0].empty()) return Error::NoText;
  numbers[0].integer = static_cast<std::int64_t>(decode_utf8(texts[0]).value);
  return Error::None;
}

Error number(Slot* numbers, std::string* texts) {
  std::string_view text = without_blanks(texts[0]);
  const bool negative = text.starts_with('-');
  if (negative || text.starts_with('+')) text.remove_prefix(1);
  if (!is_number(text)) return Error::NotANumber;
  const auto value = quantity_of(text, Unit{});
  if (!value) return Error::NotFinite;
  numbers[0].real = (negative ? -*value : *value) + 0.0;
  return Error::None;
}

Error iso_time(Slot* numbers, std::string* texts) {
  using namespace std::chrono;
  const auto offset = static_cast<std::int64_t>(numbers[1].real);
  const auto millis = static_cast<std::int64_t>(std::round(numbers[0].real * 1000));
  const sys_time<milliseconds> local{milliseconds(millis + offset * 1000)};
  const auto day = floor<days>(local);
  const year_month_day date(day);
  const hh_mm_ss time(local - day);
  const std::int64_t minutes = std::abs(offset) / 60;
  texts[0] = fmt::format("{:04}-{:02}-{:02}T{:02}:{:02}:{:02}.{:03}{}{:02}:{:02}",
                         static_cast<int>(date.year()), static_cast<unsigned>(date.month()),
                         static_cast<unsigned>(date.day()), time.hours().count(),
                         time.minutes().count(), time.seconds().count(), time.subseconds().count(),
                         offset < 0 ? '-' : '+', minutes / 60, minutes % 60);
  return Error::None;
}

Error formatted(Slot* numbers, std::string* texts) {
  const std::int64_t digits = numbers[1].integer;
  if (digits < 0 || digits > kMostDigits) return Error::DigitsOutOfRange;
  const Unit unit = texts[0].empty() ? Unit{} : *find_unit(texts[0]);
  const double value = number_in(unit, numbers[0].real);
  if (!std::isfinite(value)) return Error::NotFinite;
  texts[0] = fmt::format("{:.{}f}", value, digits);
  // A value rounded to zero has no sign.
  if (texts[0].find_first_not_of("-0.") == std::string::npos && texts[0].starts_with('-')) {
    texts[0].erase(0, 1);
  }
  return Error::None;
}

}  // namespace rob::lang::text_functions
