#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "drivers/link/servo_dialect.h"
#include "drivers/protocol/dynamixel_packet.h"

namespace rob::drivers {

/// The registers of ROBOTIS' X series, protocol 2.0 (e-manual, XL430-W250).
struct DynamixelDialect {
  using Format = dynamixel::Format;
  using Frame = dynamixel::Packet;
  using Wire = dynamixel::Wire;
  static constexpr const char* kName = "DYNAMIXEL";
  static constexpr int kModeAddress = 11;
  static constexpr std::uint32_t kMode = 3;  ///< position, one turn
  static constexpr const char* kModeHelp = "operating mode 3 (position control), register 11";
  static constexpr int kWatchdogAddress = 98;
  static constexpr std::uint32_t kTripped = 255;  ///< what it holds after it has stopped the servo
  static constexpr bool kHasSyncRead = true;
  static constexpr int kReadingBytes = 19;   ///< of a status with velocity and position, turn 0
  static constexpr int kGoalBytes = 5;       ///< of one goal in a sync write
  static constexpr int kQuestionBytes = 14;  ///< of a question to one servo
  static constexpr int kFrameBytes = 14;     ///< of a sync write or sync read without its servos
  static constexpr int kHealthBytes = 18;    ///< of a status with torque to hardware error

  /// Bytes from register 128 on: velocity, position; after these the trajectory's (136 to 143).
  static constexpr int reading_size(int turn) { return 8 + turn; }
  static Wire ping(std::uint8_t id) { return dynamixel::ping(id); }
  static Wire read(std::uint8_t id, int address, int size);
  static Wire write(std::uint8_t id, const ServoSetting& setting);
  static Wire ask_readings(std::span<const std::uint8_t> ids, int turn);
  static Wire ask_reading(std::uint8_t id, int turn);
  static Wire goals(std::span<const ServoGoal> goals);
  static ServoSetting torque_setting(bool on);
  static Wire torque(std::span<const std::uint8_t> ids, bool on);
  static Wire ask_health(std::uint8_t id);
  /// False if it is no answer to a question of this turn.
  static bool parse_reading(const Frame& frame, int turn, ServoReading& reading);
  static bool parse_health(const Frame& frame, ServoHealth& health);
  /// "" for none: what the status itself complains of.
  static std::string complaint(const Frame& frame);
  static std::uint8_t id_of(const Frame& frame) { return frame.id; }
  static bool is_status(const Frame& frame) {
    return frame.instruction == dynamixel::Instruction::Status;
  }
  /// Little-endian parameters of a status.
  static std::uint32_t value_of(const Frame& frame);
  /// Lowest and highest position, ticks.
  static constexpr int kLeastAddress = 52;
  static constexpr int kMostAddress = 48;
  static constexpr int kLimitSize = 4;
  /// To be so before torque is switched on.
  static std::vector<ServoSetting> settings();
  /// To be written to every servo when it is enabled, without waiting for an answer.
  static std::vector<ServoSetting> watchdog(bool on);
  static Wire write_all(std::span<const std::uint8_t> ids, const ServoSetting& setting);
};

}  // namespace rob::drivers
