#pragma once

#include <string>

namespace rob::runtime {

/// The help on a word of the language, a unit or a code; empty if there is none.
std::string explanation_of(const std::string& word);

/// The words, units and codes with help whose names are nearest to `word`: "did you mean …?";
/// empty if none is near.
std::string explained_near(const std::string& word);

}  // namespace rob::runtime
