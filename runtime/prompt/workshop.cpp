#include "runtime/prompt/workshop.h"

#include <algorithm>

#include "runtime/files/text_lines.h"
#include "runtime/prompt/session_text.h"

namespace rob::runtime {

void Workshop::record(const std::string& entry, const std::vector<lang::DeclaredName>& named,
                      std::uint32_t line) {
  std::string points;
  for (const lang::DeclaredName& name : named) {
    if (name.kind != lang::DeclaredName::Kind::Point) continue;
    const auto declares = [&](const std::string& text) {
      return find_word(text, "POINT") == text.find_first_not_of(" \t") && has_word(text, name.name);
    };
    if (std::ranges::any_of(split_lines(program.text() + entry), declares)) continue;
    points += "POINT " + name.name + "\n";
  }
  program.record(points + entry, line);
}

}  // namespace rob::runtime
