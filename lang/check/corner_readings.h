#pragma once

#include "lang/syntax/ast.h"
#include "lang/text/diagnostic.h"

namespace rob::lang {

/// Warns where a checked program reads HERE or CLOCK behind a motion that is not exact: it reads
/// them at the decision point of the corner, before the target. Only what certainly comes directly
/// behind such a motion is told; what a branch, a loop or a routine leaves behind is not followed.
void warn_of_corner_readings(const Program& program, Diagnostics& diagnostics);

}  // namespace rob::lang
