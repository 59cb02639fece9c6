#pragma once

#include <string>
#include <string_view>

namespace rob::motion {

/// A text of a robot file for messages: in quotation marks, its control characters as TOML writes
/// them (`\u000A`). So it stays on one line, and a NUL does not end the message.
std::string quoted(std::string_view text);

}  // namespace rob::motion
