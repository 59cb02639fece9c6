#pragma once

#include <cstdint>

#include "drivers/protocol/byte_buffer.h"
#include "drivers/protocol/frame_reader.h"

/// DYNAMIXEL protocol 2.0 (ROBOTIS e-manual):
///
///     FF FF FD 00 | ID | LENGTH low high | INSTRUCTION | parameters | CRC low high
///
/// LENGTH = parameters + 3, counted with stuffing; the CRC is over all before it.
namespace rob::drivers::dynamixel {

enum class Instruction : std::uint8_t {
  Ping = 0x01,
  Read = 0x02,
  Write = 0x03,
  Reboot = 0x08,
  Status = 0x55,
  SyncRead = 0x82,
  SyncWrite = 0x83
};

inline constexpr std::uint8_t kEveryone = 0xFE;
inline constexpr std::size_t kMostPacket = 160;  ///< sync write of 8 servos: 10 + 5 + 8·5, stuffed

/// CRC-16, polynomial 0x8005, initial value 0, not reflected.
std::uint16_t crc16(Bytes bytes) noexcept;

/// A packet without its stuffing.
struct Packet {
  std::uint8_t id = 0;
  Instruction instruction = Instruction::Ping;
  std::uint8_t error = 0;  ///< of a status: bit 7 hardware alert, bits 0…6 a number
  ByteBuffer<kMostPacket> parameters;
};

/// As it goes over the wire, stuffed, with CRC.
using Wire = ByteBuffer<kMostPacket>;
Wire encode(std::uint8_t id, Instruction instruction, Bytes parameters) noexcept;
/// The answer of a servo.
Wire encode_status(std::uint8_t id, std::uint8_t error, Bytes parameters) noexcept;

Wire ping(std::uint8_t id) noexcept;
Wire read(std::uint8_t id, std::uint16_t address, std::uint16_t length) noexcept;
/// `length` bytes of `value`, little-endian.
Wire write(std::uint8_t id, std::uint16_t address, std::uint32_t value, int length) noexcept;
Wire sync_read(std::uint16_t address, std::uint16_t length, Bytes ids) noexcept;

/// For FrameReader.
struct Format {
  using Frame = Packet;
  static constexpr std::size_t kMost = kMostPacket;
  static Scan scan(Bytes bytes, Packet& packet) noexcept;
};

/// The meaning of a status number; "" for none.
const char* error_text(std::uint8_t error) noexcept;

}  // namespace rob::drivers::dynamixel
