#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "lang/machine/machine.h"
#include "lang/values/arithmetic.h"
#include "lang/values/types.h"

namespace rob::lang {

/// The rows of a CSV file, as the slots of records one after the other.
struct CsvRows {
  std::vector<Slot> numbers;
  std::vector<std::string> texts;
  std::size_t count = 0;
  std::vector<Refusal> warnings;  ///< columns that the record does not have
};

/// Reads CSV (RFC 4180) whose header names the fields of `record`, in any order; a POSE p has the
/// columns p.x p.y p.z p.a p.b p.c, a VEC its p.x p.y p.z. `rows`: how many there must be; none: as
/// many as there are. Errors begin with the place: "parts.csv:7:3".
std::variant<CsvRows, Refusal> read_csv(std::string_view file, std::string_view text,
                                        const Type& record, std::optional<std::size_t> rows);

}  // namespace rob::lang
