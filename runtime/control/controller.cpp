#include "runtime/control/controller.h"

#include <utility>

namespace rob::runtime {

Controller::Controller(const motion::RobotModel& robot,
                       std::unique_ptr<motion::ServoBackend> backend, double override_share,
                       const std::vector<SimulationRule>& script)
    : robot_(robot),
      backend_(std::move(backend)),
      buffer_(static_cast<std::size_t>(robot.look_ahead)),
      planner_(robot, robot.start),
      generator_(robot, buffer_, robot.start),
      handlers_buffer_(static_cast<std::size_t>(robot.look_ahead)),
      handlers_planner_(robot, robot.start),
      handlers_generator_(robot, handlers_buffer_, robot.start),
      machine_(robot, planner_, buffer_, channels_, channels_.program, log_),
      handlers_machine_(robot, handlers_planner_, handlers_buffer_, channels_, channels_.handler,
                        log_),
      motion_task_(robot, generator_, handlers_generator_, override_share, channels_, script),
      servo_task_(robot, *backend_, channels_) {
  machine_.run_handlers_on(handlers_machine_);
  machine_.set_override(override_share);
  channels_.joints.store(robot.start);
  backend_->open();
}

Controller::~Controller() {
  servo_task_.disable();
  backend_->close();
}

}  // namespace rob::runtime
