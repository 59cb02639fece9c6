#pragma once

#include "motion/servo/drive_data.h"

namespace rob::drivers {

/// A drive that takes pulses, without its axis. It spends the pulses that it was last given evenly
/// over the servo's period, as a pulse board puts it out; pulses that come early wait in line.
/// Without new ones it stands.
///
/// Under ServoStructure::PulseTrain the drive counts the pulses against its encoder and runs at a
/// rate proportional to the difference, as a magnet's teeth pull a stepping motor; else at the
/// pulses' own. m or rad, s. Every call but the constructor may be used in the tick.
class PulseDrive {
 public:
  /// `gain`: 1/s, what the drive's own counter works with; 0 if it counts nothing.
  PulseDrive(const motion::PulseDriveData& data, double servo_period, double gain);

  /// Nothing waits, and the counter agrees with the axis at q.
  void clear(double q) noexcept;
  /// Pulses from now on; a number that is not finite counts as none.
  void take(double pulses) noexcept;
  /// The force of the coming h seconds on an axis at q, of which `counted` is measured.
  double force(double h, double q, double counted, double v) noexcept;

 private:
  motion::PulseDriveData data_;
  double period_;
  double gain_;
  double left_ = 0;  // s that pulses still come
  double rate_ = 0;  // of the axis, meanwhile
  double way_ = 0;   // sum of all pulses
};

}  // namespace rob::drivers
