#pragma once

#include "lang/syntax/ast.h"
#include "lang/values/builtins.h"

/// Which built-in a call means, by the types of its arguments.
namespace rob::lang {

/// The one that a call with checked arguments means: of those that take so many, one for poses or
/// arrays if the first argument is one.
const Builtin* find_builtin(const Call& call);
/// Whether a checked call computes with INT slots: all its arguments are INT, and the function has
/// such a case. Otherwise its arguments are converted to REAL.
bool computes_whole(const Builtin& builtin, const Call& call);

}  // namespace rob::lang
