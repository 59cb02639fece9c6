#pragma once

#include <functional>
#include <limits>
#include <memory>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "drivers/sim/sim_gantry.h"
#include "motion/robots/robot_library.h"
#include "runtime/run/controller.h"
#include "runtime/run/execution.h"
#include "runtime/run/load.h"
#include "runtime/run/run_recorder.h"

namespace rob::test {

inline constexpr const char* kPublishedProgram =
    "MOVE(40,40,0) // X = 40, Y = 40, theta = 0\n"
    "MOVE(140,40,0)\n"
    "MOVE(90,126,0)\n"
    "MOVE(40,40,0)\n"
    "STOP\n"
    "END\n";

inline std::unique_ptr<motion::ServoBackend> simulated(const motion::RobotModel& robot) {
  drivers::SimGantryParameters parameters;
  parameters.start = robot.start;
  for (const motion::Axis& axis : robot.axes) parameters.drives.push_back(axis.drive);
  for (const motion::TwoPositionActuator& a : robot.actuators) {
    parameters.actuators.push_back({a.output, a.input_off, a.input_on, a.travel_time});
  }
  return std::make_unique<drivers::SimGantry>(parameters);
}

/// A program on the gantry, or another robot, in virtual time, on any backend, with what came up
/// kept for inspection.
struct SteppedRun {
  runtime::LoadedProgram program;
  motion::RobotModel robot;  ///< under the program's law
  runtime::Controller controller;
  runtime::ProgramTask task;
  std::vector<runtime::Snapshot> rows;
  runtime::RunRecorder recorder;
  std::function<void(double time)> each_cycle;  ///< may ask the controller for things

  explicit SteppedRun(const std::string& text,
                      std::unique_ptr<motion::ServoBackend> backend = nullptr,
                      double override_share = 1,
                      const motion::RobotModel& on = motion::embedded_robot("gantry"))
      : program(runtime::compile_program("test.rob", text, on)),
        robot(program.robot),
        controller(robot, backend ? std::move(backend) : simulated(robot), override_share),
        task(program.compilation.chunk.value(), controller.machine()),
        recorder(robot, override_share, controller.channels(), controller.log(),
                 {robot, program.compilation.chunk->named_signals},
                 {nullptr, [this](const runtime::Snapshot& row) { rows.push_back(row); }}) {}

  runtime::RunResult run(double most = 1000) {
    const runtime::RunLimits limits{most, std::numeric_limits<std::int64_t>::max()};
    runtime::run_stepped(controller, task, limits, [this] {
      recorder.drain();
      if (each_cycle && !rows.empty()) each_cycle(rows.back().sample.reference.time);
    });
    return recorder.finish();
  }
};

/// What the report says of a line.
inline runtime::LineResult line(const runtime::RunResult& result, int number) {
  for (const runtime::LineResult& row : result.lines)
    if (row.line == number) return row;
  throw std::logic_error("no such line");
}

}  // namespace rob::test
