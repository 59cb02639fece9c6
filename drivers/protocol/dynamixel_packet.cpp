#include "drivers/protocol/dynamixel_packet.h"

#include <algorithm>
#include <array>

namespace rob::drivers::dynamixel {

namespace {

constexpr std::array<std::uint8_t, 4> kHeader{0xFF, 0xFF, 0xFD, 0x00};
constexpr std::size_t kAhead = 7;  // header, ID, length
constexpr std::uint8_t kStuffing = 0xFD;

constexpr std::array<std::uint16_t, 256> make_table() {
  std::array<std::uint16_t, 256> table{};
  for (unsigned i = 0; i < 256; ++i) {
    unsigned crc = i << 8U;
    for (int bit = 0; bit < 8; ++bit) crc = (crc & 0x8000U) != 0 ? crc << 1U ^ 0x8005U : crc << 1U;
    table[i] = static_cast<std::uint16_t>(crc);
  }
  return table;
}
constexpr std::array<std::uint16_t, 256> kTable = make_table();

/// FF FF FD must not appear from the instruction on: a second FD follows it.
struct Stuffer {
  Wire& wire;
  int matched = 0;  // of FF FF FD

  void push(std::uint8_t byte) {
    wire.push(byte);
    const bool ends = matched == 2 && byte == 0xFD;
    matched = byte == 0xFF ? std::min(matched + 1, 2) : 0;
    if (ends) wire.push(kStuffing);
  }
};

void close(Wire& wire) noexcept {
  const std::size_t length = wire.size() - kAhead + 2;
  wire.set(5, static_cast<std::uint8_t>(length));
  wire.set(6, static_cast<std::uint8_t>(length >> 8U));
  wire.push16(crc16(wire.view()));
}

Wire open(std::uint8_t id) noexcept {
  Wire wire;
  wire.push(kHeader);
  wire.push(id);
  wire.push16(0);
  return wire;
}

/// From the instruction on, without stuffing; whether there is none left of FF FF FD.
bool unstuff(Bytes body, ByteBuffer<kMostPacket>& plain) noexcept {
  int matched = 0;
  for (std::size_t i = 0; i < body.size(); ++i) {
    plain.push(body[i]);
    const bool ends = matched == 2 && body[i] == 0xFD;
    matched = body[i] == 0xFF ? std::min(matched + 1, 2) : 0;
    if (!ends) continue;
    if (i + 1 == body.size() || body[i + 1] != kStuffing) return false;
    ++i;
  }
  return true;
}

bool fill(Bytes body, std::uint8_t id, Packet& packet) noexcept {
  ByteBuffer<kMostPacket> plain;
  if (!unstuff(body, plain)) return false;
  packet = {id, static_cast<Instruction>(plain[0]), 0, {}};
  std::size_t first = 1;
  if (packet.instruction == Instruction::Status) {
    if (plain.size() < 2) return false;
    packet.error = plain[first++];
  }
  packet.parameters.push(plain.view().subspan(first));
  return true;
}

}  // namespace

std::uint16_t crc16(Bytes bytes) noexcept {
  unsigned crc = 0;
  for (const std::uint8_t byte : bytes)
    crc = (crc << 8U ^ kTable[(crc >> 8U ^ byte) & 0xFFU]) & 0xFFFFU;
  return static_cast<std::uint16_t>(crc);
}

Wire encode(std::uint8_t id, Instruction instruction, Bytes parameters) noexcept {
  Wire wire = open(id);
  Stuffer stuffer{wire};
  stuffer.push(static_cast<std::uint8_t>(instruction));
  for (const std::uint8_t byte : parameters) stuffer.push(byte);
  close(wire);
  return wire;
}

Wire encode_status(std::uint8_t id, std::uint8_t error, Bytes parameters) noexcept {
  Wire body;
  body.push(error);
  body.push(parameters);
  return encode(id, Instruction::Status, body.view());
}

Wire ping(std::uint8_t id) noexcept { return encode(id, Instruction::Ping, {}); }

Wire read(std::uint8_t id, std::uint16_t address, std::uint16_t length) noexcept {
  Wire parameters;
  parameters.push16(address);
  parameters.push16(length);
  return encode(id, Instruction::Read, parameters.view());
}

Wire write(std::uint8_t id, std::uint16_t address, std::uint32_t value, int length) noexcept {
  Wire parameters;
  parameters.push16(address);
  for (int i = 0; i < length; ++i) parameters.push(static_cast<std::uint8_t>(value >> 8U * i));
  return encode(id, Instruction::Write, parameters.view());
}

Wire sync_read(std::uint16_t address, std::uint16_t length, Bytes ids) noexcept {
  Wire parameters;
  parameters.push16(address);
  parameters.push16(length);
  parameters.push(ids);
  return encode(kEveryone, Instruction::SyncRead, parameters.view());
}

Scan Format::scan(Bytes bytes, Packet& packet) noexcept {
  const std::size_t seen = std::min(bytes.size(), kHeader.size());
  if (!std::equal(bytes.begin(), bytes.begin() + static_cast<std::ptrdiff_t>(seen),
                  kHeader.begin()))
    return {Scan::Kind::Skip, 1};
  if (bytes.size() < kAhead) return {Scan::Kind::NeedMore, 0};
  const std::size_t length = little16(bytes, 5);
  const std::size_t whole = kAhead + length;
  if (length < 3 || whole > kMost) return {Scan::Kind::Broken, 1};
  if (bytes.size() < whole) return {Scan::Kind::NeedMore, 0};
  const Bytes covered = bytes.first(whole - 2);
  if (crc16(covered) != little16(bytes, whole - 2)) return {Scan::Kind::Broken, 1};
  if (!fill(covered.subspan(kAhead), bytes[4], packet)) return {Scan::Kind::Broken, 1};
  return {Scan::Kind::Frame, whole};
}

const char* error_text(std::uint8_t error) noexcept {
  static constexpr std::array kTexts{"",
                                     "it could not carry out the instruction",
                                     "it does not know the instruction",
                                     "the instruction came with a wrong CRC",
                                     "a value is out of range",
                                     "a value has the wrong length",
                                     "a value is beyond its limits",
                                     "the register is read-only, or torque has to be off for it"};
  const std::size_t number = error & 0x7FU;
  return number < kTexts.size() ? kTexts[number] : "an error of unknown number";
}

}  // namespace rob::drivers::dynamixel
