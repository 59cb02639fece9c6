#pragma once

#include <optional>
#include <span>
#include <vector>

#include "lang/check/symbols.h"
#include "lang/code/chunk.h"
#include "lang/code/location.h"

namespace rob::lang {

/// A name that an entry of the prompt has declared, as later entries find it.
struct KeptName {
  Symbol symbol;                    ///< what it points to is of this prompt's types, or in `hidden`
  Location home;                    ///< where its value lies
  std::vector<KeptName> hidden;     ///< of a POINT: its joints, and whether they are known
  std::optional<SafeValue> safe{};  ///< of a SIGNAL with SAFE
};

using KnownNames = std::span<const KeptName* const>;

}  // namespace rob::lang
