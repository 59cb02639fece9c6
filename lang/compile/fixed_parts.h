#pragma once

#include <vector>

#include "lang/syntax/ast.h"

namespace rob::lang {

/// What is fixed of a condition when the statement is executed that watches it: variables, each
/// once, and the elements and fields of arrays and records, whose index may be computed.
std::vector<const Expr*> fixed_parts_of(const Expr& condition);

}  // namespace rob::lang
