#include "lang/vm/printing_machine.h"

#include <utility>

#include <fmt/core.h>

#include "lang/text/codes.h"
#include "lang/values/number_text.h"
#include "lang/vm/move_text.h"

namespace rob::lang {

namespace {

std::string name_of(const RobotSignature& robot, int signal) {
  return shown_name(robot.signals[static_cast<std::size_t>(signal)]);
}

Refusal out_of_reach() {
  return {.code = std::string(code::kUnreachable), .message = "out of reach", .help = ""};
}

}  // namespace

PrintingMachine::PrintingMachine(const RobotSignature& robot) : robot_(robot), scripted_(robot) {}

void PrintingMachine::refuse_after(int calls, Refusal refusal) {
  log_.refuse_after(calls);
  refuse(std::move(refusal));
}

Reply PrintingMachine::move(int line, const MoveCommand& command) {
  const auto target = scripted_.target_of(command);
  if (!target) return refuse(out_of_reach());
  const Reply reply = log_.note(line, move_text(robot_, command));
  if (reply == Reply::Done) scripted_.go_to(*target);
  return reply;
}

Reply PrintingMachine::via(int line, const MoveCommand& point) {
  return log_.note(line, via_text(robot_, point));
}

void PrintingMachine::work_in(int line, const Setting& setting) {
  scripted_.work_in(setting);
  log_.write(line, setting_text(setting));
}

Reply PrintingMachine::press(int line, const PressCommand& command) {
  return log_.note(line, press_text(command));
}

Reply PrintingMachine::override_speed(int line, double share) {
  return log_.note(line, fmt::format("override {}%", number_text(share * 100, kNone)));
}

Reply PrintingMachine::carry(int line, const LoadCommand& load) {
  return log_.note(line, load_text(load));
}

Reply PrintingMachine::guard(int line, const Watch& condition) {
  guard_ = condition;
  return log_.note(line, "guard");
}

Reply PrintingMachine::ended(int line, bool& hit) {
  const WatchResult result = scripted_.watch(guard_);
  if (result.error != ArithmeticError::None) {
    const ArithmeticErrorText text = describe(result.error);
    return refuse({std::string(text.code), std::string(text.message), std::string(text.help)});
  }
  hit = result.value.integer != 0;
  return log_.note(line, hit ? "ended hit" : "ended reached");
}

Reply PrintingMachine::live_pace(int line, const Watch&, MoveCommand::Pace) {
  return log_.note(line, "live pace");
}

Reply PrintingMachine::simulate_force(int line, int component, double value, double after) {
  const bool force = component < 3;
  return log_.note(line, fmt::format("simulate {}.{} {} after {}", force ? "force" : "torque",
                                     "xyz"[component % 3], si_text(value, force ? kForce : kTorque),
                                     number_text(after, kTime)));
}

Reply PrintingMachine::when(int line, const Watch&, int& id) {
  const Reply reply = log_.note(line, fmt::format("when {}", whens_ + 1));
  if (reply == Reply::Done) id = ++whens_;
  return reply;
}

Reply PrintingMachine::when_raise(const Place& place, std::string_view text) {
  return log_.note(line_tag(place), fmt::format("raise {}", text));
}

Reply PrintingMachine::when_handle(int line, bool stops) {
  return log_.note(line, stops ? "handle at rest" : "handle");
}

Reply PrintingMachine::leave_handler(int line) { return log_.note(line, "leave handler"); }

Reply PrintingMachine::on_the_way(int line, const PathPlace& place) {
  std::string text =
      fmt::format("{} {}", place.before ? "before" : "after", si_text(place.distance, kLength));
  if (place.lead > 0) text += " lead " + number_text(place.lead, kTime);
  if (place.lead < 0) text += " lag " + number_text(-place.lead, kTime);
  return log_.note(line, std::move(text));
}

Reply PrintingMachine::disarm(int line, int id) {
  return log_.note(line, fmt::format("disarm {}", id));
}

Reply PrintingMachine::halt(int line, std::string_view text) {
  return log_.note(line, fmt::format("halt{}{}", text.empty() ? "" : " ", text));
}

Reply PrintingMachine::ask(int line, std::string_view text, std::optional<std::string>& answer) {
  const Reply reply = log_.note(line, fmt::format("ask {}", text));
  if (reply == Reply::Done && next_answer_ < answers_.size()) answer = answers_[next_answer_++];
  return reply;
}

Reply PrintingMachine::simulate_go(int line, bool go, double after) {
  return log_.note(
      line, fmt::format("simulate {}go after {}", go ? "" : "no ", number_text(after, kTime)));
}

Reply PrintingMachine::simulate_answer(int line, std::string_view text, double after) {
  return log_.note(line,
                   fmt::format("simulate answer {} after {}", text, number_text(after, kTime)));
}

Reply PrintingMachine::start(const Place& place, std::uint32_t task) {
  return log_.note(line_tag(place), fmt::format("start {}", task + 1));
}

Reply PrintingMachine::wait(int line, double seconds) {
  return log_.note(line, "wait " + number_text(seconds, kTime));
}

Reply PrintingMachine::stand(int line, double& now) {
  const Reply reply = scripted_.stands() ? log_.answer() : log_.note(line, "stand");
  if (reply == Reply::Done) now = scripted_.stand();
  return reply;
}

Reply PrintingMachine::waited(int line) {
  const Reply reply = log_.note(line, "waited");
  if (reply == Reply::Done) scripted_.go_on();
  return reply;
}

Reply PrintingMachine::settle(int line) {
  const Reply reply = log_.note(line, "settle");
  if (reply == Reply::Done) scripted_.go_on();
  return reply;
}

Reply PrintingMachine::print(int line, std::string_view text) {
  return log_.note(line, fmt::format("print {}", text));
}

Reply PrintingMachine::write_signal(int line, int signal, bool value) {
  const Reply reply =
      log_.note(line, fmt::format("{} {}", name_of(robot_, signal), value ? "on" : "off"));
  if (reply == Reply::Done) scripted_.write(signal, value ? 1 : 0);
  return reply;
}

Reply PrintingMachine::read(int, Reading what, Slot* value) {
  const Reply reply = is_observation(what) ? log_.answer() : Reply::Done;
  if (reply == Reply::Done) scripted_.read(what, value);
  return reply;
}

Reply PrintingMachine::forward(int, std::span<const double> joints, PoseValue& pose) {
  pose = scripted_.forward(joints);
  return Reply::Done;
}

Reply PrintingMachine::inverse(int, const PoseValue& pose, std::span<const double>,
                               std::span<double> joints) {
  return scripted_.inverse(pose, joints) ? Reply::Done : refuse(out_of_reach());
}

Reply PrintingMachine::write_analog(int line, int signal, double volts) {
  const Reply reply =
      log_.note(line, fmt::format("{} {}", name_of(robot_, signal), number_text(volts, kVoltage)));
  if (reply == Reply::Done) scripted_.write(signal, volts);
  return reply;
}

Reply PrintingMachine::teach(int line, TaughtPoint& point) {
  constexpr double kMillimetres = 1000;  // in 1 m
  const Vector3& p = point.pose.position;
  std::string text = fmt::format("teach {} {:g} {:g} {:g}", point.name, p.x * kMillimetres,
                                 p.y * kMillimetres, p.z * kMillimetres);
  if (!point.frame.empty()) text += fmt::format(" in {}", point.frame);
  if (!point.tool.empty()) text += fmt::format(" with {}", point.tool);
  return log_.note(line, text);
}

Reply PrintingMachine::expectation_failed(int line, std::string_view text) {
  return log_.note(line, fmt::format("failed {}", text));
}

Reply PrintingMachine::simulate(int line, int signal, double value, double after) {
  return log_.note(line, fmt::format("simulate {} {} after {}", name_of(robot_, signal), value,
                                     number_text(after, kTime)));
}

Reply PrintingMachine::pulse(int line, int signal, double seconds) {
  return log_.note(
      line, fmt::format("pulse {} {}", name_of(robot_, signal), number_text(seconds, kTime)));
}

Reply PrintingMachine::read_signal(int line, int signal, bool& value) {
  double number = 0;
  const Reply reply = read_analog(line, signal, number);
  value = number != 0;
  return reply;
}

Reply PrintingMachine::read_analog(int, int signal, double& volts) {
  const Reply reply = log_.answer();
  if (reply != Reply::Done) return reply;
  ++reads_;
  volts = scripted_.value_of(signal);
  return reply;
}

}  // namespace rob::lang
