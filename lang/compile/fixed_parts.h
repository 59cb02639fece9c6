#pragma once

#include <vector>

#include "lang/syntax/ast.h"

namespace rob::lang {

/// The parts of a condition that are fixed when the statement is executed that watches it:
/// variables, each once, and elements and fields of arrays and records, whose index may be
/// computed.
std::vector<const Expr*> fixed_parts_of(const Expr& condition);

}  // namespace rob::lang
