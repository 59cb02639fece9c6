#pragma once

#include <optional>

#include "lang/ast.h"
#include "lang/reading.h"

namespace rob::lang {

/// What a call of a function of the language reads of the robot: JOINTS(), WRENCH().
std::optional<Reading> reading_of(const Call& call);

/// How many observations of the world a checked expression can make; what is constant makes none.
int observations(const Expr& expression);

}  // namespace rob::lang
