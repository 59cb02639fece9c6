#include "runtime/prompt/declared_points.h"

#include "lang/text/ascii.h"
#include "runtime/files/text_lines.h"
#include "runtime/prompt/session_text.h"

namespace rob::runtime {

void DeclaredPoints::count(std::string_view line, int change) {
  if (find_word(line, "POINT") != line.find_first_not_of(" \t")) return;
  for (std::size_t i = 0; i < line.size();) {
    std::size_t end = i;
    while (end < line.size() && lang::in_word(line[end])) ++end;
    if (end > i) names_[lang::to_upper(line.substr(i, end - i))] += change;
    i = end + 1;
  }
}

bool DeclaredPoints::has(std::string_view name) const {
  const auto found = names_.find(lang::to_upper(name));
  return found != names_.end() && found->second > 0;
}

bool declares_point(std::string_view text, std::string_view name) {
  DeclaredPoints points;
  while (!text.empty()) points.add(take_line(text));
  return points.has(name);
}

}  // namespace rob::runtime
