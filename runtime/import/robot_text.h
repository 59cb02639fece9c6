#pragma once

#include <string>
#include <string_view>

#include "runtime/import/imported_arm.h"

namespace rob::runtime {

/// The robot file (TOML) of an arm. What a URDF does not say has values that are marked [choice].
/// `source`: the name of the URDF, for the comments.
std::string robot_text(const ImportedArm& arm, std::string_view source);

/// At most so many decimals, rounded where only noise is left after the sixth; no trailing zeros.
std::string decimal(double value);

/// A text in quotation marks, as TOML reads it.
std::string toml_text(std::string_view text);

}  // namespace rob::runtime
