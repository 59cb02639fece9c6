#pragma once

#include "runtime/import/import_robot.h"
#include "runtime/run/run_result.h"

namespace rob::runtime {

/// `rob robot import`: reads a URDF and writes a robot file, whole or not at all. Throws FileError
/// and motion::RobotFileError.
ExitCode import_files(const ImportRequest& request);

}  // namespace rob::runtime
