#pragma once

#include <optional>
#include <vector>

#include "lang/machine/reading.h"
#include "lang/syntax/ast.h"

namespace rob::lang {

/// What a call of a function of the language reads of the robot: JOINTS(), WRENCH().
std::optional<Reading> reading_of(const Call& call);

/// How many observations of the world a checked expression can make; what is constant makes none.
/// Where it is known already that a TASK changes a global, reading it is one.
int observations(const Expr& expression);

/// The globals in an expression that TASKs change, each once.
std::vector<const Symbol*> observed_globals(const Expr& expression);
/// Whether it reads a variable of the top level.
bool reads_global(const Expr& expression);

}  // namespace rob::lang
