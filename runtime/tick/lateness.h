#pragma once

#include <optional>

#include "motion/robots/robot_model.h"

namespace rob::runtime {

/// Judges how late this computer is with a servo cycle, and with the references that the cycle
/// follows. Every call but the constructor may be used in the tick; all times in s.
class Lateness {
 public:
  explicit Lateness(const motion::RobotModel& robot);

  /// A reference with this stamp has come.
  void take(double stamp) noexcept { newest_ = stamp; }
  /// Whether the references that bridge this gap are only about to come, so that it is worth
  /// waiting for them.
  bool references_are_coming(double now, double gap) noexcept;

  /// Between two cycles: the interpolator bridges it by itself.
  bool bridged(double gap) const noexcept { return gap <= bridged_; }
  /// After a longer gap the machine has been on its own.
  double longest_gap() const noexcept { return longest_; }
  /// How far the axes may be from the references, at full speed.
  double most_behind() const noexcept { return most_behind_; }

 private:
  double reference_period_;
  double bridged_;
  double longest_;
  double most_behind_;
  double newest_ = 0;                    ///< stamp of the newest reference
  std::optional<double> waiting_since_;  ///< for references that are about to come
};

}  // namespace rob::runtime
