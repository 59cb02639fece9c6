#pragma once

#include <string>

#include "runtime/prompt/pendant.h"

namespace rob::runtime {

/// Whether the pendant can be shown in so many characters: 40x12 at least.
bool fits_pendant(int columns, int rows);

/// The pendant as text: lines of at most `columns` characters, as many as `rows` at most. The live
/// position of axes and tool, signals, speed, what holds the robot, and the keys that act; or that
/// the terminal is too small. `told`: the last message. `utf8`: else all of it is ASCII.
std::string pendant_view(const Pendant& pendant, const std::string& told, int columns, int rows,
                         bool utf8 = true);

}  // namespace rob::runtime
