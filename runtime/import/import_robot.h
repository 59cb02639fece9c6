#pragma once

#include <string>

#include "runtime/import/imported_arm.h"

namespace rob::runtime {

/// A robot file made from a URDF, and what is to be said about it.
struct ImportedRobot {
  std::string text;    ///< TOML, which the reader of robot files has accepted
  std::string report;  ///< lines for people
};

/// The request: `rob robot import` (docs/cli.md).
struct ImportRequest {
  std::string urdf;   ///< its file
  std::string robot;  ///< the file to write
  ArmChoice choice;
  std::string
      packages;  ///< where package:// is looked for first; empty: only upwards from the URDF
};

/// `urdf`: the text of the URDF. Throws motion::RobotFileError for what is no arm.
ImportedRobot import_robot(const std::string& urdf, const ImportRequest& request);

}  // namespace rob::runtime
