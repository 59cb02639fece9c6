#pragma once

#include <string>
#include <string_view>

/// Texts of others, such as names of files and what a program prints, as a person may see them: no
/// character of them moves a cursor, turns the direction of writing or begins a line. A character
/// left out is written as Rob's texts write it (`\n`, `\u{1B}`); bytes that are no UTF-8 as `\xFF`.
namespace rob::lang {

/// On one line, for messages: control characters (C0, DEL, C1), line and paragraph separators, and
/// the characters that turn the direction of writing (U+202A to U+202E, U+2066 to U+2069).
std::string visible(std::string_view text);

/// The same, but line ends and tabs stay: for texts that may have several lines.
std::string visible_lines(std::string_view text);

/// Only what begins a line is replaced, so that the text stays on one; all other bytes stay. For
/// what programs read, too, such as the names of files in messages.
std::string on_one_line(std::string_view text);

/// For a terminal that shows no more: arrows, dots and signs as people write them in ASCII, any
/// other character as visible() writes what it replaces.
std::string in_ascii(std::string_view text);

/// For a JSON document: what visible() replaces, as `\u009b`. It means the same.
std::string visible_json(std::string_view document);

}  // namespace rob::lang
