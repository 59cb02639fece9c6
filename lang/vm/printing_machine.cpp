#include "lang/vm/printing_machine.h"

#include <algorithm>
#include <utility>

#include <fmt/core.h>

#include "lang/machine/cartesian_axes.h"
#include "lang/machine/move_pose.h"
#include "lang/text/codes.h"
#include "lang/values/number_text.h"
#include "lang/values/pose_slots.h"

namespace rob::lang {
PrintingMachine::PrintingMachine(const RobotSignature& robot) : robot_(robot) {}

void PrintingMachine::script(int signal, std::vector<double> values) {
  scripts_[signal] = {.values = std::move(values)};
}

void PrintingMachine::refuse_after(int calls, Refusal refusal) {
  refuse_after_ = calls;
  refuse(std::move(refusal));
}

std::vector<std::string> PrintingMachine::texts() const {
  std::vector<std::string> texts;
  for (const Call& call : calls_) texts.push_back(call.text);
  return texts;
}

Reply PrintingMachine::ready() {
  if (later_ > 0) {
    --later_;
    return Reply::Later;
  }
  if (refuse_after_ && (*refuse_after_)-- == 0) return Reply::Refused;
  return Reply::Done;
}

Reply PrintingMachine::note(int line, std::string text) {
  const Reply reply = ready();
  if (reply == Reply::Done) calls_.push_back({.line = line, .text = std::move(text)});
  return reply;
}

Reply PrintingMachine::move(int line, const MoveCommand& command) {
  std::array<double, kMaxCoordinates> reached = commanded_;
  if (const Reply reply = reach(line, command, reached); reply != Reply::Done) return reply;
  const Reply reply = note(line, move_text(robot_, command));
  if (reply == Reply::Done) commanded_ = reached;
  return reply;
}

/// A spiral ends at its centre and a JOG somewhere: neither is followed.
Reply PrintingMachine::reach(int line, const MoveCommand& command,
                             std::array<double, kMaxCoordinates>& reached) {
  if (command.kind == MotionKind::Spiral || command.kind == MotionKind::Jog) return Reply::Done;
  const bool tuple = command.means == MoveCommand::Target::Coordinates;
  if (command.means == MoveCommand::Target::Pose || (tuple && !is_plain(setting_))) {
    const PoseValue last = tip_of(tool_of(robot_.coordinates, commanded_), setting_);
    const PoseValue pose = target_pose(command, last, setting_, robot_.coordinates);
    return inverse(line, pose, commanded_, reached);
  }
  for (std::size_t i = 0; i < static_cast<std::size_t>(command.count); ++i) {
    if (!command.has(static_cast<int>(i))) continue;
    reached[i] = command.target[i] + (command.relative ? commanded_[i] : 0);
  }
  return Reply::Done;
}

Reply PrintingMachine::via(int line, const MoveCommand& point) {
  return note(line, via_text(robot_, point));
}

void PrintingMachine::work_in(int line, const Setting& setting) {
  setting_ = setting;
  calls_.push_back({.line = line, .text = setting_text(setting)});
}

Reply PrintingMachine::press(int line, const PressCommand& command) {
  return note(line, press_text(command));
}

Reply PrintingMachine::override_speed(int line, double share) {
  return note(line, fmt::format("override {}%", number_text(share * 100, kNone)));
}

Reply PrintingMachine::carry(int line, const LoadCommand& load) {
  return note(line, load_text(load));
}

Reply PrintingMachine::guard(int line, const Watch& condition) {
  guard_ = condition;
  return note(line, "guard");
}

Reply PrintingMachine::ended(int line, bool& hit) {
  struct World final : WatchedWorld {
    PrintingMachine& machine;
    explicit World(PrintingMachine& m) : machine(m) {}
    bool signal(int signal) const noexcept override { return machine.value_of(signal) != 0; }
    double analog(int signal) const noexcept override { return machine.value_of(signal); }
    void read(Reading what, Slot* value) const noexcept override {
      machine.answer(what, {}, value);
    }
  };
  std::size_t looks = 1;
  for (const auto& [signal, script] : scripts_) looks = std::max(looks, script.values.size());
  for (std::size_t look = 0; look < looks && !hit; ++look) {
    const WatchResult result = evaluate(guard_, World(*this));
    if (result.error != ArithmeticError::None) {
      const ArithmeticErrorText text = describe(result.error);
      refuse({std::string(text.code), std::string(text.message), std::string(text.help)});
      return Reply::Refused;
    }
    hit = result.value.integer != 0;
  }
  hit_ = commanded_;
  return note(line, hit ? "ended hit" : "ended reached");
}

Reply PrintingMachine::live_pace(int line, const Watch&, MoveCommand::Pace) {
  return note(line, "live pace");
}

Reply PrintingMachine::simulate_force(int line, int component, double value, double after) {
  const bool force = component < 3;
  return note(line, fmt::format("simulate {}.{} {} after {}", force ? "force" : "torque",
                                "xyz"[component % 3], number_text(value, force ? kForce : kTorque),
                                number_text(after, kTime)));
}

Reply PrintingMachine::when(int line, const Watch&, int& id) {
  const Reply reply = note(line, fmt::format("when {}", whens_ + 1));
  if (reply == Reply::Done) id = ++whens_;
  return reply;
}

Reply PrintingMachine::when_raise(const Place& place, std::string_view text) {
  return note(line_tag(place), fmt::format("raise {}", text));
}

Reply PrintingMachine::when_handle(int line, bool stops) {
  return note(line, stops ? "handle at rest" : "handle");
}

Reply PrintingMachine::leave_handler(int line) { return note(line, "leave handler"); }

Reply PrintingMachine::on_the_way(int line, const PathPlace& place) {
  std::string text =
      fmt::format("{} {}", place.before ? "before" : "after", number_text(place.distance, kLength));
  if (place.lead > 0) text += " lead " + number_text(place.lead, kTime);
  if (place.lead < 0) text += " lag " + number_text(-place.lead, kTime);
  return note(line, std::move(text));
}

Reply PrintingMachine::disarm(int line, int id) { return note(line, fmt::format("disarm {}", id)); }

Reply PrintingMachine::halt(int line, std::string_view text) {
  return note(line, fmt::format("halt{}{}", text.empty() ? "" : " ", text));
}

Reply PrintingMachine::ask(int line, std::string_view text, std::optional<std::string>& answer) {
  const Reply reply = note(line, fmt::format("ask {}", text));
  if (reply == Reply::Done && next_answer_ < answers_.size()) answer = answers_[next_answer_++];
  return reply;
}

Reply PrintingMachine::simulate_go(int line, bool go, double after) {
  return note(line,
              fmt::format("simulate {}go after {}", go ? "" : "no ", number_text(after, kTime)));
}

Reply PrintingMachine::simulate_answer(int line, std::string_view text, double after) {
  return note(line, fmt::format("simulate answer {} after {}", text, number_text(after, kTime)));
}

Reply PrintingMachine::start(const Place& place, std::uint32_t task) {
  return note(line_tag(place), fmt::format("start {}", task + 1));
}

Reply PrintingMachine::wait(int line, double seconds) {
  return note(line, "wait " + number_text(seconds, kTime));
}

Reply PrintingMachine::stand(int line, double& now) {
  const Reply reply = standing_ ? ready() : note(line, "stand");
  if (reply != Reply::Done) return reply;
  if (standing_) ++cycle_;
  standing_ = true;
  now = 0.01 * cycle_;
  return reply;
}

Reply PrintingMachine::waited(int line) {
  const Reply reply = note(line, "waited");
  if (reply == Reply::Done) standing_ = false;
  return reply;
}

Reply PrintingMachine::settle(int line) {
  const Reply reply = note(line, "settle");
  if (reply == Reply::Done) standing_ = false;
  return reply;
}

Reply PrintingMachine::print(int line, std::string_view text) {
  return note(line, fmt::format("print {}", text));
}

Reply PrintingMachine::write_signal(int line, int signal, bool value) {
  const std::string name = shown_name(robot_.signals[static_cast<std::size_t>(signal)]);
  const Reply reply = note(line, fmt::format("{} {}", name, value ? "on" : "off"));
  if (reply == Reply::Done) written_[signal] = value ? 1 : 0;
  return reply;
}

Reply PrintingMachine::read(int, Reading what, Slot* value) {
  const Reply reply = is_observation(what) ? ready() : Reply::Done;
  if (reply != Reply::Done) return reply;
  answer(what, setting_, value);
  return reply;
}

void PrintingMachine::answer(Reading what, const Setting& setting, Slot* value) {
  if (what == Reading::Clock) {
    value->real = 0.01 * cycle_;
  } else if (what == Reading::Joints) {
    for (std::size_t i = 0; i < robot_.axes.size(); ++i) value[i].real = commanded_[i];
  } else if (needs_sensor(what)) {
    const int first = what == Reading::Torque ? 3 : 0;
    const int count = slots_of(what, 0);
    for (int i = 0; i < count; ++i) (value++)->real = value_of(force_part(first + i));
  } else {
    const PoseValue tool =
        tool_of(robot_.coordinates, what == Reading::HitPose ? hit_ : commanded_);
    store(tip_of(tool, setting), value);
  }
}

Reply PrintingMachine::forward(int, std::span<const double> joints, PoseValue& pose) {
  pose = tip_of(tool_of(robot_.coordinates, joints), setting_);
  return Reply::Done;
}

Reply PrintingMachine::inverse(int, const PoseValue& pose, std::span<const double>,
                               std::span<double> joints) {
  if (coordinates_of(robot_.coordinates, flange_for(pose, setting_), joints)) return Reply::Done;
  refuse({.code = std::string(code::kUnreachable), .message = "out of reach", .help = ""});
  return Reply::Refused;
}

Reply PrintingMachine::write_analog(int line, int signal, double volts) {
  const std::string name = shown_name(robot_.signals[static_cast<std::size_t>(signal)]);
  const Reply reply = note(line, fmt::format("{} {}", name, number_text(volts, kVoltage)));
  if (reply == Reply::Done) written_[signal] = volts;
  return reply;
}

Reply PrintingMachine::teach(int line, const TaughtPoint& point) {
  constexpr double kMillimetres = 1000;  // in 1 m
  const Vector3& p = point.pose.position;
  std::string text = fmt::format("teach {} {:g} {:g} {:g}", point.name, p.x * kMillimetres,
                                 p.y * kMillimetres, p.z * kMillimetres);
  if (!point.frame.empty()) text += fmt::format(" in {}", point.frame);
  if (!point.tool.empty()) text += fmt::format(" with {}", point.tool);
  return note(line, text);
}

Reply PrintingMachine::expectation_failed(int line, std::string_view text) {
  return note(line, fmt::format("failed {}", text));
}

Reply PrintingMachine::simulate(int line, int signal, double value, double after) {
  const std::string name = shown_name(robot_.signals[static_cast<std::size_t>(signal)]);
  return note(line, fmt::format("simulate {} {} after {}", name, value, number_text(after, kTime)));
}

Reply PrintingMachine::pulse(int line, int signal, double seconds) {
  const std::string name = shown_name(robot_.signals[static_cast<std::size_t>(signal)]);
  return note(line, fmt::format("pulse {} {}", name, number_text(seconds, kTime)));
}

Reply PrintingMachine::read_signal(int line, int signal, bool& value) {
  double number = 0;
  const Reply reply = read_analog(line, signal, number);
  value = number != 0;
  return reply;
}

Reply PrintingMachine::read_analog(int, int signal, double& volts) {
  const Reply reply = ready();
  if (reply != Reply::Done) return reply;
  ++reads_;
  volts = value_of(signal);
  return reply;
}

double PrintingMachine::value_of(int signal) {
  Script& script = scripts_[signal];
  if (script.values.empty()) return written_[signal];
  const double value = script.values[script.next];
  if (script.next + 1 < script.values.size()) ++script.next;
  return value;
}

}  // namespace rob::lang
