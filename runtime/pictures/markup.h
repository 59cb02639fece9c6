#pragma once

#include <string>
#include <string_view>

#include "lang/text/visible.h"

namespace rob::runtime {

/// A text inside HTML or SVG, between tags or in an attribute.
inline std::string markup(std::string_view text) {
  std::string result;
  for (const char c : lang::visible(text)) {
    if (c == '<') {
      result += "&lt;";
    } else if (c == '&') {
      result += "&amp;";
    } else if (c == '"') {
      result += "&quot;";
    } else {
      result += c;
    }
  }
  return result;
}

}  // namespace rob::runtime
