#pragma once

#include <array>
#include <atomic>
#include <cstdint>

namespace rob::drivers {

/// The newest of many values, from one thread to one other; older ones are lost. Neither side ever
/// waits. Three places: one that is written, one that is read, and one in between.
template <typename T>
class Latest {
 public:
  Latest() = default;
  explicit Latest(const T& value) { places_.fill(value); }

  /// The writer's.
  void store(const T& value) noexcept {
    places_[writes_] = value;
    writes_ =
        between_.exchange(static_cast<std::uint8_t>(writes_ | kNew), std::memory_order_acq_rel) &
        kPlace;
  }
  /// The reader's; valid until its next call.
  const T& load() noexcept {
    if ((between_.load(std::memory_order_relaxed) & kNew) != 0)
      reads_ = between_.exchange(reads_, std::memory_order_acq_rel) & kPlace;
    return places_[reads_];
  }

 private:
  static constexpr std::uint8_t kPlace = 3;
  static constexpr std::uint8_t kNew = 4;

  std::array<T, 3> places_{};
  std::uint8_t writes_ = 0;
  std::uint8_t reads_ = 1;
  std::atomic<std::uint8_t> between_{2};
};

}  // namespace rob::drivers
