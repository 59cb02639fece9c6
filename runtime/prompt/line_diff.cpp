#include "runtime/prompt/line_diff.h"

#include <cstddef>
#include <dtl/dtl.hpp>

namespace rob::runtime {

std::vector<DiffLine> line_diff(const std::vector<std::string>& before,
                                const std::vector<std::string>& after) {
  dtl::Diff<std::string, std::vector<std::string>> found(before, after);
  found.compose();
  std::vector<DiffLine> diff;
  std::size_t from_before = 0;
  std::size_t from_after = 0;
  for (const auto& [line, element] : found.getSes().getSequence()) {
    if (element.type == dtl::SES_ADD) {
      diff.push_back({'+', after[from_after++]});
      continue;
    }
    const bool common = element.type == dtl::SES_COMMON;
    diff.push_back({common ? ' ' : '-', before[from_before++]});
    if (common) ++from_after;
  }
  return diff;
}

}  // namespace rob::runtime
