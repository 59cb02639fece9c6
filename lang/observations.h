#pragma once

#include "lang/ast.h"

namespace rob::lang {

/// How many observations of the world a checked expression can make; what is constant makes none.
int observations(const Expr& expression);

}  // namespace rob::lang
