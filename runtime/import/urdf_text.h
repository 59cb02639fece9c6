#pragma once

#include <map>
#include <string>
#include <string_view>

namespace rob::runtime {

/// Refuses a text that is no XML, or a xacro, or such that a reader of XML could come to harm: not
/// UTF-8, nested without end, with endless tags. Throws motion::RobotFileError.
///
/// Returns how many <collision> each link has, by its name as it is written.
std::map<std::string, std::size_t> check_urdf_text(std::string_view text, const std::string& file);

}  // namespace rob::runtime
