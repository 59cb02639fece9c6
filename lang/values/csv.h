#pragma once

#include <cstddef>
#include <string>

#include "lang/values/arithmetic.h"
#include "lang/values/types.h"

/// Lines of CSV (RFC 4180), as CSV(x, …) writes them.
namespace rob::lang {

/// Appends a value as a field, or as several with commas between: those of a RECORD one after the
/// other, of a VEC x y z, of a POSE x y z a b c. Numbers have their units, as PRINT writes them; a
/// text stands between quotes where it has to. False as soon as `out` would grow beyond `most`
/// bytes. Not for the tick.
bool append_csv(std::string& out, const Type& type, const Slot* numbers, const std::string* texts,
                std::size_t most);

}  // namespace rob::lang
