#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <vector>

#include "runtime/run/load.h"

namespace rob::runtime {

/// The programs that were run at a prompt, for what is said of them later. Each is known by the
/// line of its :run.
class RunTexts {
 public:
  void keep(std::uint32_t line, const LoadedProgram& program);
  void clear() { runs_.clear(); }
  bool empty() const { return runs_.empty(); }

  bool contains(std::uint32_t line) const { return runs_.contains(line); }
  /// A finding about the program of this line, which is there.
  std::string rendered(const lang::Diagnostic& finding, std::uint32_t line) const;
  /// "line 3 begins: MOVE(40,40,0)" of the program run last; there is one.
  std::string beginning_of(lang::Place place) const;

 private:
  struct Run {
    std::string file;
    std::string source;
    std::vector<lang::SourceFile> used;
  };
  std::map<std::uint32_t, Run> runs_;  ///< by the line
};

}  // namespace rob::runtime
