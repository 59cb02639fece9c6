#pragma once

#include <cstdint>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "lang/text/diagnostic.h"
#include "lang/text/text_parts.h"

namespace rob::lang {

/// The facts that the parser must know of a text beforehand: the files that it USEs, whose names
/// begin `tools.grip`, and the types that it declares itself.
struct Outline {
  struct UsedName {
    std::string name;  ///< as it is written
    Place place;
  };
  std::vector<UsedName> uses;
  std::set<std::string> types;  ///< of FRAME and RECORD, in capitals

  bool names_file(std::string_view word) const;
};

/// `file`: its number, for places; `parts`: where its lines are of.
Outline outline_of(std::string_view source, std::uint32_t file = 0, TextParts parts = {});

}  // namespace rob::lang
