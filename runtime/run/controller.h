#pragma once

#include <memory>
#include <string>
#include <vector>

#include "motion/generate/motion_chain.h"
#include "motion/robots/robot_model.h"
#include "motion/servo/servo_backend.h"
#include "runtime/command/program_log.h"
#include "runtime/command/robot_machine.h"
#include "runtime/run/jog_watch.h"
#include "runtime/tick/channels.h"
#include "runtime/tick/motion_task.h"
#include "runtime/tick/servo_task.h"

namespace rob::runtime {

/// One robot under control for one run: planner, buffer, generator, servo and backend, and the
/// channels between them, each owned here and joined by reference. It has no thread and no clock:
/// run_stepped() and run_threaded() drive the same object.
class Controller {
 public:
  /// `backend` is open. `override_share`: 1 is the programmed speed.
  /// `script`: what drives inputs in place of the machine. `recorded`: periods for WayBack.
  /// `handlers`: the program may have handlers, for which there must be room.
  Controller(const motion::RobotModel& robot, std::unique_ptr<motion::ServoBackend> backend,
             double override_share, const std::vector<SimulationRule>& script = {},
             std::size_t recorded = 0, bool handlers = true);
  /// Drives without force, backend closed.
  ~Controller();
  Controller(const Controller&) = delete;
  Controller& operator=(const Controller&) = delete;

  const motion::RobotModel& robot() const { return robot_; }
  RobotMachine& machine() { return machine_; }
  MotionTask& motion() { return motion_task_; }
  ServoTask& servo() { return servo_task_; }
  Channels& channels() { return channels_; }
  ProgramLog& log() { return log_; }

  /// Before the run: the program is only foretold; see Assumptions.
  void foretell(const std::vector<std::string>& undriven_inputs);
  /// Before the run: motions that were foretold; see ContactProof. Null: none.
  void trust(const std::shared_ptr<const ClearedWays>& cleared) {
    machine_.parts().plans.trust(cleared);
    handlers_machine_.parts().plans.trust(cleared);
  }
  /// Where TEACH keeps points; see OperatorDesk.
  void keep_points(PointKeeper* keeper) {
    machine_.parts().desk.keep_points(keeper);
    handlers_machine_.parts().desk.keep_points(keeper);
  }

  /// The files that the program may use; see FileDesk.
  void keep_files(DataFiles* files) {
    machine_.parts().files.keep_files(files);
    handlers_machine_.parts().files.keep_files(files);
  }

  /// The devices of the program; see DeviceDesk.
  void connect(TextDevices* devices) {
    machine_.parts().devices.connect(devices);
    handlers_machine_.parts().devices.connect(devices);
  }

  /// Plans the path ahead, where the law does; beside the program and the tick. Whether there was
  /// anything to do.
  bool plan_path() {
    const bool handlers = handlers_chain_.plan_path();
    return chain_.plan_path() || handlers;
  }

  /// Measures what is around the robot for its jogs, beside the tick; see JogWatch.
  void watch_jogs() { jog_watch_.look(); }
  /// Whether there is anything to be measured.
  bool watches_jogs() const { return jog_watch_.used(); }

  /// From here on `listener` gets the program's path as it is planned; under the look-ahead law.
  void tell(motion::PathListener& listener) {
    if (chain_.path) chain_.path->planner.tell(listener);
  }

  /// Slow down on the path to rest, within the limits. From any thread.
  void request_hold() { channels_.stop.hold.store(true, std::memory_order_relaxed); }
  /// As fast as the axes can, off the path; then the drives are without force.
  void request_brake() { channels_.stop.brake.store(true, std::memory_order_relaxed); }
  bool holding() const { return channels_.stop.hold.load(std::memory_order_relaxed); }

 private:
  const motion::RobotModel& robot_;
  std::unique_ptr<motion::ServoBackend> backend_;
  Channels channels_;
  ProgramLog log_;
  motion::MotionChain chain_;
  motion::MotionChain handlers_chain_;
  RobotMachine handlers_machine_;
  RobotMachine machine_;
  MotionTask motion_task_;
  ServoTask servo_task_;
  JogWatch jog_watch_;
};

}  // namespace rob::runtime
