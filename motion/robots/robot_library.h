#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "motion/robots/robot_model.h"

namespace rob::motion {

/// A robot file carried inside the library (motion/robots/*.toml, put there by embed.cmake).
struct EmbeddedRobot {
  std::string_view name;
  std::string_view text;
};

std::span<const EmbeddedRobot> embedded_robots();

}  // namespace rob::motion
