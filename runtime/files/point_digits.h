#pragma once

#include <vector>

#include "lang/machine/point_table.h"
#include "lang/values/pose_math.h"
#include "motion/robots/robot_model.h"

namespace rob::runtime {

/// Decimal places of mm and deg with which points are saved: 0.001 mm and 0.0001 deg, which people
/// can read and no machine can tell from what it measured. A machine that measures finer keeps what
/// it measures.
struct PointDigits {
  static constexpr int kAll = -1;  ///< what is saved is not rounded

  /// For an axis; a value is never rounded beyond its ends, mm or deg.
  struct Joint {
    int digits;
    double min;
    double max;
  };

  int length = kAll;
  int angle = kAll;
  std::vector<Joint> joints;  ///< of each axis; empty: none is rounded
};

PointDigits digits_of(const motion::RobotModel& robot);

/// The double nearest to the decimal of so many places.
double rounded_to(double value, int digits);

/// The same, but between the ends of the axis where the value is; as it is where no such decimal
/// lies there.
double rounded_within(double value, const PointDigits::Joint& joint);

/// The angles of a pose in deg, rounded. A value that is read of them and rounded again is the
/// same.
lang::FixedAngles rounded_angles(const lang::Quaternion& rotation, int digits);

/// Pose and joints become what a points file keeps of them. Where an end of an axis does not let a
/// joint be rounded to the nearest decimal, the pose is that to which the rounded joints lead.
void round_as_kept(const motion::RobotModel& robot, lang::TaughtPoint& point);

}  // namespace rob::runtime
