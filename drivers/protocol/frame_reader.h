#pragma once

#include <cstddef>
#include <cstdint>

#include "drivers/protocol/byte_buffer.h"

namespace rob::drivers {

/// The result of looking for a frame at the beginning of some bytes.
struct Scan {
  enum class Kind : std::uint8_t {
    NeedMore,  ///< the beginning of a frame, as far as it goes
    Skip,      ///< no frame begins here
    Broken,    ///< it looked like a frame, and its check does not fit
    Frame      ///< a whole frame of `bytes`
  };
  Kind kind = Kind::NeedMore;
  std::size_t bytes = 0;
};

/// Finds frames in what comes on a wire, whatever lies between them. A `Format` has a type `Frame`,
/// the most bytes `kMost` that a frame has, and `Scan scan(Bytes, Frame&)`. After a broken frame
/// the search goes on at its second byte, so that a good frame within it is not lost.
template <typename Format>
class FrameReader {
 public:
  using Frame = typename Format::Frame;

  /// Room is for two frames; what is beyond pushes the oldest bytes out.
  void add(Bytes bytes) noexcept {
    for (const std::uint8_t byte : bytes) {
      if (bytes_.full()) skip();
      bytes_.push(byte);
    }
  }
  bool next(Frame& frame) noexcept {
    while (bytes_.size() > 0) {
      const Scan found = Format::scan(bytes_.view(), frame);
      if (found.kind == Scan::Kind::NeedMore) return false;
      if (found.kind == Scan::Kind::Frame) {
        bytes_.drop(found.bytes);
        return true;
      }
      if (found.kind == Scan::Kind::Broken) ++broken_;
      skip();
    }
    return false;
  }
  /// A half frame is forgotten: nothing of it is joined to what comes later.
  void clear() noexcept { bytes_.clear(); }

  std::uint32_t broken() const noexcept { return broken_; }
  std::uint32_t skipped() const noexcept { return skipped_; }

 private:
  void skip() noexcept {
    bytes_.drop(1);
    ++skipped_;
  }

  ByteBuffer<2 * Format::kMost> bytes_;
  std::uint32_t broken_ = 0;
  std::uint32_t skipped_ = 0;
};

}  // namespace rob::drivers
