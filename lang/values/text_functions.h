#pragma once

#include <cstdint>
#include <string>
#include <string_view>

#include "lang/values/arithmetic.h"

/// The functions of the language on texts. Positions count characters (code points) from 1. They
/// are called by the Vm with the numbers and the texts among their arguments, each in order of
/// writing, and leave their result in the first register of its kind.
///
/// UPPER and LOWER know the letters of ASCII and Latin-1; others stay as they are. No result is
/// longer than the argument, but for STR.
namespace rob::lang::text_functions {

using Error = ArithmeticError;

/// STR(x, unit, digits): a number in a unit with so many decimals, and without the unit. The unit
/// is known to be one of x's dimension.
inline constexpr std::int64_t kMostDigits = 17;  ///< a double has no more

Error length(Slot* numbers, std::string* texts);     ///< LEN(s)
Error middle(Slot* numbers, std::string* texts);     ///< MID(s, from, count): cut at the ends
Error find(Slot* numbers, std::string* texts);       ///< FIND(s, part): 0 where it is not there
Error upper(Slot* numbers, std::string* texts);      ///< UPPER(s)
Error lower(Slot* numbers, std::string* texts);      ///< LOWER(s)
Error trimmed(Slot* numbers, std::string* texts);    ///< TRIM(s): without blanks at the ends
Error number(Slot* numbers, std::string* texts);     ///< NUM(s): NotANumber
Error formatted(Slot* numbers, std::string* texts);  ///< STR(x, unit, digits): DigitsOutOfRange

}  // namespace rob::lang::text_functions
