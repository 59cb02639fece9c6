#pragma once

#include <cstdint>
#include <string>

#include "drivers/protocol/byte_buffer.h"
#include "drivers/protocol/frame_reader.h"

/// The protocol of Feetech's STS and SMS servos (little-endian; SCS servos are big-endian):
///
///     FF FF | ID | LENGTH | INSTRUCTION or ERROR | parameters | ~(ID + … + parameters)
///
/// LENGTH = parameters + 2. One byte of check lets 1 of 256 corruptions pass.
namespace rob::drivers::feetech {

enum class Instruction : std::uint8_t {
  Ping = 0x01,
  Read = 0x02,
  Write = 0x03,
  SyncRead = 0x82,
  SyncWrite = 0x83
};

inline constexpr std::uint8_t kEveryone = 0xFE;
inline constexpr std::size_t kMostPacket = 96;  ///< sync write of 8 servos: 8 + 8·8 bytes

struct Packet {
  std::uint8_t id = 0;
  std::uint8_t code = 0;  ///< the instruction, or the error bits of a status
  ByteBuffer<kMostPacket> parameters;
};

using Wire = ByteBuffer<kMostPacket>;
Wire encode(std::uint8_t id, std::uint8_t code, Bytes parameters) noexcept;

Wire ping(std::uint8_t id) noexcept;
Wire read(std::uint8_t id, std::uint8_t address, std::uint8_t length) noexcept;
Wire write(std::uint8_t id, std::uint8_t address, Bytes values) noexcept;
Wire sync_read(std::uint8_t address, std::uint8_t length, Bytes ids) noexcept;

/// For FrameReader.
struct Format {
  using Frame = Packet;
  static constexpr std::size_t kMost = kMostPacket;
  static Scan scan(Bytes bytes, Packet& packet) noexcept;
};

/// Registers carry a sign in bit `sign`, the rest is the amount.
std::uint16_t sign_magnitude(int value, int sign = 15) noexcept;
int from_sign_magnitude(std::uint16_t value, int sign = 15) noexcept;

/// "overload, too hot"; empty for none. Not for the tick.
std::string error_text(std::uint8_t error);

}  // namespace rob::drivers::feetech
