#include "runtime/import/program_name.h"

#include <algorithm>

#include "lang/syntax/keywords.h"

namespace rob::runtime {

namespace {

constexpr std::size_t kLongest = 32;  // of a name in a robot file

bool is_letter(char c) { return c >= 'a' && c <= 'z'; }

char program_letter(char c) {
  if (c >= 'A' && c <= 'Z') return static_cast<char>(c - 'A' + 'a');
  return is_letter(c) || (c >= '0' && c <= '9') ? c : '_';
}

}  // namespace

std::string program_name(std::string_view name, std::string_view fallback,
                         const std::vector<std::string>& taken) {
  std::string made;
  for (const char c : name) made += program_letter(c);
  made.erase(0, std::min(made.find_first_not_of('_'), made.size()));
  if (made.empty() || !is_letter(made.front()))
    made = std::string(fallback) + (made.empty() ? "" : "_") + made;
  made.resize(std::min(made.size(), kLongest));
  if (lang::find_keyword(made)) made += "_" + std::string(fallback);
  const std::string stem = made;
  for (int number = 2; std::ranges::find(taken, made) != taken.end(); ++number) {
    const std::string end = "_" + std::to_string(number);
    made = stem.substr(0, kLongest - end.size()) + end;
  }
  return made;
}

}  // namespace rob::runtime
