#pragma once

#include <cstdint>
#include <set>
#include <string>

#include "runtime/prompt/program_file.h"
#include "runtime/prompt/program_text.h"

namespace rob::runtime {

/// What is built at a prompt.
struct Workshop {
  explicit Workshop(const std::string& archive) : file(archive) {}

  ProgramText program;
  ProgramFile file;
  bool records = false;                 ///< what is executed is kept in the program
  std::set<std::uint32_t> breakpoints;  ///< lines of the program; HoldPoints::kMost at most
};

}  // namespace rob::runtime
