#pragma once

#include <cstdint>

#include "lang/syntax/ast.h"

namespace rob::lang {

/// How a checked block comes to its end.
enum class Ending : std::uint8_t {
  Never,  ///< every way through it ends in RETURN, or turns for ever
  Maybe,  ///< it depends on values that are not known before the program runs
  Surely  ///< a way that is written leads to its end
};

Ending ending_of(const Block& block);

}  // namespace rob::lang
