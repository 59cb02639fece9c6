#pragma once

#include <optional>
#include <string_view>

#include "lang/syntax/ast.h"

namespace rob::lang {

/// Where a file of a program declares a name (VAR, CONST or FOR), the first time in the order of
/// the text.
std::optional<Place> find_declaration(const Program& program, std::string_view name,
                                      std::uint32_t file);

}  // namespace rob::lang
