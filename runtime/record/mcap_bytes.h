#pragma once

#include <cstdint>
#include <string>
#include <string_view>

/// How an MCAP file writes numbers and texts (mcap.dev/spec, "Serialization"): little-endian.
namespace rob::runtime::mcap {

inline constexpr std::string_view kMagic = "\x89MCAP0\r\n";

enum Opcode : std::uint8_t {
  kHeader = 0x01,
  kFooter = 0x02,
  kSchema = 0x03,
  kChannel = 0x04,
  kMessage = 0x05,
  kChunkRecord = 0x06,
  kMessageIndex = 0x07,
  kChunkIndex = 0x08,
  kAttachment = 0x09,
  kAttachmentIndex = 0x0A,
  kStatistics = 0x0B,
  kSummaryOffset = 0x0E,
  kDataEnd = 0x0F
};

template <typename Number>
void put_number(std::string& bytes, Number value) {
  for (std::size_t i = 0; i < sizeof value; ++i)
    bytes += static_cast<char>(static_cast<std::uint64_t>(value) >> (8 * i) & 0xFFU);
}
inline void put16(std::string& bytes, std::uint16_t value) { put_number(bytes, value); }
inline void put32(std::string& bytes, std::uint32_t value) { put_number(bytes, value); }
inline void put64(std::string& bytes, std::uint64_t value) { put_number(bytes, value); }
inline void put_text(std::string& bytes, std::string_view text) {
  put32(bytes, static_cast<std::uint32_t>(text.size()));
  bytes += text;
}

/// Reads what the functions above have written. Beyond the end it gives 0 and empty texts, and is
/// no longer good().
class Bytes {
 public:
  explicit Bytes(std::string_view bytes) : bytes_(bytes) {}

  template <typename Number>
  Number number() {
    const std::string_view taken = take(sizeof(Number));
    std::uint64_t value = 0;
    for (std::size_t i = 0; i < taken.size(); ++i)
      value |= static_cast<std::uint64_t>(static_cast<unsigned char>(taken[i])) << (8 * i);
    return static_cast<Number>(value);
  }
  std::string_view text() { return take(number<std::uint32_t>()); }
  std::string_view take(std::uint64_t size) {
    if (size > bytes_.size()) {
      good_ = false;
      bytes_ = {};
      return {};
    }
    const std::string_view taken = bytes_.substr(0, size);
    bytes_.remove_prefix(size);
    return taken;
  }
  bool empty() const { return bytes_.empty(); }
  std::size_t left() const { return bytes_.size(); }
  bool good() const { return good_; }

 private:
  std::string_view bytes_;
  bool good_ = true;
};

}  // namespace rob::runtime::mcap
