#include "runtime/prompt/indentation.h"

#include <algorithm>

#include "runtime/prompt/entry_lines.h"

namespace rob::runtime {

namespace {

constexpr std::size_t kStep = 2;

}  // namespace

std::string indent_after(std::string_view block) {
  const std::string_view line = block.substr(block.rfind('\n') + 1);  // 0 on the first line
  const std::size_t blanks = std::min(line.find_first_not_of(' '), line.size());
  return std::string(blanks + (EntryLines::opens(line) ? kStep : 0), ' ');
}

std::string laid_out(std::string_view line, std::string_view indent) {
  if (indent.empty() || !line.starts_with(indent)) return std::string(line);
  const std::string_view own = line.substr(indent.size());
  if (own.starts_with(' ')) return std::string(own);
  const std::size_t back = EntryLines::ends_part(own) ? std::min(kStep, indent.size()) : 0;
  return std::string(line.substr(back));
}

}  // namespace rob::runtime
