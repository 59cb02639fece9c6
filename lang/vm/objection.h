#pragma once

#include <optional>

#include "lang/machine/machine.h"

namespace rob::lang {

/// Why something that the program asks for cannot be; nothing if it can.
using Objection = std::optional<Refusal>;

}  // namespace rob::lang
