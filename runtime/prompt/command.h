#pragma once

#include <cstddef>
#include <string>
#include <vector>

namespace rob::runtime {

class Session;

/// A colon command of the prompt: `:override 50%`.
struct Command {
  using Words = std::vector<std::string>;

  const char* name;
  const char* takes;  ///< "[SHARE%]": what may stand after it, for help
  const char* does;
  void (*carry_out)(Session& session, const Words& words);
  /// Words after which the rest of the line is one, as it was typed: file names, source lines.
  std::size_t plain_words = 1000;
};

namespace command {
using Words = Command::Words;
}

}  // namespace rob::runtime
