#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "lang/values/arithmetic.h"

namespace rob::lang {

/// The largest value of a PERSIST variable, as text, in bytes.
inline constexpr std::size_t kMostPersistent = std::size_t{1} << 20U;

/// The value of a PERSIST variable that an earlier run has left: its slots.
struct SavedValue {
  std::vector<Slot> numbers;
  std::vector<std::string> texts;
  std::size_t count = 0;  ///< elements of a LIST
};
/// By the number of the variable; nothing where it begins as the program says.
using SavedValues = std::vector<std::optional<SavedValue>>;

}  // namespace rob::lang
