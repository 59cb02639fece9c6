#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <span>

namespace rob::drivers {

using Bytes = std::span<const std::uint8_t>;

/// Bytes in a row, at most `kMost`, wholly in the object: for packets in a thread that takes no
/// memory. Bytes that no longer fit are dropped, and full() reports it.
template <std::size_t kMost>
class ByteBuffer {
 public:
  constexpr ByteBuffer() = default;

  constexpr std::size_t size() const noexcept { return size_; }
  constexpr bool full() const noexcept { return size_ == kMost; }
  constexpr void clear() noexcept { size_ = 0; }
  constexpr std::uint8_t operator[](std::size_t i) const noexcept { return bytes_[i]; }
  constexpr Bytes view() const noexcept { return {bytes_.data(), size_}; }

  constexpr void push(std::uint8_t byte) noexcept {
    if (size_ < kMost) bytes_[size_++] = byte;
  }
  constexpr void push(Bytes bytes) noexcept {
    for (const std::uint8_t byte : bytes) push(byte);
  }
  /// Little-endian.
  constexpr void push16(std::uint32_t value) noexcept {
    push(static_cast<std::uint8_t>(value));
    push(static_cast<std::uint8_t>(value >> 8U));
  }
  constexpr void push32(std::uint32_t value) noexcept {
    push16(value);
    push16(value >> 16U);
  }
  constexpr void set(std::size_t i, std::uint8_t byte) noexcept { bytes_[i] = byte; }
  /// Takes the first `count` out.
  constexpr void drop(std::size_t count) noexcept {
    for (std::size_t i = count; i < size_; ++i) bytes_[i - count] = bytes_[i];
    size_ -= count;
  }

 private:
  std::array<std::uint8_t, kMost> bytes_{};
  std::size_t size_ = 0;
};

constexpr std::uint16_t little16(Bytes bytes, std::size_t at) noexcept {
  return static_cast<std::uint16_t>(bytes[at] | bytes[at + 1] << 8);
}
constexpr std::uint32_t little32(Bytes bytes, std::size_t at) noexcept {
  return little16(bytes, at) | static_cast<std::uint32_t>(little16(bytes, at + 2)) << 16U;
}

}  // namespace rob::drivers
