#include "runtime/run/controller.h"

#include <algorithm>
#include <utility>

namespace rob::runtime {

namespace {

// [choice] what the motions of a handler may need
constexpr std::size_t kHandlersPieces = 2048;
constexpr std::size_t kHandlersMotions = 512;

motion::MotionChain::Room handlers_room(const motion::RobotModel& robot, bool handlers) {
  if (!handlers) return {1, 16};  // nothing ever moves there
  return {std::min(static_cast<std::size_t>(robot.look_ahead), kHandlersMotions), kHandlersPieces};
}

}  // namespace

Controller::Controller(const motion::RobotModel& robot,
                       std::unique_ptr<motion::ServoBackend> backend, double override_share,
                       const std::vector<SimulationRule>& script, std::size_t recorded,
                       bool handlers)
    : robot_(robot),
      backend_(std::move(backend)),
      chain_(robot),
      handlers_chain_(robot, handlers_room(robot, handlers)),
      handlers_machine_(robot, handlers_chain_.planner, handlers_chain_.buffer, channels_,
                        channels_.handler, log_),
      machine_(robot, chain_.planner, chain_.buffer, channels_, channels_.program, log_,
               handlers ? &handlers_machine_ : nullptr, override_share),
      motion_task_(robot, *chain_.generator, *handlers_chain_.generator, override_share, channels_,
                   script, recorded),
      servo_task_(robot, *backend_, channels_),
      jog_watch_(robot, channels_) {
  channels_.analog_inputs.use(robot.analog_inputs);
  channels_.analog_outputs.use(robot.analog_outputs);
  channels_.joints.store(robot.start);
  channels_.of_machine = [this](const motion::FollowingFinding& finding) {
    return finding.axis < 0 ? backend_->trouble() : backend_->remark();
  };
}

void Controller::foretell(const std::vector<std::string>& undriven_inputs) {
  for (RobotMachine* const machine : {&machine_, &handlers_machine_}) {
    machine->parts().assumptions.foretell(undriven_inputs);
    machine->parts().queue.leave_out_settling();
  }
}

Controller::~Controller() {
  servo_task_.disable();
  backend_->close();
}

}  // namespace rob::runtime
