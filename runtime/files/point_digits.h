#pragma once

#include <vector>

#include "lang/values/pose_math.h"
#include "motion/robots/robot_model.h"

namespace rob::runtime {

/// Decimal places of mm and deg with which points are saved: 0.001 mm and 0.0001 deg, which people
/// can read and no machine can tell from what it measured. A machine that measures finer keeps what
/// it measures.
struct PointDigits {
  static constexpr int kAll = -1;  ///< what is saved is not rounded

  int length = kAll;
  int angle = kAll;
  std::vector<int> joints;  ///< of each axis
};

PointDigits digits_of(const motion::RobotModel& robot);

/// The double nearest to the decimal of so many places.
double rounded_to(double value, int digits);

/// The angles of a pose in deg, rounded. A value that is read of them and rounded again is the
/// same.
lang::FixedAngles rounded_angles(const lang::Quaternion& rotation, int digits);

}  // namespace rob::runtime
