#include "drivers/link/feetech_dialect.h"

#include <algorithm>

namespace rob::drivers {

using feetech::Instruction;

namespace {

// STS3215, memory table.
constexpr std::uint8_t kReturnDelay = 7;
constexpr std::uint8_t kTorque = 40;
constexpr std::uint8_t kAcceleration = 41;
constexpr std::uint8_t kGoalPosition = 42;  // position, time, speed
constexpr std::uint8_t kPosition = 56;      // position, speed, load, voltage, temperature
constexpr int kMostSpeed = 4095;  // ticks/s: a turn a second, what an STS3215 does without load
constexpr int kMostScsPosition = 1023;
constexpr int kMostScsSpeed = 2047;  // ticks/s [choice] its way twice a second: none is faster

feetech::Wire sync_write(std::uint8_t address, std::uint8_t size, Bytes rest) {
  feetech::Wire parameters;
  parameters.push(address);
  parameters.push(size);
  parameters.push(rest);
  return feetech::encode(feetech::kEveryone, static_cast<std::uint8_t>(Instruction::SyncWrite),
                         parameters.view());
}

}  // namespace

feetech::Wire FeetechDialect::read(std::uint8_t id, int address, int size) {
  return feetech::read(id, static_cast<std::uint8_t>(address), static_cast<std::uint8_t>(size));
}

feetech::Wire FeetechDialect::write(std::uint8_t id, const ServoSetting& setting) {
  feetech::Wire values;
  for (int i = 0; i < setting.size; ++i)
    values.push(static_cast<std::uint8_t>(setting.value >> 8U * i));
  return feetech::write(id, static_cast<std::uint8_t>(setting.address), values.view());
}

feetech::Wire FeetechDialect::ask_readings(std::span<const std::uint8_t> ids, int turn) {
  return feetech::sync_read(kPosition, static_cast<std::uint8_t>(reading_size(turn)), ids);
}

feetech::Wire FeetechDialect::ask_reading(std::uint8_t id, int turn) {
  return read(id, kPosition, reading_size(turn));
}

feetech::Wire FeetechDialect::goals(std::span<const ServoGoal> goals) {
  feetech::Wire rest;
  for (const ServoGoal& goal : goals) {
    rest.push(goal.id);
    rest.push16(feetech::sign_magnitude(goal.position));
    rest.push16(0);  // time: the speed counts
    rest.push16(static_cast<std::uint32_t>(std::clamp(goal.most_speed, 1, kMostSpeed)));
  }
  return sync_write(kGoalPosition, 6, rest.view());
}

feetech::Wire FeetechDialect::write_all(std::span<const std::uint8_t> ids,
                                        const ServoSetting& setting) {
  feetech::Wire rest;
  for (const std::uint8_t id : ids) {
    rest.push(id);
    for (int i = 0; i < setting.size; ++i)
      rest.push(static_cast<std::uint8_t>(setting.value >> 8U * i));
  }
  return sync_write(static_cast<std::uint8_t>(setting.address),
                    static_cast<std::uint8_t>(setting.size), rest.view());
}

ServoSetting FeetechDialect::torque_setting(bool on) { return {kTorque, 1, on ? 1U : 0U}; }

feetech::Wire FeetechDialect::torque(std::span<const std::uint8_t> ids, bool on) {
  return write_all(ids, torque_setting(on));
}

feetech::Wire FeetechDialect::ask_health(std::uint8_t id) { return feetech::read(id, kTorque, 1); }

bool FeetechDialect::parse_reading(const Frame& frame, int turn, ServoReading& reading) {
  const Bytes bytes = frame.parameters.view();
  if (static_cast<int>(bytes.size()) != reading_size(turn)) return false;
  reading.position = feetech::from_sign_magnitude(little16(bytes, 0));
  reading.velocity = feetech::from_sign_magnitude(little16(bytes, 2));
  return true;
}

bool FeetechDialect::parse_health(const Frame& frame, ServoHealth& health) {
  if (frame.parameters.size() != 1) return false;
  health.torque = frame.parameters[0] == 1;
  health.trouble = feetech::error_text(frame.code);
  return true;
}

std::string FeetechDialect::complaint(const Frame& frame) {
  return feetech::error_text(frame.code);
}

std::uint32_t FeetechDialect::value_of(const Frame& frame) {
  const Bytes bytes = frame.parameters.view();
  std::uint32_t value = 0;
  for (std::size_t i = std::min<std::size_t>(bytes.size(), 4); i-- > 0;)
    value = value << 8U | bytes[i];
  return value;
}

feetech::Wire FeetechScsDialect::goals(std::span<const ServoGoal> goals) {
  feetech::Wire rest;
  const auto push_big = [&](int value) {
    rest.push(static_cast<std::uint8_t>(value >> 8));
    rest.push(static_cast<std::uint8_t>(value));
  };
  for (const ServoGoal& goal : goals) {
    rest.push(goal.id);
    push_big(std::clamp(goal.position, 0, kMostScsPosition));
    push_big(0);  // time: the speed counts
    push_big(std::clamp(goal.most_speed, 1, kMostScsSpeed));
  }
  return sync_write(kGoalPosition, 6, rest.view());
}

bool FeetechScsDialect::parse_reading(const Frame& frame, int turn, ServoReading& reading) {
  const Bytes bytes = frame.parameters.view();
  if (static_cast<int>(bytes.size()) != reading_size(turn)) return false;
  reading.position = bytes[0] << 8 | bytes[1];
  reading.velocity =
      feetech::from_sign_magnitude(static_cast<std::uint16_t>(bytes[2] << 8 | bytes[3]));
  return true;
}

std::uint32_t FeetechScsDialect::value_of(const Frame& frame) {
  std::uint32_t value = 0;
  for (const std::uint8_t byte : frame.parameters.view()) value = value << 8U | byte;
  return value;
}

std::vector<ServoSetting> FeetechDialect::settings() {
  // Answers at once; no ramp of its own between the references.
  return {{kReturnDelay, 1, 0}, {kAcceleration, 1, 0}};
}

std::vector<ServoSetting> FeetechDialect::watchdog(bool) { return {}; }

}  // namespace rob::drivers
