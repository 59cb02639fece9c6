#include "runtime/command/robot_machine.h"

#include <utility>

#include "runtime/command/signal_access.h"
#include "runtime/words/signature.h"

namespace rob::runtime {

using lang::Reply;

RobotMachine::RobotMachine(const motion::RobotModel& robot, motion::MotionPlanner& planner,
                           motion::LookAheadBuffer& buffer, Channels& channels,
                           MotionProgress& progress, ProgramLog& log, RobotMachine* handlers,
                           double override_share)
    : signature_(signature_of(robot)),
      links_{robot,    signature_, planner, buffer,
             channels, progress,   log,     [this](Words why) { return refuse(std::move(why)); }},
      parts_(links_, override_share),
      handlers_(handlers) {
  lead_to(parts_.files, parts_.devices, parts_.reports);
  if (handlers == nullptr) parts_.queue.keep_nothing();
}

void RobotMachine::run_beside(BackgroundTasks& tasks) {
  if (handlers_ != nullptr) handlers_->run_beside(tasks);
  parts_.reports.go_to(tasks);
}

// Commands that concern all parts

void RobotMachine::drop_statement() {
  parts_.waits.drop();
  parts_.desk.drop();
  parts_.devices.drop();
  parts_.guard.switch_to(false);
  parts_.whens.drop();
  parts_.next.drop();
}

Reply RobotMachine::settle(int line) {
  parts_.turns.bar(true);
  if (parts_.turns.has_axes()) {
    if (const Reply reply = drop_interrupted(line); reply != Reply::Done) return reply;
  }
  if (parts_.queue.path_closed() && end_path(line) != Reply::Done) return Reply::Later;
  parts_.queue.drop_path();
  drop_statement();
  const Reply reply = parts_.queue.make_exact(line);
  if (reply != Reply::Done) return reply;
  if (!parts_.progress.settled() || parts_.forces.give_up_press() == Reply::Later)
    return Reply::Later;
  parts_.queue.forget_rests();
  parts_.turns.bar(false);
  return Reply::Done;
}

/// An error in a handler ends it and all that it has interrupted.
Reply RobotMachine::drop_interrupted(int line) {
  Errand& errand = handlers_->parts_.errand;
  if (!errand.asked()) {
    if (const Reply reply = handlers_->settle(line); reply != Reply::Done) return reply;
    errand.leave_all();
  }
  return parts_.turns.leave_all() ? Reply::Done : Reply::Later;
}

std::optional<lang::RuntimeError> RobotMachine::take_interruption() {
  const motion::Rest* const rest = links_.progress.rests.front();
  if (rest == nullptr || !rest->failure()) return std::nullopt;
  lang::RuntimeError error = parts_.operator_stop.caused(*rest) ? parts_.operator_stop.take_error()
                                                                : parts_.whens.error_of(*rest);
  parts_.queue.restart_from(rest->q);
  parts_.queue.drop();
  drop_statement();
  links_.progress.rests.pop();
  return error;
}

std::optional<RobotMachine::Handled> RobotMachine::take_handled() {
  const auto begun = parts_.turns.begin();
  if (!begun) return std::nullopt;
  if (!begun->stops) return Handled{begun->id, nullptr};
  handlers_->parts_.errand.begin(parts_.turns, begun->home);
  return Handled{begun->id, handlers_};
}

/// A PATH is open only where a loop in it has been given up.
Reply RobotMachine::end(int line) {
  if (parts_.queue.path_open() && end_path(line) == Reply::Later) return Reply::Later;
  if (parts_.operator_stop.stays()) {
    // A stop there belongs to no line.
    links_.channels.hold_points.end_with(links_.planner.last_number());
    return parts_.whens.disarm_all(line) ? settle(line) : Reply::Later;
  }
  const Reply reply = stop(line);
  if (reply != Reply::Done) return reply;
  if (!parts_.whens.watched()) return Reply::Later;  // a WHEN may still have something to say
  links_.buffer.close();
  parts_.turns.bar(true);
  return Reply::Done;
}

Reply RobotMachine::fail(int line) {
  parts_.turns.bar(true);
  if (parts_.queue.collecting()) parts_.queue.drop_path();
  if (parts_.safe.none() && !parts_.turns.has_axes()) return end(line);
  take_interruption();  // the first error is the one to mend
  const Reply reply = settle(line);
  if (reply != Reply::Done) return reply;
  parts_.turns.bar(true);
  if (parts_.safe.take(parts_.operator_stop.stays()) != Reply::Done) return Reply::Later;
  return end(line);
}

// Motions

Reply RobotMachine::move(int line, const lang::MoveCommand& command) {
  return parts_.motions.move(line, command);
}

Reply RobotMachine::via(int /*line*/, const lang::MoveCommand& point) {
  parts_.next.via(point);
  return Reply::Done;
}

void RobotMachine::work_in(int /*line*/, const lang::Setting& setting) {
  parts_.motions.work_in(setting);
}

Reply RobotMachine::begin_path(int line) { return parts_.motions.begin_path(line); }

Reply RobotMachine::end_path(int line) { return parts_.motions.end_path(line); }

Reply RobotMachine::on_the_way(int /*line*/, const lang::PathPlace& place) {
  parts_.next.on_the_way(place);
  return Reply::Done;
}

Reply RobotMachine::live_pace(int /*line*/, const lang::Watch& pace,
                              lang::MoveCommand::Pace means) {
  parts_.next.live_pace(pace, means);
  return Reply::Done;
}

Reply RobotMachine::override_speed(int line, double share) {
  return parts_.outputs.override_speed(line, share);
}

Reply RobotMachine::carry(int line, const lang::LoadCommand& load) {
  const Reply reply = parts_.motions.carry(line, load);
  if (reply == Reply::Done && parts_.errand.begun()) parts_.errand.tell_load();
  return reply;
}

Reply RobotMachine::stop(int line) { return parts_.queue.stop(line); }

Reply RobotMachine::brake(int /*line*/) {
  if (!parts_.errand.begun()) return parts_.queue.brake();
  parts_.errand.end_path();
  return Reply::Done;
}

Reply RobotMachine::wait(int line, double seconds) { return parts_.waits.wait(line, seconds); }

Reply RobotMachine::forward(int /*line*/, std::span<const double> joints, lang::PoseValue& pose) {
  pose = parts_.readings.forward(parts_.surroundings.setting(), joints);
  return Reply::Done;
}

Reply RobotMachine::inverse(int /*line*/, const lang::PoseValue& pose, std::span<const double> near,
                            std::span<double> joints) {
  const lang::Setting& setting = parts_.surroundings.setting();
  return parts_.readings.inverse(setting, pose, near, joints, links_.refuse);
}

// Signals

Reply RobotMachine::write_signal(int line, int signal, bool value) {
  return parts_.outputs.write_signal(line, signal, value);
}

Reply RobotMachine::write_analog(int line, int signal, double volts) {
  return parts_.outputs.write_analog(line, signal, volts);
}

Reply RobotMachine::pulse(int line, int signal, double seconds) {
  return parts_.outputs.pulse(line, signal, seconds);
}

Reply RobotMachine::read_signal(int line, int signal, bool& value) {
  if (!parts_.progress.observable()) return Reply::Later;
  value = digital_value(links_.channels, links_.signal(signal));
  parts_.waits.note_read(line, signal);
  return Reply::Done;
}

Reply RobotMachine::read_group(int line, int signal, int count, std::int64_t& value) {
  if (!parts_.progress.observable()) return Reply::Later;
  value = group_value(links_.channels, links_.signal(signal), count);
  for (int i = 0; i < count; ++i) parts_.waits.note_read(line, signal + i);
  return Reply::Done;
}

Reply RobotMachine::read_analog(int line, int signal, double& volts) {
  if (!parts_.progress.observable()) return Reply::Later;
  volts = analog_value(links_.channels, links_.signal(signal));
  parts_.waits.note_read(line, signal);
  return Reply::Done;
}

Reply RobotMachine::guard(int /*line*/, const lang::Watch& condition) {
  parts_.guard.set(condition);
  return Reply::Done;
}

Reply RobotMachine::ended(int line, bool& hit) { return parts_.motions.ended(line, hit); }

Reply RobotMachine::when(int line, const lang::Watch& condition, int& id) {
  return parts_.whens.begin(line, condition, id);
}

Reply RobotMachine::when_raise(const lang::Place& place, std::string_view text) {
  return parts_.whens.raise(place, text);
}

Reply RobotMachine::when_handle(int /*line*/, bool stops) { return parts_.whens.handle(stops); }

Reply RobotMachine::leave_handler(int line) { return parts_.errand.leave(line); }

Reply RobotMachine::disarm(int line, int id) { return parts_.whens.disarm(line, id); }

Reply RobotMachine::stand(int line, double& now) { return parts_.waits.stand(line, now); }

bool RobotMachine::taken_as_met(int line) { return parts_.assumptions.taken_as_met(line); }

Reply RobotMachine::waited(int line) { return parts_.waits.waited(line); }

// Output, Operator, Force

Reply RobotMachine::print(int line, std::string_view text) {
  return parts_.outputs.note(line, {Note::Kind::Print, std::string(text)});
}

Reply RobotMachine::halt(int line, std::string_view text) { return parts_.desk.halt(line, text); }

Reply RobotMachine::ask(int line, std::string_view text, std::optional<std::string>& answer) {
  return parts_.desk.ask(line, text, answer);
}

Reply RobotMachine::teach(int /*line*/, lang::TaughtPoint& point) {
  return parts_.desk.teach(point);
}

Reply RobotMachine::press(int line, const lang::PressCommand& command) {
  return parts_.forces.press(line, command);
}

Reply RobotMachine::end_press(int line) { return parts_.forces.end_press(line); }

Reply RobotMachine::zero_force(int line) { return parts_.forces.zero_force(line); }

// Testing

Reply RobotMachine::expectation_failed(int line, std::string_view text) {
  links_.log.expect_failed({line, std::string(text)});
  return Reply::Done;
}

Reply RobotMachine::simulate(int line, int signal, double value, double after) {
  return parts_.outputs.simulate(line, signal, value, after);
}

Reply RobotMachine::simulate_force(int line, int component, double value, double after) {
  if (!parts_.queue.rested()) return Reply::Later;
  const motion::Pose frame = parts_.surroundings.frame();
  return parts_.outputs.simulate_force(line, component, frame, value, after);
}

Reply RobotMachine::simulate_go(int line, bool go, double after) {
  return go ? parts_.outputs.simulate_go(line, after) : Reply::Done;
}

Reply RobotMachine::simulate_answer(int line, std::string_view text, double after) {
  return parts_.outputs.simulate_answer(line, text, after);
}

// Machine

Reply RobotMachine::read(int /*line*/, lang::Reading what, lang::Slot* value) {
  return parts_.readings.read(what, parts_.surroundings.setting(), value);
}

Reply RobotMachine::leave_block(int /*line*/) {
  return parts_.progress.decided() ? Reply::Done : Reply::Later;
}

}  // namespace rob::runtime
