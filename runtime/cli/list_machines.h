#pragma once

#include <string>
#include <vector>

#include "runtime/run/run_result.h"

namespace rob::runtime {

/// `rob robots`: the robots that Rob carries, with their axes, signals and motions; with names or
/// files these alone, and also how far each reaches and whether it starts near a singular posture.
/// Throws as load_robot() does.
ExitCode list_robots(const std::vector<std::string>& asked);

/// `rob ports`: the serial ports of this computer, and who may use them.
ExitCode list_ports();

}  // namespace rob::runtime
