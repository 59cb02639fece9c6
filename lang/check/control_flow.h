#pragma once

#include <optional>
#include <string>

#include "lang/syntax/ast.h"
#include "lang/text/diagnostic.h"

/// Follows the statements of a checked program in the order of their execution.
namespace rob::lang {

/// How a call of this body can reach its end without RETURN, in words: "the IF in line 2 has no
/// ELSE". Nothing if every way through it ends in RETURN or RAISE, or never ends. The body is
/// checked; conditions that are constant count as what they are.
std::optional<std::string> way_without_return(const Block& body);

/// Warns where a checked program reads HERE or CLOCK after a motion that is not exact: it reads
/// them at the decision point of the corner, before the target. Only what certainly comes directly
/// after such a motion is reported; what a branch, a loop or a routine leaves is not followed.
void warn_of_corner_readings(const Program& program, Diagnostics& diagnostics);

}  // namespace rob::lang
