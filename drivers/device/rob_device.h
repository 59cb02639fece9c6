#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include "drivers/protocol/frame_reader.h"
#include "drivers/protocol/rob_frame.h"

namespace rob::drivers {

/// The device's side of Rob's own protocol (docs/serial-protocol.md), to be built into a
/// microcontroller's firmware: C++20 without heap, exceptions, system, or double. It needs this
/// file and drivers/protocol/. The firmware calls receive() with the bytes of its UART, step() at a
/// fixed rate of its own, moves its axes to position(), and sends what send() returns.
///
/// Positions are in 1e-6 mm or deg, times in µs of the device's clock, which wraps.
class RobDevice {
 public:
  static constexpr int kQueue = 16;                   ///< references
  static constexpr std::uint32_t kFirst = 1'000'000;  ///< µs from ENABLE to the first reference
  static constexpr std::uint32_t kSilence = 100'000;  ///< µs without a reference: it stops
  static constexpr int kMissing = 3;                  ///< periods without one: it stops
  static constexpr std::uint32_t kPause = 20'000;  ///< µs within a frame: what came is forgotten

  struct Settings {
    int axes = 3;
    std::uint16_t highest_rate = 500;
    std::uint16_t firmware = 1;
    /// 1e-6 mm/s² or deg/s², with which a stop of category 1 brakes.
    std::int64_t braking = 100'000'000;
  };

  explicit RobDevice(const Settings& settings) noexcept : settings_(settings) {}

  /// Where the axes stand by the device's own account: before the first step(), and whenever it
  /// is not enabled.
  void stand_at(const wire::Axes& position) noexcept;
  void receive(Bytes bytes, std::uint32_t now) noexcept;
  /// The bytes to send next; empty until there is another answer.
  wire::Wire send() noexcept;
  /// Where the axes shall be now.
  void step(std::uint32_t now) noexcept;

  const wire::Axes& position() const noexcept { return position_; }
  const wire::Axes& velocity() const noexcept { return velocity_; }
  bool enabled() const noexcept { return enabled_; }
  /// References that came after their instant: counted here, not carried out.
  std::uint32_t late() const noexcept { return late_; }

 private:
  void take(const wire::Frame& frame, std::uint32_t now) noexcept;
  void begin_session(std::uint8_t sequence, std::uint32_t now) noexcept;
  void refuse(const wire::Frame& frame) noexcept;
  void take_reference(const wire::Reference& reference, std::uint32_t now) noexcept;
  void begin_path(std::uint32_t now) noexcept;
  void enable(bool on, std::uint32_t now) noexcept;
  void stop(int category, std::uint32_t now) noexcept;
  void answer(wire::Type type, std::uint8_t sequence, Bytes payload) noexcept;
  void answer_state(std::uint8_t sequence, std::uint32_t now) noexcept;
  void follow(std::uint32_t now) noexcept;
  void brake(std::uint32_t now) noexcept;
  void between_references(const wire::Reference& a, const wire::Reference& b,
                          std::uint32_t now) noexcept;
  bool starved(std::uint32_t now) const noexcept;
  bool moving() const noexcept;

  Settings settings_;
  FrameReader<wire::Format> reader_;
  wire::Wire out_;
  bool session_ = false;  ///< HELLO has come
  bool enabled_ = false;
  bool braking_ = false;
  std::uint16_t flags_ = 0;     ///< kStarved, kFault; kLate until the next STATE
  std::uint32_t heard_ = 0;     ///< when the last reference was taken, or ENABLE came
  std::uint32_t received_ = 0;  ///< when the last bytes came
  std::uint32_t stepped_ = 0;
  std::uint32_t late_ = 0;
  std::uint16_t last_ = 0;
  wire::Reference before_;  ///< of the two between which the axes are
  bool has_before_ = false;
  std::array<wire::Reference, kQueue> queue_;
  int first_ = 0;
  int count_ = 0;
  wire::Axes position_{};
  wire::Axes velocity_{};
};

}  // namespace rob::drivers
