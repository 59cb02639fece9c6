#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace rob::lang {

/// The help of `rob help` on a code: beside its title what to do, and an example in which the wrong
/// line stands before the right one.
struct CodeHelp {
  std::string_view code;
  std::string_view title;
  std::string_view explanation;
  std::string_view example = {};
};
std::string help_text(const CodeHelp& help);

/// The help of `rob help` on a word: of a code what help_codes.def says; of a heading of the manual
/// what stands below it; of any other word that the manual explains, what it says of it there.
/// Empty if there is nothing. MIN is a function, min a unit: units count as they are written, all
/// else in any case.
std::string help_on(std::string_view word);

/// All words that help_on() knows, each once.
std::vector<std::string_view> help_topics();

}  // namespace rob::lang
