#pragma once

#include <optional>
#include <string>

#include "lang/syntax/ast.h"

namespace rob::lang {

/// How a call of this body can reach its end without RETURN, in words: "the IF in line 2 has no
/// ELSE". Nothing if every way through it ends in RETURN or RAISE, or never ends. The body is
/// checked; conditions that are constant count as what they are.
std::optional<std::string> way_without_return(const Block& body);

}  // namespace rob::lang
