#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "lang/text/diagnostic.h"

namespace rob::lang {

/// A program in its canonical layout, or why it cannot have one.
struct Formatting {
  Diagnostics diagnostics;          ///< errors of reading and parsing; empty if there is a text
  std::optional<std::string> text;  ///< empty if the program is not to be touched
};

/// The canonical layout of a program (docs/language.md). It changes blanks, line ends, empty lines
/// and capital letters alone, so the program means what it meant; formatting it once more changes
/// nothing. Works on tokens: what the parser does not have yet is laid out all the same. Comments
/// stay where they are.
Formatting format(std::string_view source);

}  // namespace rob::lang
