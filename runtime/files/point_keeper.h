#pragma once

#include <optional>

#include "lang/machine/machine.h"
#include "lang/machine/point_table.h"

namespace rob::runtime {

/// Where TEACH keeps what it stores. Called from the program's thread, at standstill; may take as
/// long as a file takes to be written.
class PointKeeper {
 public:
  virtual ~PointKeeper() = default;

  /// Why not, if it cannot be kept; what was kept before is still there then.
  virtual std::optional<lang::Refusal> keep(const lang::TaughtPoint& point) = 0;
};

}  // namespace rob::runtime
