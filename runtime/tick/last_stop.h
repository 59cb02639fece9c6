#pragma once

#include <optional>

#include "motion/generate/axis_brake.h"
#include "motion/generate/trajectory_generator.h"
#include "motion/robots/robot_model.h"
#include "runtime/tick/channels.h"

namespace rob::runtime {

/// How the axes come to rest for good when they cannot stop on their path: at once, by a second
/// Ctrl-C; and after a gap that cannot be made up, from where the servo finds them. While it is
/// active the generators no longer count. All calls but the constructor may be used in the tick.
class LastStop {
 public:
  explicit LastStop(const motion::RobotModel& robot);

  /// From this reference on, as hard as the axes can.
  void brake(const motion::JointReference& from) noexcept;
  /// Nobody has looked after the axes for too long, or the servo had no references: the references
  /// stand still until the servo says where the axes are. Nothing if it is active already.
  void lose_touch(double now) noexcept;
  /// A sample of the servo. One that was taken after the gap says where the servo found the axes,
  /// or, if it was there all the while, where it sent them meanwhile: they are braked from there.
  void take(const ServoSample& sample) noexcept;

  bool active() const noexcept { return lost_ || brake_.active(); }
  bool braking() const noexcept { return brake_.active(); }
  /// While it is active, the reference of `stamp` in place of the generator's. Whether the axes
  /// stand then: true once.
  bool lead(motion::GeneratorSample& sample, double stamp) noexcept;
  /// When the axes stand, s. While braking().
  double rest() const noexcept { return brake_.rest(); }

 private:
  double period_;
  motion::AxisBrake brake_;
  std::optional<double> lost_;   ///< since when nobody knows where the axes are, s
  motion::JointReference last_;  ///< the last reference
};

}  // namespace rob::runtime
