#pragma once

#include <string>
#include <vector>

#include "runtime/control/controller.h"
#include "runtime/program/load.h"
#include "runtime/program/run_result.h"
#include "runtime/program/signal_names.h"
#include "runtime/program/signal_script.h"

namespace rob::runtime {

/// What run() and foretell() do alike.

SignalNames names_in(const LoadedProgram& program, const motion::RobotModel& robot);
bool has_handlers(const LoadedProgram& program);
/// None without a script.
std::vector<SimulationRule> rules_of(const SignalScript* script);
/// What the script says and does as the operator.
void prepare_panel(Controller& controller, const SignalScript* script);

/// The program has ended by this error.
void add_failure(RunResult& result, const lang::RuntimeError& failure);
/// The result as one of this program: its name, its files, what the compiler has found.
RunResult of_program(const LoadedProgram& program, RunResult result);

}  // namespace rob::runtime
