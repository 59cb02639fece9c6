#pragma once

#include <string>
#include <vector>

#include "lang/compile/compile.h"
#include "motion/collision/collision_data.h"

namespace rob::runtime {

/// The OBSTACLEs of a program, as motion knows them; `folder`: where their files are. One that
/// cannot be read is an error of the program.
std::vector<motion::Obstacle> obstacles_of(lang::Compilation& compilation,
                                           const std::string& folder);

}  // namespace rob::runtime
