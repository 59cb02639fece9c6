#pragma once

#include <string>

#include "runtime/prompt/pendant.h"

namespace rob::runtime {

/// The pendant as text: lines of at most `columns` characters, as many as `rows` at most. The live
/// place of axes and tool, signals, mode, speed, what holds the robot, and the keys.
/// `told`: the last message.
std::string pendant_view(const Pendant& pendant, const std::string& told, int columns, int rows);

}  // namespace rob::runtime
