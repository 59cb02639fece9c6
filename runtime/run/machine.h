#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "drivers/link/driver.h"
#include "motion/robots/robot_model.h"
#include "motion/servo/servo_backend.h"
#include "runtime/run/load.h"

namespace rob::runtime {

/// The machine that moves: the simulation, or a machine on a wire ("grbl:/dev/ttyUSB0").
struct BackendName {
  const drivers::Driver* driver = nullptr;  ///< null: the simulation
  std::string port;

  bool simulated() const { return driver == nullptr; }
  /// Whether it knows where a hand has moved its axes.
  bool sees_hand() const { return simulated() || driver->sees_hand; }
};

/// As --backend has it; none for what is no backend.
std::optional<BackendName> backend_of(const std::string& text);
/// "sim, grbl:PORT, …": all that there are.
std::string backend_names();

/// A machine that is open: what moves, and what was found out about it that a user has to know.
struct OpenMachine {
  std::unique_ptr<motion::ServoBackend> backend;
  double period = 0;  ///< s of its servo cycles
  std::vector<std::string> notes;
  bool carries_signals = true;  ///< outputs and inputs are those of the machine
};

/// Opens the machine. `robot` becomes what the machine is: it starts where the axes stand, its
/// limits are the tighter ones of the robot file and of the machine. The simulation leaves it as it
/// is. `home`: the machine homes itself first. Throws
/// motion::DriverError, where an axis stands outside of its limits, too; but with `back` such an
/// axis is let go back, slowly: its limit is then where it stands.
OpenMachine open_machine(const BackendName& name, motion::RobotModel& robot, bool home = false,
                         bool back = false);

/// A machine that could not be opened: lost from the beginning, for this reason.
OpenMachine absent_machine(const motion::RobotModel& robot, const std::string& trouble);

/// The same for a program, which is compiled anew for what the machine is. Nothing is opened for
/// one that cannot run.
OpenMachine open_machine(const BackendName& name, LoadedProgram& program,
                         std::optional<motion::Law> law, bool home = false);

}  // namespace rob::runtime
