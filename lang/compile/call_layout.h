#pragma once

#include <vector>

#include "lang/code/location.h"
#include "lang/syntax/ast.h"

namespace rob::lang {

/// Where the parameters of a routine lie in its frame, and what its caller has to keep free for
/// them and for the value, which is left where they begin.
struct CallLayout {
  /// One for each parameter. Arrays and records are given by their places, which the routine
  /// copies; one of any length with its length.
  std::vector<Location> homes;
  Location result;  ///< where the routine puts an array or record that it returns
  int registers = 0;
  int text_registers = 0;
};
CallLayout layout_of(const Routine& routine);

}  // namespace rob::lang
