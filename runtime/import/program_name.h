#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace rob::runtime {

/// A name of a URDF as programs and robot files can write it: small letters, digits and _, at most
/// 32, no reserved word, and none of `taken`. `fallback`: where no letter is left.
std::string program_name(std::string_view name, std::string_view fallback,
                         const std::vector<std::string>& taken);

}  // namespace rob::runtime
