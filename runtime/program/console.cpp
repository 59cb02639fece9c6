#include "runtime/program/console.h"

#include <cstdio>

namespace rob::runtime {

void put_result(std::string_view text) {
  // A failure sticks to the stream: results_written() asks it.
  std::fwrite(text.data(), 1, text.size(), stdout);
  std::fflush(stdout);
}

void put_message(std::string_view text) { std::fwrite(text.data(), 1, text.size(), stderr); }

bool results_written() { return std::fflush(stdout) == 0 && std::ferror(stdout) == 0; }

}  // namespace rob::runtime
