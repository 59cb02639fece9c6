#include "runtime/words/arguments.h"

#include <algorithm>
#include <charconv>
#include <iterator>
#include <string_view>
#include <system_error>
#include <utility>

namespace rob::runtime {

std::optional<double> override_of(const std::string& text) {
  double percent = 0;
  const char* end = text.data() + text.size() - (text.ends_with('%') ? 1 : 0);
  const auto [rest, error] = std::from_chars(text.data(), end, percent);
  const bool number = error == std::errc() && rest == end;
  if (!number || !(percent > 0) || percent > kMostOverride) return std::nullopt;
  return percent / 100;
}

std::optional<double> duration_of(const std::string& text) {
  constexpr double kLongest = 1e6;  // s, as long as a motion or a WAIT may be
  constexpr std::pair<std::string_view, double> kUnits[] = {{"s", 1}, {"min", 60}, {"h", 3600}};
  double number = 0;
  const char* const end = text.data() + text.size();
  const auto [rest, error] = std::from_chars(text.data(), end, number);
  const std::string_view unit(rest, static_cast<std::size_t>(end - rest));
  const auto* const known =
      std::ranges::find(kUnits, unit, &std::pair<std::string_view, double>::first);
  if (error != std::errc() || known == std::end(kUnits)) return std::nullopt;
  const double seconds = number * known->second;
  if (!(seconds > 0) || seconds > kLongest) return std::nullopt;
  return seconds;
}

}  // namespace rob::runtime
