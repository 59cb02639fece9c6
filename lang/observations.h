#pragma once

#include <vector>

#include "lang/ast.h"

namespace rob::lang {

/// How many observations of the world a checked expression can make; what is constant makes none.
/// Where it is known already that a TASK changes a global, reading it is one.
int observations(const Expr& expression);

/// The globals in an expression that TASKs change, each once.
std::vector<const Symbol*> observed_globals(const Expr& expression);
/// Whether it reads a variable of the top level.
bool reads_global(const Expr& expression);

}  // namespace rob::lang
