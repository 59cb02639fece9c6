#include "drivers/link/rob_link.h"

#include <algorithm>
#include <cmath>

namespace rob::drivers {

using motion::DriverError;
using motion::DriverStatus;
using wire::State;
using wire::Type;

namespace {

constexpr double kHelloTime = 0.5;  // s [choice] a board may be starting
constexpr int kHellos = 6;
constexpr double kStopTime = 0.05;
constexpr double kMicro = 1e6;
constexpr double kTripForgets = 1.01;  // a cycle: a clock that drifts is followed

std::uint32_t wrapped(double microseconds) noexcept {
  return static_cast<std::uint32_t>(static_cast<std::int64_t>(std::floor(microseconds)));
}

std::int32_t in_range(double value) noexcept {
  constexpr double kMost = 2147483647;
  return static_cast<std::int32_t>(std::lround(std::clamp(value, -kMost, kMost)));
}

}  // namespace

RobLink::RobLink(const std::vector<WireAxis>& axes, double period)
    : axes_(static_cast<int>(axes.size())), period_(period) {}

/// The answer to this question: its SEQ is that of the question.
auto RobLink::ask(Type type, Bytes payload, wire::Frame& answer, double deadline) noexcept
    -> Result {
  const std::uint8_t sequence = ++sequence_;
  Result result = packets_.send(wire::encode(type, sequence, payload).view(), deadline);
  while (result == Result::Ok) {
    result = packets_.receive(answer, deadline);
    if (result == Result::Ok && answer.sequence == sequence) return result;
  }
  return result;
}

void RobLink::connect(SerialPort& port) {
  packets_.attach(port);
  enabled_ = false;
  clocked_ = false;
  wire::Frame answer;
  Result result = Result::TimedOut;
  for (int i = 0; i < kHellos && result == Result::TimedOut; ++i)
    result = ask(Type::Hello, {}, answer, wire_time() + kHelloTime);
  if (result == Result::Gone) {
    lost(port);
    throw DriverError(trouble());
  }
  if (result != Result::Ok)
    throw DriverError("nothing on " + port.path() +
                      " answers to Rob's protocol; check power, cable"
                      " and baud rate, and whether the device has its firmware");
  if (answer.type != Type::Info || !wire::parse(answer.payload.view(), info_))
    throw DriverError("the device on " + port.path() +
                      " answers HELLO with no INFO; its firmware"
                      " does not follow docs/serial-protocol.md");
  if (info_.version != wire::kVersion)
    throw DriverError("the device on " + port.path() + " speaks version " +
                      std::to_string(info_.version) + " of the protocol, this Rob version " +
                      std::to_string(wire::kVersion) + "; bring its firmware up to date");
  if (info_.axes != axes_ || info_.highest_rate == 0)
    throw DriverError("the device on " + port.path() + " has " + std::to_string(info_.axes) +
                      " axes, the robot " + std::to_string(axes_) +
                      "; is it the right robot file?");
}

/// The quickest of the last answers tells best what the device's clock says.
void RobLink::follow_clock(double asked, double answered) noexcept {
  trip_ *= kTripForgets;
  const double trip = answered - asked;
  if (clocked_ && trip > trip_) return;
  clocked_ = true;
  trip_ = trip;
  // Unwrapped towards the present estimate, so that it goes on steadily over 2^32.
  const double middle = (asked + answered) / 2 * kMicro;
  const std::uint32_t expected = wrapped(middle + offset_);
  offset_ += static_cast<double>(wire::between(state_.time, expected));
}

auto RobLink::ask_state(Type type, Bytes payload, double deadline) noexcept -> Result {
  wire::Frame answer;
  const double asked = wire_time();
  const Result result = ask(type, payload, answer, deadline);
  if (result != Result::Ok) return result;
  if (answer.type != Type::State || !wire::parse(answer.payload.view(), axes_, state_)) {
    state_.flags |= State::kFault;
    return result;
  }
  follow_clock(asked, wire_time());
  return result;
}

DriverStatus RobLink::enable() noexcept {
  const std::uint8_t on = 1;
  const Result result = ask_state(Type::Enable, {&on, 1}, wire_time() + kStopTime);
  enabled_ = true;
  return judge(result);
}

/// Its state; drives that it has switched off itself stay off.
auto RobLink::ask_as_it_is(double deadline) noexcept -> Result {
  const std::uint8_t on = enabled_ && (state_.flags & State::kEnabled) != 0 ? 1 : 0;
  return ask_state(Type::Enable, {&on, 1}, deadline);
}

/// Until it is where the last reference is, kLead periods behind it.
void RobLink::run_dry() noexcept {
  const double end = wire_time() + (kLead + 1) * period_;
  while (wire_time() < end && ask_as_it_is(end) == Result::Ok && state_.queue > 0 &&
         judge(Result::Ok) == DriverStatus::Ok) {
  }
}

void RobLink::disable() noexcept {
  if (enabled_) run_dry();
  enabled_ = false;
  for (const std::uint8_t category : {std::uint8_t{1}, std::uint8_t{0}}) {
    const double deadline = wire_time() + kStopTime;
    while (ask_state(Type::Stop, {&category, 1}, deadline) == Result::Ok &&
           (state_.flags & State::kMoving) != 0) {
    }
  }
}

ByteBuffer<wire::kMostPayload> RobLink::reference_of(const WireCommand& command) const noexcept {
  wire::Reference reference;
  reference.apply = wrapped((command.time + kLead * period_) * kMicro + offset_);
  reference.period = static_cast<std::uint16_t>(std::lround(period_ * kMicro));
  for (std::size_t i = 0; i < static_cast<std::size_t>(axes_); ++i) {
    reference.position[i] = in_range(command.position[i]);
    reference.velocity[i] = in_range(command.velocity[i]);
  }
  return wire::payload_of(reference, axes_);
}

DriverStatus RobLink::exchange(const WireCommand* command, double deadline,
                               WireAnswer& answer) noexcept {
  const std::uint32_t broken = packets_.broken();
  const double half = (wire_time() + deadline) / 2;
  const auto once = [&](double until) {
    if (command != nullptr) return ask_state(Type::Reference, reference_of(*command).view(), until);
    return ask_as_it_is(until);
  };
  Result result = once(half);
  if (result == Result::TimedOut) {  // a reference that comes twice is the same reference
    ++errors_;
    result = once(deadline);
  }
  errors_ += packets_.broken() - broken;
  const DriverStatus status = judge(result);
  if (status == DriverStatus::Ok) fill(answer);
  return status;
}

DriverStatus RobLink::judge(Result result) noexcept {
  if (result == Result::Gone) return lost(packets_.port());
  if (result == Result::TimedOut)
    return fail(DriverStatus::Silent, "the device on " + packets_.port().path() +
                                          " does not answer; check its power and its cable");
  if ((state_.flags & State::kFault) != 0)
    return fail(DriverStatus::Alarm,
                "the device reports a fault, or sends what this protocol has not; switch it off"
                " and on, and look where the machine stands");
  if ((state_.flags & State::kStarved) != 0)
    return fail(DriverStatus::Alarm,
                "the device has stopped by itself: references came too late; see"
                " docs/realtime.md if it happens often");
  if (enabled_ && (state_.flags & State::kEnabled) == 0)
    return fail(DriverStatus::Alarm,
                "the device has restarted or was switched off its drives; look where the machine"
                " stands");
  return DriverStatus::Ok;
}

void RobLink::fill(WireAnswer& answer) const noexcept {
  const double now = wire_time();
  const double age = wire::between(wrapped(now * kMicro + offset_), state_.time) / kMicro;
  answer.time = now - std::max(age, 0.0) - (enabled_ ? kLead * period_ : 0);
  for (std::size_t i = 0; i < static_cast<std::size_t>(axes_); ++i) {
    answer.position[i] = state_.position[i];
    answer.velocity[i] = state_.velocity[i];
  }
}

std::unique_ptr<WireLink> rob_link(const std::vector<WireAxis>& axes, double period) {
  return std::make_unique<RobLink>(axes, period);
}

}  // namespace rob::drivers
