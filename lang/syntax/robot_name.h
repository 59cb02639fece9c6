#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "lang/text/diagnostic.h"

namespace rob::lang {

/// The robot that ROBOT names.
struct RobotName {
  std::string name;
  Place place;  ///< of the name
};

/// The robot that a text is written for, looked for before anything else is known of it, since what
/// the text means depends on its robot. Nothing if none is named, or if this is no text.
std::optional<RobotName> declared_robot(std::string_view source);

}  // namespace rob::lang
