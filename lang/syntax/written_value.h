#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "lang/syntax/expression_tree.h"
#include "lang/values/arithmetic.h"
#include "lang/values/types.h"

/// Values of one slot as people write them outside of programs: answers to ASK, fields of CSV, and
/// PERSIST variables in their file.
namespace rob::lang {

/// The INT or REAL of this type that a number is, after a '-' if `negative`; nothing where it
/// is none.
std::optional<Slot> slot_of(const NumberLiteral& number, bool negative, const Type& type);

/// The value that the whole text is: `-20mm` with its unit, `TRUE` or `ON`, `red` of an ENUM.
/// Blanks around it do not count. Nothing where it is no value of this type.
std::optional<Slot> read_scalar(std::string_view text, const Type& type);

/// An example of such a value, for remedies: "7", "5mm", "TRUE", the first name of an ENUM.
std::string example_of(const Type& type);

}  // namespace rob::lang
