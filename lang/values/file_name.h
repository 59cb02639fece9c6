#pragma once

#include <string>
#include <string_view>

namespace rob::lang {

/// Why a program may not read or write a file of this name, whatever there is on the disk: "it is
/// no name of a file"; empty if it may. The file itself is not looked at.
std::string objection_to_file(std::string_view name);

}  // namespace rob::lang
