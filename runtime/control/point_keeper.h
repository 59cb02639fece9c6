#pragma once

#include <optional>
#include <span>
#include <string_view>

#include "lang/machine/machine.h"
#include "lang/values/pose_math.h"

namespace rob::runtime {

/// Where TEACH keeps what it stores. Called from the program's thread, at standstill; may take as
/// long as a file takes to be written.
class PointKeeper {
 public:
  virtual ~PointKeeper() = default;

  /// `frame`: of the program, that `pose` is in; empty for the world. `joints` in the order of the
  /// axes; none where a tool was on. Why not, if it cannot be kept; what was kept before is still
  /// there then.
  virtual std::optional<lang::Refusal> keep(std::string_view point, std::string_view frame,
                                            const lang::PoseValue& pose,
                                            std::span<const double> joints) = 0;
};

}  // namespace rob::runtime
