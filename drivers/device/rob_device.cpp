#include "drivers/device/rob_device.h"

namespace rob::drivers {

using wire::State;
using wire::Type;

void RobDevice::stand_at(const wire::Axes& position) noexcept {
  position_ = position;
  velocity_ = {};
}

void RobDevice::receive(Bytes bytes, std::uint32_t now) noexcept {
  if (bytes.empty()) return;
  const bool paused = static_cast<std::uint32_t>(wire::between(now, received_)) > kPause;
  if (paused) reader_.clear();
  received_ = now;
  wire::Frame frame;
  for (const std::uint8_t byte : bytes) {
    reader_.add({&byte, 1});
    while (reader_.next(frame)) take(frame, now);
  }
}

wire::Wire RobDevice::send() noexcept {
  const wire::Wire out = out_;
  out_.clear();
  return out;
}

void RobDevice::take(const wire::Frame& frame, std::uint32_t now) noexcept {
  step(now);  // the answer says where the axes are now
  const Bytes payload = frame.payload.view();
  last_ = frame.sequence;
  wire::Reference reference;
  switch (frame.type) {
    case Type::Hello:
      return begin_session(frame.sequence, now);
    case Type::Reference:
      if (!wire::parse(payload, settings_.axes, reference)) return refuse(frame);
      take_reference(reference, now);
      break;
    case Type::Enable:
      if (payload.size() != 1 || payload[0] > 1) return refuse(frame);
      if (session_) enable(payload[0] == 1, now);
      break;
    case Type::Stop:
      if (payload.size() != 1 || payload[0] > 1) return refuse(frame);
      stop(payload[0], now);
      break;
    default:
      return refuse(frame);
  }
  answer_state(frame.sequence, now);
}

/// Without force, whatever it was doing.
void RobDevice::begin_session(std::uint8_t sequence, std::uint32_t now) noexcept {
  enable(false, now);
  session_ = true;
  flags_ = 0;
  const wire::Info info{wire::kVersion, static_cast<std::uint8_t>(settings_.axes),
                        settings_.highest_rate, kQueue, settings_.firmware};
  answer(Type::Info, sequence, wire::payload_of(info).view());
}

void RobDevice::refuse(const wire::Frame& frame) noexcept {
  const auto type = static_cast<std::uint8_t>(frame.type);
  answer(Type::Error, frame.sequence, {&type, 1});
}

void RobDevice::enable(bool on, std::uint32_t now) noexcept {
  const bool stopped = (flags_ & (State::kStarved | State::kFault)) != 0;
  if (on == enabled_ || (on && stopped)) return;
  enabled_ = on;
  braking_ = false;
  has_before_ = false;
  count_ = 0;
  velocity_ = {};
  heard_ = now;
}

void RobDevice::stop(int category, std::uint32_t now) noexcept {
  if (category == 0) return enable(false, now);
  braking_ = enabled_;
  count_ = 0;
  has_before_ = false;
}

void RobDevice::take_reference(const wire::Reference& reference, std::uint32_t now) noexcept {
  if (!enabled_ || braking_) return;
  if (wire::between(reference.apply, now) <= 0) {
    ++late_;
    flags_ |= State::kLate;
    return;
  }
  const int last = (first_ + count_ - 1) % kQueue;
  // One that is not later than its neighbour has come twice.
  if (count_ > 0 &&
      wire::between(reference.apply, queue_[static_cast<std::size_t>(last)].apply) <= 0)
    return;
  if (count_ == kQueue) return;
  heard_ = now;  // only a command that is carried out feeds the watchdog
  if (count_ == 0) begin_path(now);
  queue_[static_cast<std::size_t>((first_ + count_++) % kQueue)] = reference;
}

/// From where the axes are now, with the velocity that they have: nothing is left in the queue, so
/// they stand, or have gone on from the last reference.
void RobDevice::begin_path(std::uint32_t now) noexcept {
  before_ = {now, before_.period, position_, velocity_};
  has_before_ = true;
}

void RobDevice::answer(Type type, std::uint8_t sequence, Bytes payload) noexcept {
  out_ = wire::encode(type, sequence, payload);  // half duplex: one question, one answer
}

void RobDevice::answer_state(std::uint8_t sequence, std::uint32_t now) noexcept {
  State state;
  state.time = now;
  state.flags = static_cast<std::uint16_t>(flags_ | (enabled_ ? State::kEnabled : 0) |
                                           (moving() ? State::kMoving : 0));
  state.queue = static_cast<std::uint16_t>(count_);
  state.position = position_;
  state.velocity = velocity_;
  state.last = last_;
  state.broken = static_cast<std::uint16_t>(reader_.broken());
  flags_ &= static_cast<std::uint16_t>(~State::kLate);
  answer(Type::State, sequence, wire::payload_of(state, settings_.axes).view());
}

bool RobDevice::moving() const noexcept {
  for (const std::int32_t v : velocity_)
    if (v != 0) return true;
  return false;
}

/// No reference came, or nothing is left to go to while it moves.
bool RobDevice::starved(std::uint32_t now) const noexcept {
  const auto silent = static_cast<std::uint32_t>(wire::between(now, heard_));
  const std::uint32_t missing = kMissing * static_cast<std::uint32_t>(before_.period);
  return silent > (has_before_ ? kSilence : kFirst) ||
         (count_ == 0 && moving() && missing != 0 && silent > missing);
}

void RobDevice::step(std::uint32_t now) noexcept {
  if (enabled_ && !braking_ && starved(now)) {
    braking_ = true;
    flags_ |= State::kStarved;
  }
  if (braking_) {
    brake(now);
  } else if (enabled_ && has_before_) {
    follow(now);
  }
  stepped_ = now;
}

void RobDevice::follow(std::uint32_t now) noexcept {
  while (count_ > 0 && wire::between(now, queue_[static_cast<std::size_t>(first_)].apply) >= 0) {
    before_ = queue_[static_cast<std::size_t>(first_)];
    first_ = (first_ + 1) % kQueue;
    --count_;
  }
  if (count_ > 0) return between_references(before_, queue_[static_cast<std::size_t>(first_)], now);
  // At the last one: on with its velocity until something comes, or starved() stops it.
  for (std::size_t i = 0; i < static_cast<std::size_t>(settings_.axes); ++i) {
    const std::int64_t since = wire::between(now, before_.apply);
    position_[i] =
        static_cast<std::int32_t>(before_.position[i] + before_.velocity[i] * since / 1'000'000);
    velocity_[i] = before_.velocity[i];
  }
}

/// The cubic through position and velocity of both, in whole numbers: s = 0 … 2^20.
void RobDevice::between_references(const wire::Reference& a, const wire::Reference& b,
                                   std::uint32_t now) noexcept {
  constexpr std::int64_t kOne = 1 << 20;
  const std::int64_t span = wire::between(b.apply, a.apply);
  if (span <= 0) return;
  const std::int64_t s = wire::between(now, a.apply) * kOne / span;
  const std::int64_t s2 = s * s / kOne;
  const std::int64_t s3 = s2 * s / kOne;
  for (std::size_t i = 0; i < static_cast<std::size_t>(settings_.axes); ++i) {
    const std::int64_t way = static_cast<std::int64_t>(b.position[i]) - a.position[i];
    const std::int64_t va = a.velocity[i] * span / 1'000'000;
    const std::int64_t vb = b.velocity[i] * span / 1'000'000;
    const std::int64_t q = (3 * s2 - 2 * s3) * way + (s3 - 2 * s2 + s) * va + (s3 - s2) * vb;
    const std::int64_t v =
        (6 * s - 6 * s2) * way + (3 * s2 - 4 * s + kOne) * va + (3 * s2 - 2 * s) * vb;
    position_[i] = static_cast<std::int32_t>(a.position[i] + q / kOne);
    velocity_[i] = static_cast<std::int32_t>(v / kOne * 1'000'000 / span);
  }
}

/// Each axis by itself, with the greatest deceleration; without force when all stand.
void RobDevice::brake(std::uint32_t now) noexcept {
  const std::int64_t dt = wire::between(now, stepped_);
  const std::int64_t most = settings_.braking * dt / 1'000'000;
  for (std::size_t i = 0; i < static_cast<std::size_t>(settings_.axes); ++i) {
    const std::int64_t v = velocity_[i];
    const std::int64_t next = v > most ? v - most : v < -most ? v + most : 0;
    position_[i] = static_cast<std::int32_t>(position_[i] + (v + next) / 2 * dt / 1'000'000);
    velocity_[i] = static_cast<std::int32_t>(next);
  }
  if (moving()) return;
  const std::uint16_t flags = flags_;
  enable(false, now);
  flags_ = flags;
}

}  // namespace rob::drivers
