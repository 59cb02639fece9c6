#pragma once

/// The abilities of the terminal, as the environment says: TERM with its entry in terminfo,
/// NO_COLOR, and the character set of the locale.
namespace rob::runtime {

/// It is a terminal that can move its cursor.
bool draws(int descriptor);
/// It is a terminal with colours, and NO_COLOR is not set.
bool shows_colours(int descriptor);
/// The locale's characters are those of UTF-8; else terminals get ASCII alone.
bool locale_is_utf8();

}  // namespace rob::runtime
