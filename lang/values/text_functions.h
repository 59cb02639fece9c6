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
/// longer than the argument, but for STR, REPLACE and PAD.
namespace rob::lang::text_functions {

using Error = ArithmeticError;

/// The longest text that a program can build, in bytes. [choice] far more than a line to be read,
/// and with the text registers, and the texts in arrays and records, a program never holds more
/// than 320 MiB of text, and those of its errors.
inline constexpr std::size_t kMostText = 65536;

/// STR(x, unit, digits): a number in a unit with so many decimals, and without the unit. The unit
/// is known to be one of x's dimension.
inline constexpr std::int64_t kMostDigits = 17;  ///< a double has no more

Error length(Slot* numbers, std::string* texts);      ///< LEN(s)
Error middle(Slot* numbers, std::string* texts);      ///< MID(s, from, count): cut at the ends
Error find(Slot* numbers, std::string* texts);        ///< FIND(s, part): 0 where it is not there
Error upper(Slot* numbers, std::string* texts);       ///< UPPER(s)
Error lower(Slot* numbers, std::string* texts);       ///< LOWER(s)
Error trimmed(Slot* numbers, std::string* texts);     ///< TRIM(s): without blanks at the ends
Error number(Slot* numbers, std::string* texts);      ///< NUM(s): NotANumber
Error replaced(Slot* numbers, std::string* texts);    ///< REPLACE(s, part, by): TextTooLong
Error padded(Slot* numbers, std::string* texts);      ///< PAD(s, n): blanks after, n < 0 before it
Error character(Slot* numbers, std::string* texts);   ///< CHR(n): NoCharacter
Error code_point(Slot* numbers, std::string* texts);  ///< ORD(s) of its first character: NoText
Error iso_time(Slot* numbers, std::string* texts);    ///< NOW(): s since 1970, s ahead of UTC
Error formatted(Slot* numbers, std::string* texts);   ///< STR(x, unit, digits): DigitsOutOfRange

/// MID(text, from, count), in the text itself; and FIND(text, part).
std::string_view part_of(std::string_view text, std::int64_t from, std::int64_t count);
std::int64_t position_in(std::string_view text, std::string_view part);

}  // namespace rob::lang::text_functions
