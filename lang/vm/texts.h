#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace rob::lang {

/// The longest text that a program can build, in bytes. [choice] far more than a line to be read,
/// and with at most kTextStack text registers and kMemory.texts in arrays and records a program
/// never holds more than 320 MiB of text, and those of kMostTries errors.
inline constexpr std::size_t kMostText = 65536;

/// Appends to a text. Returns false, and leaves the text as it is, if the result would have more
/// than kMostText bytes.
bool append(std::string& text, std::string_view more);

/// As append(), but the result of joining two texts goes to `target`, which may be one of them.
bool join(std::string& target, const std::string& left, const std::string& right);

}  // namespace rob::lang
