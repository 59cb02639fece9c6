#include "lang/lang.h"

#include <fmt/format.h>

#include "lang/text/visible.h"

namespace rob::lang {

std::string diagnose(const Diagnostics& diagnostics, std::string_view file,
                     std::string_view source) {
  std::string text;
  for (const Diagnostic& one : diagnostics.all()) text += render(one, file, source);
  if (diagnostics.left_out() > 0)
    text += fmt::format("{}: and {} more\n", on_one_line(file), diagnostics.left_out());
  return text;
}

}  // namespace rob::lang
