#pragma once

#include <cstdint>

#include "lang/code/frame_slots.h"
#include "lang/values/types.h"

namespace rob::lang {

/// Where the number slots, or the text slots, of a value begin. They follow one another.
struct SlotsAt {
  enum class Base : std::uint8_t {
    Own,             ///< registers of the current frame
    GlobalRegister,  ///< of the top level, seen from a routine
    GlobalMemory,    ///< `offset` slots after where the memory of the top level begins, likewise
    Place            ///< `offset` slots after the place on the stack that register `place` holds
  };

  Base base = Base::Own;
  std::uint32_t offset = 0;
  Register place = 0;

  SlotsAt behind(int slots) const {
    return {base, offset + static_cast<std::uint32_t>(slots), place};
  }
  bool in_register() const { return base == Base::Own; }
  /// The register that it is.
  Register reg() const { return static_cast<Register>(offset); }
};

/// Where a value lies. Texts and numbers have stacks of their own.
struct Location {
  SlotsAt numbers;
  SlotsAt texts;
  Register count = 0;  ///< of an ARRAY of any length: the register that holds it

  Location behind(Slots slots) const {
    return {numbers.behind(slots.numbers), texts.behind(slots.texts), count};
  }
};

}  // namespace rob::lang
