#pragma once

#include <string>
#include <string_view>

#include "lang/values/arithmetic.h"
#include "lang/values/types.h"

namespace rob::lang {

/// Reads a line that an operator has typed as a value of BOOL, INT or REAL: a literal of the
/// language with its unit, perhaps with a sign, and nothing else. False if it is none of that type.
bool read_answer(std::string_view line, const Type& type, Slot& value);
/// The line as it is; false if it is no text.
bool read_answer(std::string_view line, std::string& value);

/// "'7' is not a length, such as 5mm": for one who has to try again.
std::string misread_answer(std::string_view line, const Type& type);

}  // namespace rob::lang
