#pragma once

#include <string>
#include <string_view>

#include "base/nearest_words.h"

namespace rob::lang {

using rob::edit_distance;
using rob::nearest;
using rob::suggest;

/// "did you mean MOVE?", or empty where `suggestion` is.
inline std::string did_you_mean(std::string_view suggestion) {
  if (suggestion.empty()) return "";
  return "did you mean " + std::string(suggestion) + "?";
}

}  // namespace rob::lang
