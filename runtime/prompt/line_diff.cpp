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
  std::size_t coming = 0;  // lines that are added here, and follow those that go
  const auto add_coming = [&] {
    for (; coming > 0; --coming) diff.push_back({'+', after[from_after++]});
  };
  for (const auto& [line, element] : found.getSes().getSequence()) {
    if (element.type == dtl::SES_ADD) {
      ++coming;
    } else if (element.type == dtl::SES_DELETE) {
      diff.push_back({'-', before[from_before++]});
    } else {
      add_coming();
      diff.push_back({' ', before[from_before++]});
      ++from_after;
    }
  }
  add_coming();
  return diff;
}

}  // namespace rob::runtime
