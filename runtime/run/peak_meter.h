#pragma once

#include <vector>

#include "motion/robots/robot_model.h"
#include "motion/space/joint_vector.h"
#include "runtime/run/run_result.h"

namespace rob::runtime {

/// The greatest speed, acceleration and jerk of the references that were handed out: differences of
/// their positions and times, whatever the speeds and accelerations that came with them say.
class PeakMeter {
 public:
  explicit PeakMeter(const motion::RobotModel& robot);

  /// The next reference, m, rad and s; one that is not later than the last is passed over.
  void take(const motion::JointReference& reference);
  /// An entry for each axis: mm or deg and s.
  const std::vector<AxisPeak>& peaks() const noexcept { return peaks_; }

 private:
  /// Differences up to the last reference.
  struct Axis {
    double scale = 1;  ///< mm per m, or deg per rad
    double q = 0;
    double v = 0;
    double a = 0;
  };
  std::vector<Axis> axes_;
  std::vector<AxisPeak> peaks_;
  double time_ = 0;
  double last_period_ = 0;    ///< s between the last two references
  double former_period_ = 0;  ///< and between those before
  int taken_ = 0;             ///< references, no more than 3 are counted
};

}  // namespace rob::runtime
