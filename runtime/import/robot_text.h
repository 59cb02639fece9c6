#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "motion/collision/collision_data.h"
#include "runtime/import/imported_arm.h"

namespace rob::runtime {

/// The robot file (TOML) of an arm. Values that a URDF does not say are marked
/// [choice].
/// `links`: base, axes of the chain, flange; `source`: the name of the URDF, for the comments.
std::string robot_text(const ImportedArm& arm, const std::vector<motion::Body>& links,
                       const std::vector<motion::Apart>& touching, std::string_view source);

/// "TOOL camera = POSE(0mm, 0mm, 120mm, 0deg, 0deg, 0deg)": a line of a program.
std::string tool_line(const ImportedTool& tool);

/// At most so many decimals, rounded where only noise is left after the sixth; no trailing zeros.
std::string decimal(double value);

/// A text in quotation marks, as TOML reads it.
std::string toml_text(std::string_view text);

}  // namespace rob::runtime
