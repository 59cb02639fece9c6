#include "runtime/command/task_machine.h"

#include "motion/space/cycle_instant.h"
#include "runtime/command/background_tasks.h"
#include "runtime/command/robot_machine.h"
#include "runtime/command/signal_access.h"

namespace rob::runtime {

using lang::Reply;
using motion::Effect;

TaskMachine::TaskMachine(RobotMachine& robot)
    : robot_(robot),
      channels_(robot.channels()),
      log_(robot.log()),
      period_(robot.robot().reference_period) {}

double TaskMachine::now() const {
  return motion::cycle_instant(channels_.cycle.load(std::memory_order_relaxed), period_);
}

Reply TaskMachine::wait(int /*line*/, double seconds) {
  if (!waiting_since_) waiting_since_ = now();
  if (now() < *waiting_since_ + seconds - motion::kSameInstant) return Reply::Later;
  waiting_since_.reset();
  return Reply::Done;
}

Reply TaskMachine::stand(int /*line*/, double& time) {
  time = now();
  return Reply::Done;
}

Reply TaskMachine::settle(int /*line*/) {
  waiting_since_.reset();
  return Reply::Done;
}

/// The ring is emptied at the beginning of every cycle.
Reply TaskMachine::send(const Effect& effect) {
  if (!channels_.immediate.push(effect)) return Reply::Later;
  log_.queued_effect();
  return Reply::Done;
}

Reply TaskMachine::print(int line, std::string_view text) {
  if (channels_.immediate.full()) return Reply::Later;
  return send({.tag = static_cast<motion::Tag>(line),
               .kind = Effect::Kind::Note,
               .id = log_.keep({Note::Kind::Print, std::string(text)})});
}

Reply TaskMachine::write_signal(int line, int signal, bool value) {
  Effect effect = effect_on(robot_.signal(signal), line);
  effect.kind = Effect::Kind::Output;
  effect.value = value;
  return send(effect);
}

Reply TaskMachine::write_analog(int line, int signal, double volts) {
  Effect effect = effect_on(robot_.signal(signal), line);
  effect.kind = Effect::Kind::Analog;
  effect.volts = volts;
  return send(effect);
}

Reply TaskMachine::pulse(int line, int signal, double seconds) {
  Effect effect = effect_on(robot_.signal(signal), line);
  effect.kind = Effect::Kind::Pulse;
  effect.seconds = seconds;
  return send(effect);
}

Reply TaskMachine::read_signal(int line, int signal, bool& value) {
  value = digital_value(channels_, robot_.signal(signal));
  robot_.note_assumed_value(line, signal);
  return Reply::Done;
}

Reply TaskMachine::read_analog(int line, int signal, double& volts) {
  volts = analog_value(channels_, robot_.signal(signal));
  robot_.note_assumed_value(line, signal);
  return Reply::Done;
}

template <typename Ask>
Reply TaskMachine::asked(const Ask& ask) {
  const Reply reply = robot_.asked_plainly(ask);
  return reply == Reply::Refused ? refuse(robot_.refusal()) : reply;
}

Reply TaskMachine::read(int /*line*/, lang::Reading what, lang::Slot* value) {
  return asked([&] { return robot_.present(what, value); });
}

Reply TaskMachine::forward(int line, std::span<const double> joints, lang::PoseValue& pose) {
  return asked([&] { return robot_.forward(line, joints, pose); });
}

Reply TaskMachine::inverse(int line, const lang::PoseValue& pose, std::span<const double> near,
                           std::span<double> joints) {
  return asked([&] { return robot_.inverse(line, pose, near, joints); });
}

Reply TaskMachine::publish(int /*line*/, std::size_t first, std::span<const lang::Slot> values) {
  robot_.tasks().memory().store(first, values);
  return Reply::Done;
}

Reply TaskMachine::publish(int /*line*/, std::size_t first, std::span<const std::string> texts) {
  robot_.tasks().memory().store(first, texts);
  return Reply::Done;
}

Reply TaskMachine::refresh(int /*line*/, std::size_t first, std::span<lang::Slot> values) {
  robot_.tasks().memory().load(first, values);
  return Reply::Done;
}

Reply TaskMachine::refresh(int /*line*/, std::size_t first, std::span<std::string> texts) {
  robot_.tasks().memory().load(first, texts);
  return Reply::Done;
}

Reply TaskMachine::leave_handler(int /*line*/) {
  robot_.end_call();
  return Reply::Done;
}

}  // namespace rob::runtime
