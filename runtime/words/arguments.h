#pragma once

#include <optional>
#include <string>

/// Shares and times as people write them on a command line or at the prompt.
namespace rob::runtime {

inline constexpr double kMostOverride = 200;  // % (docs/cli.md)

/// "50%" or "50": a share of the programmed speed; none if it is not from above 0 to 200 %.
std::optional<double> override_of(const std::string& text);

/// "90s", "20min", "8h": s; none if it is not above 0, or beyond what a run can last.
std::optional<double> duration_of(const std::string& text);

}  // namespace rob::runtime
