#pragma once

#include <array>
#include <cstdint>

#include "drivers/contact/noise.h"
#include "motion/cell/cell_data.h"
#include "motion/space/wrench.h"

namespace rob::drivers {

/// A six-axis force-torque sensor between flange and tool that is not there: it takes a sample
/// every SensorErrors::period, adds its bias and its noise, and reports it `delay` later. SI. Every
/// call but the constructor may be used in the tick.
class ForceSensor {
 public:
  enum class Fault : std::uint8_t {
    None,
    Silent,  ///< reports nothing new
    Stuck    ///< goes on reporting the last value as if it were new
  };

  struct Told {
    motion::Wrench wrench;
    double time = 0;  ///< when it was taken; 0: never
  };

  /// Throws std::invalid_argument for a period of 0, or a delay of more samples than it remembers.
  ForceSensor(const motion::SensorErrors& errors, double delay, std::uint64_t seed);

  /// Forgets all samples; the noise goes on.
  void clear() noexcept;
  /// Takes a sample of `acting`, which acts at `time`, an instant at which a sample is due.
  void take(double time, const motion::Wrench& acting) noexcept;
  /// The newest sample that has got through at `now`.
  Told told(double now) const noexcept;
  double period() const noexcept { return errors_.period; }
  /// For tests.
  void fail(Fault fault) noexcept { fault_ = fault; }

 private:
  static constexpr std::size_t kSamples = 128;

  motion::SensorErrors errors_;
  double delay_;
  Noise noise_;
  Fault fault_ = Fault::None;
  std::array<Told, kSamples> samples_{};
  std::uint64_t taken_ = 0;
};

}  // namespace rob::drivers
