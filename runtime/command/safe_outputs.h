#pragma once

#include <cstddef>
#include <span>

#include "lang/code/chunk.h"
#include "runtime/command/program_effects.h"

namespace rob::runtime {

/// SAFE: the values that outputs take when a run has failed.
class SafeOutputs {
 public:
  SafeOutputs(const RobotLinks& links, ProgramEffects& effects)
      : links_(links), effects_(effects) {}

  bool none() const { return links_.channels.safe.empty(); }
  /// These, and no others, before the run.
  void declare(std::span<const lang::SafeValue> values);
  /// All of them, the first of which have been declared before.
  void declare_further(std::span<const lang::SafeValue> values);
  /// Outputs take them: for good, or at a prompt (`stays`) until the next entry.
  lang::Reply take(bool stays);

 private:
  const RobotLinks& links_;
  ProgramEffects& effects_;
  std::size_t queued_ = 0;
};

}  // namespace rob::runtime
