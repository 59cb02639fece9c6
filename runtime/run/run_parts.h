#pragma once

#include <string>
#include <vector>

#include "runtime/devices/text_devices.h"
#include "runtime/files/data_files.h"
#include "runtime/files/kept_values.h"
#include "runtime/files/signal_script.h"
#include "runtime/run/controller.h"
#include "runtime/run/load.h"
#include "runtime/run/run_result.h"
#include "runtime/run/signal_names.h"

namespace rob::runtime {

/// The common parts of run() and foretell().

SignalNames names_in(const LoadedProgram& program, const motion::RobotModel& robot);
bool has_handlers(const LoadedProgram& program);
/// Where the files of the program are: `data`, or its own folder where that is empty.
std::string data_folder_of(const LoadedProgram& program, const std::string& data);
/// Its PERSIST variables, as their values file calls them.
std::vector<KeptVariable> kept_variables(const LoadedProgram& program);
/// Gives what a program has written or sent to whom it is for.
void hand_over(const Note& note, double time, DataFiles& files, TextDevices& devices);
/// The lines that a script says devices send.
void give_lines(const SignalScript* script, TextDevices& devices);
/// Those whose conditions have come true since the last time.
void give_said_lines(const SignalScript* script, Channels& channels, double time,
                     TextDevices& devices);
/// None without a script.
std::vector<SimulationRule> rules_of(const SignalScript* script);
/// Gives the panel the operator's part of the script.
void prepare_panel(Controller& controller, const SignalScript* script);

/// The program has ended by this error.
void add_failure(RunResult& result, const lang::RuntimeError& failure);
/// The result as one of this program: its name, its files, what the compiler has found.
RunResult of_program(const LoadedProgram& program, RunResult result);

}  // namespace rob::runtime
