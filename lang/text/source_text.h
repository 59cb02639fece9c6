#pragma once

#include <cstddef>
#include <cstdint>
#include <string_view>

#include "lang/text/diagnostic.h"
#include "lang/text/text_parts.h"

/// The form a file must have before it is read as a program: UTF-8 text of bounded size.
namespace rob::lang {

/// [choice] a million lines and more; what is larger was not written by a person, and the memory
/// that its tree would take is no longer bounded sensibly.
inline constexpr std::size_t kMaxSourceBytes = std::size_t{64} << 20U;

/// [choice] hundreds of screen widths; bounds every loop that works within one line.
inline constexpr std::size_t kMaxLineBytes = std::size_t{64} << 10U;

/// True if `source` can be read: valid UTF-8 within the limits, without NUL, its lines ended by LF
/// or CR LF. Otherwise reports what is wrong, each kind once, with the byte offset of the first
/// place. A byte order mark at the beginning and a missing last line end are accepted.
/// `file`: its number, for places; `parts`: where its lines are of.
bool check_source(std::string_view source, Diagnostics& diagnostics, std::uint32_t file = 0,
                  TextParts parts = {});

}  // namespace rob::lang
