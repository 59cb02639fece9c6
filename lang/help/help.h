#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace rob::lang {

/// What `rob help` says of a word of the language, a unit, or a code.
///
/// The texts stand in help_words.def and help_codes.def: one line for each statement, clause,
/// function and unit, and for each line of codes.def.
struct HelpEntry {
  std::string_view topic;
  std::string_view title;  ///< of a code
  std::string_view explanation;
  std::string_view example;  ///< lines of a program, or empty
};

/// Codes first, then words.
std::span<const HelpEntry> help_entries();

/// All that a word means: MIN is a function and a unit. Units count as they are written, everything
/// else in any case.
std::vector<HelpEntry> help_on(std::string_view word);

/// The entry as text to be read, wrapped; a code begins with its title. It says so if the example
/// cannot be read by this version.
std::string help_text(const HelpEntry& entry);

}  // namespace rob::lang
