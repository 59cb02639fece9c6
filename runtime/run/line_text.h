#pragma once

#include <string>
#include <vector>

#include "lang/text/diagnostic.h"

namespace rob::runtime {

/// A line in a trace, a record or a picture: "5", or "tools.rob:5" in a USEd file, whose name has
/// no comma. `tag`: a lang::line_tag(); `used`: the names of the files that the program USEs.
inline std::string line_text(int tag, const std::vector<std::string>& used) {
  const lang::Place place = lang::tagged_place(tag);
  if (place.file == 0) return std::to_string(place.line);
  const std::string& path = used[place.file - 1];
  return path.substr(path.rfind('/') + 1) + ":" + std::to_string(place.line);
}

}  // namespace rob::runtime
