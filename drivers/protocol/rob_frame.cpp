#include "drivers/protocol/rob_frame.h"

namespace rob::drivers::wire {

namespace {

constexpr std::uint8_t kFirst = 0xA5;
constexpr std::uint8_t kSecond = 0x5A;
constexpr std::size_t kAhead = 5;  // A5 5A, type, sequence, length

void push_axes(ByteBuffer<kMostPayload>& payload, const Axes& values, int axes) noexcept {
  for (int i = 0; i < axes; ++i)
    payload.push32(static_cast<std::uint32_t>(values[static_cast<std::size_t>(i)]));
}

void read_axes(Bytes payload, std::size_t at, int axes, Axes& values) noexcept {
  for (int i = 0; i < axes; ++i)
    values[static_cast<std::size_t>(i)] =
        static_cast<std::int32_t>(little32(payload, at + 4 * static_cast<std::size_t>(i)));
}

std::size_t size_of_axes(int axes) noexcept { return 4 * static_cast<std::size_t>(axes); }

}  // namespace

std::uint16_t crc16(Bytes bytes) noexcept {
  unsigned crc = 0xFFFF;
  for (const std::uint8_t byte : bytes) {
    crc ^= static_cast<unsigned>(byte) << 8U;
    for (int bit = 0; bit < 8; ++bit) crc = (crc & 0x8000U) != 0 ? crc << 1U ^ 0x1021U : crc << 1U;
    crc &= 0xFFFFU;
  }
  return static_cast<std::uint16_t>(crc);
}

Wire encode(Type type, std::uint8_t sequence, Bytes payload) noexcept {
  Wire wire;
  wire.push(kFirst);
  wire.push(kSecond);
  wire.push(static_cast<std::uint8_t>(type));
  wire.push(sequence);
  wire.push(static_cast<std::uint8_t>(payload.size()));
  wire.push(payload);
  wire.push16(crc16(wire.view().subspan(2)));
  return wire;
}

Scan Format::scan(Bytes bytes, Frame& frame) noexcept {
  if (bytes[0] != kFirst || (bytes.size() > 1 && bytes[1] != kSecond)) return {Scan::Kind::Skip, 1};
  if (bytes.size() < kAhead) return {Scan::Kind::NeedMore, 0};
  const std::size_t length = bytes[4];
  if (length > kMostPayload) return {Scan::Kind::Broken, 1};
  const std::size_t whole = kAhead + length + 2;
  if (bytes.size() < whole) return {Scan::Kind::NeedMore, 0};
  if (crc16(bytes.subspan(2, whole - 4)) != little16(bytes, whole - 2))
    return {Scan::Kind::Broken, 1};
  frame = {static_cast<Type>(bytes[2]), bytes[3], {}};
  frame.payload.push(bytes.subspan(kAhead, length));
  return {Scan::Kind::Frame, whole};
}

ByteBuffer<kMostPayload> payload_of(const Info& info) noexcept {
  ByteBuffer<kMostPayload> payload;
  payload.push(info.version);
  payload.push(info.axes);
  payload.push16(info.highest_rate);
  payload.push16(info.queue);
  payload.push16(info.firmware);
  return payload;
}

ByteBuffer<kMostPayload> payload_of(const Reference& reference, int axes) noexcept {
  ByteBuffer<kMostPayload> payload;
  payload.push32(reference.apply);
  payload.push16(reference.period);
  push_axes(payload, reference.position, axes);
  push_axes(payload, reference.velocity, axes);
  return payload;
}

ByteBuffer<kMostPayload> payload_of(const State& state, int axes) noexcept {
  ByteBuffer<kMostPayload> payload;
  payload.push32(state.time);
  payload.push16(state.flags);
  payload.push16(state.queue);
  push_axes(payload, state.position, axes);
  push_axes(payload, state.velocity, axes);
  payload.push16(state.last);
  payload.push16(state.broken);
  return payload;
}

bool parse(Bytes payload, Info& info) noexcept {
  if (payload.size() != 8) return false;
  info = {payload[0], payload[1], little16(payload, 2), little16(payload, 4), little16(payload, 6)};
  return true;
}

bool parse(Bytes payload, int axes, Reference& reference) noexcept {
  if (payload.size() != 6 + 2 * size_of_axes(axes)) return false;
  reference.apply = little32(payload, 0);
  reference.period = little16(payload, 4);
  read_axes(payload, 6, axes, reference.position);
  read_axes(payload, 6 + size_of_axes(axes), axes, reference.velocity);
  return true;
}

bool parse(Bytes payload, int axes, State& state) noexcept {
  const std::size_t tail = 8 + 2 * size_of_axes(axes);
  if (payload.size() != tail + 4) return false;
  state.time = little32(payload, 0);
  state.flags = little16(payload, 4);
  state.queue = little16(payload, 6);
  read_axes(payload, 8, axes, state.position);
  read_axes(payload, 8 + size_of_axes(axes), axes, state.velocity);
  state.last = little16(payload, tail);
  state.broken = little16(payload, tail + 2);
  return true;
}

}  // namespace rob::drivers::wire
