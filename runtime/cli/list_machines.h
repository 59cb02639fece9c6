#pragma once

#include "runtime/run/run_result.h"

namespace rob::runtime {

/// `rob robots`: the robots that Rob carries, with their axes, signals and motions.
ExitCode list_robots();

/// `rob ports`: the serial ports of this computer, and who may use them.
ExitCode list_ports();

}  // namespace rob::runtime
