#include "drivers/link/dynamixel_dialect.h"

namespace rob::drivers {

using dynamixel::Instruction;

namespace {

// X series, control table.
constexpr std::uint16_t kReturnDelay = 9;
constexpr std::uint16_t kTorque = 64;
constexpr std::uint16_t kStatusReturn = 68;
constexpr std::uint16_t kHardwareError = 70;
constexpr std::uint16_t kBusWatchdog = 98;
constexpr std::uint16_t kProfileAcceleration = 108;
constexpr std::uint16_t kProfileVelocity = 112;
constexpr std::uint16_t kGoalPosition = 116;
constexpr std::uint16_t kVelocity = 128;  // and the position after it
constexpr std::uint16_t kHealthSize = kHardwareError - kTorque + 1;

// 0.229 rev/min a unit, 4096 ticks a turn.
constexpr double kTicksPerVelocity = 0.229 / 60 * 4096;
constexpr std::uint32_t kWatchdogTime = 5;  // · 20 ms (fault 37)

std::string hardware_text(std::uint32_t bits) {
  constexpr std::pair<unsigned, const char*> kBits[] = {{0, "wrong supply voltage"},
                                                        {2, "too hot"},
                                                        {3, "its encoder has failed"},
                                                        {4, "electrical shock"},
                                                        {5, "overload"}};
  std::string text;
  for (const auto& [bit, what] : kBits)
    if ((bits & 1U << bit) != 0) text += (text.empty() ? "" : ", ") + std::string(what);
  return text;
}

}  // namespace

dynamixel::Wire DynamixelDialect::read(std::uint8_t id, int address, int size) {
  return dynamixel::read(id, static_cast<std::uint16_t>(address), static_cast<std::uint16_t>(size));
}

dynamixel::Wire DynamixelDialect::write(std::uint8_t id, const ServoSetting& setting) {
  return dynamixel::write(id, static_cast<std::uint16_t>(setting.address), setting.value,
                          setting.size);
}

dynamixel::Wire DynamixelDialect::ask_readings(std::span<const std::uint8_t> ids, int turn) {
  return dynamixel::sync_read(kVelocity, static_cast<std::uint16_t>(reading_size(turn)), ids);
}

dynamixel::Wire DynamixelDialect::ask_reading(std::uint8_t id, int turn) {
  return read(id, kVelocity, reading_size(turn));
}

dynamixel::Wire DynamixelDialect::goals(std::span<const ServoGoal> goals) {
  Wire parameters;
  parameters.push16(kGoalPosition);
  parameters.push16(4);
  for (const ServoGoal& goal : goals) {
    parameters.push(goal.id);
    parameters.push32(static_cast<std::uint32_t>(goal.position));
  }
  return dynamixel::encode(dynamixel::kEveryone, Instruction::SyncWrite, parameters.view());
}

dynamixel::Wire DynamixelDialect::write_all(std::span<const std::uint8_t> ids,
                                            const ServoSetting& setting) {
  Wire parameters;
  parameters.push16(static_cast<std::uint32_t>(setting.address));
  parameters.push16(static_cast<std::uint32_t>(setting.size));
  for (const std::uint8_t id : ids) {
    parameters.push(id);
    for (int i = 0; i < setting.size; ++i)
      parameters.push(static_cast<std::uint8_t>(setting.value >> 8U * i));
  }
  return dynamixel::encode(dynamixel::kEveryone, Instruction::SyncWrite, parameters.view());
}

ServoSetting DynamixelDialect::torque_setting(bool on) { return {kTorque, 1, on ? 1U : 0U}; }

dynamixel::Wire DynamixelDialect::torque(std::span<const std::uint8_t> ids, bool on) {
  return write_all(ids, torque_setting(on));
}

dynamixel::Wire DynamixelDialect::ask_health(std::uint8_t id) {
  return dynamixel::read(id, kTorque, kHealthSize);
}

bool DynamixelDialect::parse_reading(const Frame& frame, int turn, ServoReading& reading) {
  const Bytes bytes = frame.parameters.view();
  if (static_cast<int>(bytes.size()) != reading_size(turn)) return false;
  reading.velocity = static_cast<std::int32_t>(little32(bytes, 0)) * kTicksPerVelocity;
  reading.position = static_cast<std::int32_t>(little32(bytes, 4));
  return true;
}

bool DynamixelDialect::parse_health(const Frame& frame, ServoHealth& health) {
  const Bytes bytes = frame.parameters.view();
  if (bytes.size() != kHealthSize) return false;
  health.torque = bytes[0] == 1;
  health.trouble = hardware_text(bytes[kHardwareError - kTorque]);
  return true;
}

std::string DynamixelDialect::complaint(const Frame& frame) {
  if ((frame.error & 0x80U) != 0) return "it reports a hardware alert";
  return dynamixel::error_text(frame.error);
}

std::uint32_t DynamixelDialect::value_of(const Frame& frame) {
  std::uint32_t value = 0;
  const Bytes bytes = frame.parameters.view();
  for (std::size_t i = std::min<std::size_t>(bytes.size(), 4); i-- > 0;)
    value = value << 8U | bytes[i];
  return value;
}

std::vector<ServoSetting> DynamixelDialect::settings() {
  // Answers at once, to every instruction; no profile of its own between the references.
  return {{kBusWatchdog, 1, 0},
          {kReturnDelay, 1, 0},
          {kStatusReturn, 1, 2},
          {kProfileAcceleration, 4, 0},
          {kProfileVelocity, 4, 0}};
}

std::vector<ServoSetting> DynamixelDialect::watchdog(bool on) {
  return {{kBusWatchdog, 1, on ? kWatchdogTime : 0}};
}

}  // namespace rob::drivers
