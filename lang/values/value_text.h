#pragma once

#include <cstddef>
#include <cstdint>
#include <string>

#include "lang/values/arithmetic.h"
#include "lang/values/types.h"

namespace rob::lang {

/// TRUE or FALSE.
std::string text_of(bool value);

/// "colour.red".
std::string enum_text(const TypeDetail& enumeration, std::int64_t value);

/// Appends a value as PRINT writes it, from its slots: `20mm`, `(1mm, 2mm, 3mm)`. A text alone is
/// written as it is; inside a compound value between quotes, so that it reads back.
/// False as soon as `out` would grow beyond `most` bytes. Not for the tick.
bool append_value_text(std::string& out, const Type& type, const Slot* numbers,
                       const std::string* texts, std::size_t most);

/// How a value of an ENUM is written: colour.red, or red.
enum class EnumNames : std::uint8_t { WithType, Alone };
/// The same as a part of a value is written, and read back: a text between quotes.
bool append_part_text(std::string& out, const Type& type, const Slot* numbers,
                      const std::string* texts, std::size_t most,
                      EnumNames names = EnumNames::WithType);
/// The same of elements in a row, as of a LIST: `[1, 2]`.
bool append_row_text(std::string& out, const Type& element, std::size_t count, const Slot* numbers,
                     const std::string* texts, std::size_t most,
                     EnumNames names = EnumNames::WithType);

}  // namespace rob::lang
