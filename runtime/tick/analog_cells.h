#pragma once

#include <array>
#include <atomic>
#include <cstddef>

#include "motion/space/analog_channels.h"

namespace rob::runtime {

/// The volts of one direction's analog channels, from one writing thread to others. Each channel is
/// whole; two channels may be of two neighbouring cycles. Every call may be used in the tick.
class AnalogCells {
 public:
  /// Before any other call: the channels from `count` on are not used, and stay at 0.
  void use(int count) noexcept { used_ = static_cast<std::size_t>(count); }
  void store(const motion::AnalogValues& volts) noexcept {
    for (std::size_t i = 0; i < used_; ++i) {
      cells_[i].store(volts[i], std::memory_order_relaxed);
    }
  }
  motion::AnalogValues load() const noexcept {
    motion::AnalogValues volts{};
    for (std::size_t i = 0; i < used_; ++i) volts[i] = at(static_cast<int>(i));
    return volts;
  }
  /// `channel` counts from 0.
  double at(int channel) const noexcept {
    return cells_[static_cast<std::size_t>(channel)].load(std::memory_order_relaxed);
  }

 private:
  std::size_t used_ = motion::kMostAnalog;
  std::array<std::atomic<double>, motion::kMostAnalog> cells_{};
};

}  // namespace rob::runtime
