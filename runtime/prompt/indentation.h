#pragma once

#include <string>
#include <string_view>

namespace rob::runtime {

/// The blanks that a line after these begins with: as many as the last one, and two more after a
/// line that opens a block.
std::string indent_after(std::string_view block);

/// A line that was typed after `indent`: the end of a block, or its next part, stands two blanks
/// further left, and blanks that were typed count alone.
std::string laid_out(std::string_view line, std::string_view indent);

}  // namespace rob::runtime
