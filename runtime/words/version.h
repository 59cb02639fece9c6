#pragma once

namespace rob::runtime {

/// As `rob --version` prints it.
inline constexpr const char* kVersion = "rob 0.1.0";

}  // namespace rob::runtime
