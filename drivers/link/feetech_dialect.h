#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "drivers/link/servo_dialect.h"
#include "drivers/protocol/feetech_packet.h"

namespace rob::drivers {

/// The registers of Feetech's STS series (memory table of the STS3215).
struct FeetechDialect {
  using Format = feetech::Format;
  using Frame = feetech::Packet;
  using Wire = feetech::Wire;
  static constexpr const char* kName = "Feetech";
  static constexpr int kModeAddress = 33;
  static constexpr std::uint32_t kMode = 0;
  static constexpr const char* kModeHelp = "mode 0 (position), register 33";
  static constexpr int kWatchdogAddress = 0;  ///< none
  static constexpr std::uint32_t kTripped = 0;
  static constexpr bool kHasSyncRead = true;
  static constexpr int kReadingBytes = 14;
  static constexpr int kGoalBytes = 7;
  static constexpr int kQuestionBytes = 8;
  static constexpr int kFrameBytes = 8;
  static constexpr int kHealthBytes = 7;

  /// Bytes from register 56 on: position, speed (4 bytes); the table of both series goes to 66.
  static constexpr int reading_size(int turn) { return 4 + (turn + 4) % kTurns; }
  static Wire ping(std::uint8_t id) { return feetech::ping(id); }
  static Wire read(std::uint8_t id, int address, int size);
  static Wire write(std::uint8_t id, const ServoSetting& setting);
  static Wire ask_readings(std::span<const std::uint8_t> ids, int turn);
  static Wire ask_reading(std::uint8_t id, int turn);
  static Wire goals(std::span<const ServoGoal> goals);
  static ServoSetting torque_setting(bool on);
  static Wire torque(std::span<const std::uint8_t> ids, bool on);
  static Wire ask_health(std::uint8_t id);
  static bool parse_reading(const Frame& frame, int turn, ServoReading& reading);
  static bool parse_health(const Frame& frame, ServoHealth& health);
  static std::string complaint(const Frame& frame);
  static std::uint8_t id_of(const Frame& frame) { return frame.id; }
  static bool is_status(const Frame&) { return true; }
  static std::uint32_t value_of(const Frame& frame);
  static constexpr int kLeastAddress = 9;
  static constexpr int kMostAddress = 11;
  static constexpr int kLimitSize = 2;
  static std::vector<ServoSetting> settings();
  static std::vector<ServoSetting> watchdog(bool on);
  static Wire write_all(std::span<const std::uint8_t> ids, const ServoSetting& setting);
};

/// The registers of Feetech's SCS series (memory table of the SCSCL): numbers are big-endian, 1024
/// to the way of the servo. There is no sync read, no ramp, and no mode: a servo without limits is
/// a wheel. Settings and torque are single bytes, as in the STS series.
struct FeetechScsDialect : FeetechDialect {
  static constexpr int kModeAddress = 0;
  static constexpr const char* kModeHelp = "position limits, registers 9 and 11";
  static constexpr bool kHasSyncRead = false;

  static Wire goals(std::span<const ServoGoal> goals);
  static bool parse_reading(const Frame& frame, int turn, ServoReading& reading);
  static std::uint32_t value_of(const Frame& frame);
  static std::vector<ServoSetting> settings() { return {}; }
};

}  // namespace rob::drivers
