#pragma once

#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "lang/text/diagnostic.h"
#include "lang/values/saved_value.h"
#include "lang/values/types.h"

namespace rob::runtime {

/// A PERSIST variable, as its values file calls it: `count`, or `tools.count` of a USEd file.
struct KeptVariable {
  std::string name;
  lang::Type type;
};

/// The content of a values file.
struct WrittenValues {
  struct Line {
    std::string name;  ///< as it is written
    std::string text;  ///< after the '='
    lang::Place place;
  };
  std::map<std::string, Line> lines;  ///< by name in capitals
  lang::SavedValues saved;            ///< of the variables asked for
  lang::Diagnostics diagnostics;
};

/// Reads `name = value` lines, and the values of these variables. A name that none of them has is
/// kept as it is. All errors are found.
WrittenValues read_values(std::string_view text, const std::vector<KeptVariable>& variables);

/// The file's content anew: sorted by name.
std::string text_of_values(const std::map<std::string, WrittenValues::Line>& lines);

}  // namespace rob::runtime
