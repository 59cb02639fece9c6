#include "drivers/protocol/feetech_packet.h"

#include <cstdlib>
#include <utility>

namespace rob::drivers::feetech {

namespace {

constexpr std::size_t kAhead = 4;  // FF FF, ID, length

/// Over ID … parameters.
std::uint8_t check_of(Bytes covered) noexcept {
  unsigned sum = 0;
  for (const std::uint8_t byte : covered) sum += byte;
  return static_cast<std::uint8_t>(~sum);
}

}  // namespace

Wire encode(std::uint8_t id, std::uint8_t code, Bytes parameters) noexcept {
  Wire wire;
  wire.push(0xFF);
  wire.push(0xFF);
  wire.push(id);
  wire.push(static_cast<std::uint8_t>(parameters.size() + 2));
  wire.push(code);
  wire.push(parameters);
  wire.push(check_of(wire.view().subspan(2)));
  return wire;
}

Wire ping(std::uint8_t id) noexcept {
  return encode(id, static_cast<std::uint8_t>(Instruction::Ping), {});
}

Wire read(std::uint8_t id, std::uint8_t address, std::uint8_t length) noexcept {
  const std::uint8_t parameters[] = {address, length};
  return encode(id, static_cast<std::uint8_t>(Instruction::Read), parameters);
}

Wire write(std::uint8_t id, std::uint8_t address, Bytes values) noexcept {
  Wire parameters;
  parameters.push(address);
  parameters.push(values);
  return encode(id, static_cast<std::uint8_t>(Instruction::Write), parameters.view());
}

Wire sync_read(std::uint8_t address, std::uint8_t length, Bytes ids) noexcept {
  Wire parameters;
  parameters.push(address);
  parameters.push(length);
  parameters.push(ids);
  return encode(kEveryone, static_cast<std::uint8_t>(Instruction::SyncRead), parameters.view());
}

Scan Format::scan(Bytes bytes, Packet& packet) noexcept {
  if (bytes[0] != 0xFF || (bytes.size() > 1 && bytes[1] != 0xFF)) return {Scan::Kind::Skip, 1};
  if (bytes.size() > 2 && bytes[2] == 0xFF) return {Scan::Kind::Skip, 1};  // no servo has that ID
  if (bytes.size() < kAhead) return {Scan::Kind::NeedMore, 0};
  const std::size_t length = bytes[3];
  const std::size_t whole = kAhead + length;
  if (length < 2 || whole > kMost) return {Scan::Kind::Broken, 1};
  if (bytes.size() < whole) return {Scan::Kind::NeedMore, 0};
  if (check_of(bytes.subspan(2, whole - 3)) != bytes[whole - 1]) return {Scan::Kind::Broken, 1};
  packet = {bytes[2], bytes[4], {}};
  packet.parameters.push(bytes.subspan(kAhead + 1, length - 2));
  return {Scan::Kind::Frame, whole};
}

std::uint16_t sign_magnitude(int value, int sign) noexcept {
  const auto amount = static_cast<unsigned>(std::abs(value)) & ((1U << sign) - 1U);
  return static_cast<std::uint16_t>(amount | (value < 0 ? 1U << sign : 0U));
}

int from_sign_magnitude(std::uint16_t value, int sign) noexcept {
  const int amount = static_cast<int>(value & ((1U << sign) - 1U));
  return (value & 1U << sign) != 0 ? -amount : amount;
}

std::string error_text(std::uint8_t error) {
  constexpr std::pair<unsigned, const char*> kBits[] = {{1, "wrong supply voltage"},
                                                        {2, "its angle sensor has failed"},
                                                        {4, "too hot"},
                                                        {8, "too much current"},
                                                        {32, "overload"}};
  std::string text;
  for (const auto& [bit, what] : kBits)
    if ((error & bit) != 0) text += (text.empty() ? "" : ", ") + std::string(what);
  return error != 0 && text.empty() ? "an error of unknown number" : text;
}

}  // namespace rob::drivers::feetech
