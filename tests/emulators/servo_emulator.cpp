#include "tests/emulators/servo_emulator.h"

#include <algorithm>
#include <cmath>

namespace rob::test {

namespace {

constexpr int kBusWatchdog = 98;
constexpr std::uint8_t kTripped = 255;

/// Bit by bit, as the document defines it.
std::uint16_t crc_of(const Octets& bytes) {
  std::uint32_t crc = 0;
  for (const std::uint8_t byte : bytes)
    for (int bit = 7; bit >= 0; --bit) {
      const bool carry = (crc >> 15U & 1U) != (byte >> bit & 1U);
      crc = (crc << 1U & 0xFFFFU) ^ (carry ? 0x8005U : 0U);
    }
  return static_cast<std::uint16_t>(crc);
}

std::uint32_t little(const Octets& p, std::size_t at, int size) {
  std::uint32_t value = 0;
  for (int i = 0; i < size; ++i)
    value |= static_cast<std::uint32_t>(p.at(at + static_cast<std::size_t>(i))) << 8 * i;
  return value;
}

}  // namespace

ServoEmulator::ServoEmulator(Kind kind, int count) : kind_(kind) {
  for (int id = 1; id <= count; ++id) {
    Servo& servo = servos_[id];
    servo.position = kind == Kind::FeetechScs ? 512 : 2048;
    if (kind == Kind::Dynamixel) {
      servo.registers[9] = 250;  // 500 µs, from the factory
      servo.registers[11] = 3;
      servo.registers[48] = 0xFF;
      servo.registers[49] = 0x0F;
      servo.registers[68] = 2;
    } else {
      write(servo, 11, 2, kind == Kind::FeetechScs ? 1023 : 4095);
    }
  }
}

void ServoEmulator::write(Servo& servo, int address, int size, std::uint32_t value) const {
  for (int i = 0; i < size; ++i) {
    const int at = kind_ == Kind::FeetechScs ? address + size - 1 - i : address + i;
    servo.registers[static_cast<std::size_t>(at)] = static_cast<std::uint8_t>(value >> 8 * i);
  }
}

void ServoEmulator::set(int id, int address, int size, std::uint32_t value) {
  const std::lock_guard lock(mutex_);
  write(servos_[id], address, size, value);
}

std::uint32_t ServoEmulator::value(const Servo& servo, int address, int size) const {
  Octets bytes(servo.registers.begin() + address, servo.registers.begin() + address + size);
  if (kind_ == Kind::FeetechScs) std::reverse(bytes.begin(), bytes.end());
  return little(bytes, 0, size);
}

std::uint32_t ServoEmulator::get(int id, int address, int size) const {
  const std::lock_guard lock(mutex_);
  return value(servos_.at(id), address, size);
}

double ServoEmulator::position(int id) const {
  const std::lock_guard lock(mutex_);
  return servos_.at(id).position;
}

double ServoEmulator::position_at(int id, double time) const {
  const std::lock_guard lock(mutex_);
  const Servo& servo = servos_.at(id);
  return servo.position + servo.velocity * (time - on() - last_);
}

void ServoEmulator::stand_at(int id, double ticks) {
  const std::lock_guard lock(mutex_);
  servos_.at(id).position = ticks;
}

bool ServoEmulator::torque(int id) const { return get(id, torque_register(), 1) == 1; }

double ServoEmulator::moved_for() const {
  const std::lock_guard lock(mutex_);
  return last_motion_ - first_motion_;
}

void ServoEmulator::restart(int id) {
  const std::lock_guard lock(mutex_);
  Servo& servo = servos_.at(id);
  const auto kept = static_cast<std::size_t>(torque_register());
  std::fill(servo.registers.begin() + static_cast<std::ptrdiff_t>(kept), servo.registers.end(),
            std::uint8_t{0});
}

bool ServoEmulator::tripped(int id) const { return get(id, kBusWatchdog, 1) == kTripped; }

void ServoEmulator::move(int id, Servo& servo, double now) {
  const double passed = now - last_;
  const double step = speed * passed;
  const bool dynamixel = kind_ == Kind::Dynamixel;
  const double before = servo.position;
  std::uint8_t& watchdog = servo.registers[kBusWatchdog];
  const bool on = servo.registers[static_cast<std::size_t>(torque_register())] == 1;
  if (dynamixel && on && watchdog > 0 && watchdog != kTripped && now - heard_ > 0.02 * watchdog)
    watchdog = kTripped;
  if (on && blocked != id && !(dynamixel && watchdog == kTripped)) {
    const double goal =
        static_cast<std::int32_t>(value(servo, dynamixel ? 116 : 42, dynamixel ? 4 : 2));
    servo.position += std::clamp(goal - servo.position, -step, step);
  }
  if (passed > 0) servo.velocity = (servo.position - before) / passed;
  if (servo.position == before) return;
  if (first_motion_ < 0) first_motion_ = now;
  last_motion_ = now;
}

void ServoEmulator::pass(double now) {
  for (auto& [id, servo] : servos_) move(id, servo, now);
  last_ = now;
}

void ServoEmulator::refresh(Servo& servo) const {
  if (frozen) return;
  const auto place = static_cast<std::uint32_t>(std::lround(servo.position) + jumped);
  const bool dynamixel = kind_ == Kind::Dynamixel;
  write(servo, dynamixel ? 132 : 56, dynamixel ? 4 : 2, place);
  // 0.229 rev/min a unit; Feetech: ticks/s, the sign in bit 15
  if (dynamixel)
    return write(servo, 128, 4,
                 static_cast<std::uint32_t>(std::lround(servo.velocity / (0.229 / 60 * 4096))));
  const auto amount = static_cast<std::uint32_t>(std::lround(std::abs(servo.velocity)));
  write(servo, 58, 2, std::min(amount, 0x7FFFU) | (servo.velocity < 0 ? 0x8000U : 0U));
}

void ServoEmulator::status(int id, std::uint8_t error, const Octets& p) {
  if (mute == id) return;
  if (kind_ != Kind::Dynamixel) {
    Octets out{0xFF, 0xFF, static_cast<std::uint8_t>(id), static_cast<std::uint8_t>(p.size() + 2),
               error};
    out.insert(out.end(), p.begin(), p.end());
    unsigned sum = 0;
    for (std::size_t i = 2; i < out.size(); ++i) sum += out[i];
    out.push_back(static_cast<std::uint8_t>(255 - sum % 256));
    return answer(out);
  }
  Octets body{0x55, error};
  for (const std::uint8_t byte : p) {
    body.push_back(byte);
    const std::size_t n = body.size();
    if (n >= 3 && body[n - 3] == 0xFF && body[n - 2] == 0xFF && byte == 0xFD) body.push_back(0xFD);
  }
  Octets out{0xFF, 0xFF, 0xFD, 0x00, static_cast<std::uint8_t>(id)};
  out.push_back(static_cast<std::uint8_t>((body.size() + 2) % 256));
  out.push_back(static_cast<std::uint8_t>((body.size() + 2) / 256));
  out.insert(out.end(), body.begin(), body.end());
  const std::uint16_t crc = crc_of(out);
  out.push_back(static_cast<std::uint8_t>(crc % 256));
  out.push_back(static_cast<std::uint8_t>(crc / 256));
  answer(out);
}

void ServoEmulator::take(std::uint8_t byte) {
  in_.push_back(byte);
  while (!in_.empty() && (kind_ == Kind::Dynamixel ? take_dynamixel() : take_feetech())) {
  }
}

/// Whether it has got any further.
bool ServoEmulator::take_dynamixel() {
  const Octets header{0xFF, 0xFF, 0xFD, 0x00};
  for (std::size_t i = 0; i < std::min(in_.size(), header.size()); ++i)
    if (in_[i] != header[i]) return in_.erase(in_.begin()), true;
  if (in_.size() < 7) return false;
  const std::size_t whole = 7 + little(in_, 5, 2);
  if (in_.size() < whole) return false;
  const Octets packet(in_.begin(), in_.begin() + static_cast<std::ptrdiff_t>(whole));
  in_.erase(in_.begin(), in_.begin() + static_cast<std::ptrdiff_t>(whole));
  if (crc_of(Octets(packet.begin(), packet.end() - 2)) != little(packet, whole - 2, 2)) return true;
  Octets p;
  for (std::size_t i = 8; i + 2 < whole; ++i) {
    p.push_back(packet[i]);
    const bool stuffed = packet[i] == 0xFD && packet[i - 1] == 0xFF && packet[i - 2] == 0xFF;
    if (stuffed) ++i;
  }
  carry_out(packet[4], packet[7], p);
  return true;
}

bool ServoEmulator::take_feetech() {
  if (in_[0] != 0xFF || (in_.size() > 1 && in_[1] != 0xFF)) return in_.erase(in_.begin()), true;
  if (in_.size() < 4 || in_.size() < 4U + in_[3]) return false;
  const std::size_t whole = 4U + in_[3];
  const Octets packet(in_.begin(), in_.begin() + static_cast<std::ptrdiff_t>(whole));
  in_.erase(in_.begin(), in_.begin() + static_cast<std::ptrdiff_t>(whole));
  unsigned sum = 0;
  for (std::size_t i = 2; i < whole; ++i) sum += packet[i];
  if (sum % 256 != 255) return true;
  carry_out(packet[2], packet[4], Octets(packet.begin() + 5, packet.end() - 1));
  return true;
}

/// ROBOTIS: settings while the torque is on; goals after the bus watchdog has tripped.
bool ServoEmulator::refuses(const Servo& servo, int address) const {
  if (kind_ != Kind::Dynamixel) return false;
  const bool on = servo.registers[static_cast<std::size_t>(torque_register())] == 1;
  const bool goal = address >= 100 && address <= 116;
  return (on && address < torque_register()) || (goal && servo.registers[kBusWatchdog] == kTripped);
}

void ServoEmulator::carry_out(int id, int instruction, const Octets& p) {
  heard_ = now();
  if (instruction == 0x82 || instruction == 0x83) return sync(instruction, p);
  const auto found = servos_.find(id);
  if (found == servos_.end()) return;
  Servo& servo = found->second;
  const bool dynamixel = kind_ == Kind::Dynamixel;
  if (instruction == 0x01) return status(id, 0, dynamixel ? Octets{0x06, 0x04, 0x26} : Octets{});
  const int address = static_cast<int>(little(p, 0, width()));
  if (instruction == 0x02) {
    refresh(servo);
    const auto size = little(p, static_cast<std::size_t>(width()), width());
    const auto* first = servo.registers.data() + address;
    return status(id, 0, Octets(first, first + size));
  }
  if (instruction != 0x03) return status(id, dynamixel ? 2 : 0, {});
  if (refuses(servo, address)) return status(id, 7, {});
  std::copy(p.begin() + width(), p.end(), servo.registers.begin() + address);
  status(id, 0, {});
}

void ServoEmulator::sync(int instruction, const Octets& p) {
  const int address = static_cast<int>(little(p, 0, width()));
  const auto size =
      static_cast<std::ptrdiff_t>(little(p, static_cast<std::size_t>(width()), width()));
  auto at = p.begin() + 2 * width();
  if (instruction == 0x83) {
    for (; p.end() - at > size; at += 1 + size)
      if (const auto found = servos_.find(*at);
          found != servos_.end() && !refuses(found->second, address))
        std::copy(at + 1, at + 1 + size, found->second.registers.begin() + address);
    return;
  }
  if (kind_ == Kind::FeetechScs) return;
  for (; at != p.end(); ++at) {
    const auto found = servos_.find(*at);
    if (found == servos_.end()) continue;
    if (mute == *at) return;  // those behind it wait for its answer
    refresh(found->second);
    const auto* first = found->second.registers.data() + address;
    status(*at, 0, Octets(first, first + size));
  }
}

}  // namespace rob::test
