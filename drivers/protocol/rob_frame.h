#pragma once

#include <array>
#include <cstdint>

#include "drivers/protocol/byte_buffer.h"
#include "drivers/protocol/frame_reader.h"

/// Rob's own protocol, for anyone with a microcontroller (docs/serial-protocol.md):
///
///     A5 5A | TYPE | SEQ | LENGTH | payload | CRC low high
///
/// LENGTH <= 128 counts the payload; the CRC is over TYPE … payload. Both sides use this file: it
/// takes no memory and knows no system.
namespace rob::drivers::wire {

enum class Type : std::uint8_t {
  Hello = 0x01,
  Info = 0x02,
  Reference = 0x10,
  State = 0x20,
  Enable = 0x30,
  Stop = 0x31,
  Error = 0x40
};

inline constexpr std::uint8_t kVersion = 1;
inline constexpr int kMostAxes = 8;
inline constexpr std::size_t kMostPayload = 128;
inline constexpr std::size_t kMostFrame = kMostPayload + 7;

/// CRC-16/CCITT-FALSE: polynomial 0x1021, initial value FFFF, not reflected.
std::uint16_t crc16(Bytes bytes) noexcept;

struct Frame {
  Type type = Type::Hello;
  std::uint8_t sequence = 0;
  ByteBuffer<kMostPayload> payload;
};

using Wire = ByteBuffer<kMostFrame>;
Wire encode(Type type, std::uint8_t sequence, Bytes payload) noexcept;

/// For FrameReader.
struct Format {
  using Frame = wire::Frame;
  static constexpr std::size_t kMost = kMostFrame;
  static Scan scan(Bytes bytes, Frame& frame) noexcept;
};

/// 1e-6 mm or deg, and the same per second.
using Axes = std::array<std::int32_t, 8>;

struct Info {
  std::uint8_t version = kVersion;
  std::uint8_t axes = 0;
  std::uint16_t highest_rate = 0;  ///< references per second
  std::uint16_t queue = 0;         ///< references that it can keep
  std::uint16_t firmware = 0;      ///< its maker's own number
};
struct Reference {
  std::uint32_t apply = 0;   ///< µs of the device's clock
  std::uint16_t period = 0;  ///< µs to the next reference
  Axes position{};
  Axes velocity{};
};
struct State {
  static constexpr std::uint16_t kEnabled = 1;
  static constexpr std::uint16_t kMoving = 2;
  static constexpr std::uint16_t kStarved = 4;  ///< its watchdog has stopped it
  static constexpr std::uint16_t kFault = 8;
  static constexpr std::uint16_t kLate = 16;  ///< a reference came late since the last STATE

  std::uint32_t time = 0;  ///< µs of the device's clock
  std::uint16_t flags = 0;
  std::uint16_t queue = 0;  ///< references whose instant has not come
  Axes position{};
  Axes velocity{};
  std::uint16_t last = 0;    ///< SEQ of the frame that this answers
  std::uint16_t broken = 0;  ///< frames with a wrong CRC since it was switched on
};

ByteBuffer<kMostPayload> payload_of(const Info& info) noexcept;
ByteBuffer<kMostPayload> payload_of(const Reference& reference, int axes) noexcept;
ByteBuffer<kMostPayload> payload_of(const State& state, int axes) noexcept;
/// False: of another length than `axes` ask for.
bool parse(Bytes payload, Info& info) noexcept;
bool parse(Bytes payload, int axes, Reference& reference) noexcept;
bool parse(Bytes payload, int axes, State& state) noexcept;

/// a − b of instants that wrap after 71.6 min, µs.
constexpr std::int32_t between(std::uint32_t a, std::uint32_t b) noexcept {
  return static_cast<std::int32_t>(a - b);
}

}  // namespace rob::drivers::wire
