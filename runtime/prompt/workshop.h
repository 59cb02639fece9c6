#pragma once

#include <cstdint>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "lang/compile/entries.h"
#include "runtime/prompt/point_wizard.h"
#include "runtime/prompt/program_file.h"
#include "runtime/prompt/program_text.h"

namespace rob::runtime {

/// All that is built at a prompt.
struct Workshop {
  explicit Workshop(const std::string& archive) : file(archive) {}

  /// Adds what was typed from this line of the prompt on. `named`: what occurs in it; points among
  /// that are declared in the program where they are used first.
  void record(const std::string& entry, const std::vector<lang::DeclaredName>& named,
              std::uint32_t line);

  ProgramText program;
  ProgramFile file;
  bool records = false;                 ///< what is executed is kept in the program
  std::set<std::uint32_t> breakpoints;  ///< lines of the program; HoldPoints::kMost at most
  std::optional<PointWizard> wizard{};  ///< asks for positions
};

}  // namespace rob::runtime
