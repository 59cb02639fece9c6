#include "motion/robots/quoted.h"

#include <cstdio>

namespace rob::motion {

std::string quoted(std::string_view text) {
  std::string shown = "\"";
  for (const char c : text) {
    const auto code = static_cast<unsigned char>(c);
    if (code >= 0x20 && code != 0x7F) {
      shown += c;
      continue;
    }
    char escape[sizeof "\\u0000"];
    std::snprintf(escape, sizeof escape, "\\u%04X", static_cast<unsigned>(code));
    shown += escape;
  }
  return shown + "\"";
}

}  // namespace rob::motion
