#include "runtime/files/point_digits.h"

#include <algorithm>
#include <cmath>

#include "lang/values/units.h"
#include "runtime/words/units.h"

namespace rob::runtime {

namespace {

constexpr int kLengthDigits = 3;
constexpr int kAngleDigits = 4;
constexpr int kMostDigits = 9;  // more are noise of the computation

/// Those that tell the counts of an encoder from each other, at least `usual`.
int digits_for(double count, int usual) {
  if (!(count > 0)) return usual;
  constexpr double kRounding = 1e-9;  // 0.001 must not become 0.0009999
  const int digits = static_cast<int>(std::ceil(-std::log10(count) - kRounding));
  return std::clamp(digits, usual, kMostDigits);
}

lang::FixedAngles in_degrees(const lang::Quaternion& rotation) {
  const lang::FixedAngles angles = lang::pose_math::to_fixed(rotation);
  return {lang::from_si(angles.a, lang::kAngle), lang::from_si(angles.b, lang::kAngle),
          lang::from_si(angles.c, lang::kAngle)};
}

bool same(const lang::FixedAngles& one, const lang::FixedAngles& other) {
  return one.a == other.a && one.b == other.b && one.c == other.c;
}

}  // namespace

PointDigits digits_of(const motion::RobotModel& robot) {
  PointDigits digits{kLengthDigits, kAngleDigits, {}};
  for (const motion::Axis& axis : robot.axes) {
    const bool linear = axis.kind == motion::AxisKind::Linear;
    const double count = axis.drive.encoder_resolution * shown_per_si(axis.kind);
    const int usual = linear ? kLengthDigits : kAngleDigits;
    digits.joints.push_back(digits_for(count, usual));
    // The finest axis counts for the pose, to which all of them add.
    const int more = digits.joints.back() - usual;
    digits.length = std::max(digits.length, kLengthDigits + more);
    digits.angle = std::max(digits.angle, kAngleDigits + more);
  }
  return digits;
}

double rounded_to(double value, int digits) {
  if (digits == PointDigits::kAll) return value;
  const double scale = std::pow(10.0, digits);
  return std::round(value * scale) / scale + 0.0;  // of no -0
}

/// Rounding may bring b to 90deg, where a and c are one turn, or an angle to -180deg, which is read
/// as 180deg. Then the same place has other angles, which the next look finds.
lang::FixedAngles rounded_angles(const lang::Quaternion& rotation, int digits) {
  constexpr int kMostLooks = 4;
  lang::FixedAngles angles = in_degrees(rotation);
  for (int look = 0; look < kMostLooks && digits != PointDigits::kAll; ++look) {
    const lang::FixedAngles rounded{rounded_to(angles.a, digits), rounded_to(angles.b, digits),
                                    rounded_to(angles.c, digits)};
    if (look > 0 && same(rounded, angles)) break;
    const lang::FixedAngles read = in_degrees(lang::pose_math::from_fixed(
        {lang::to_si(rounded.a, lang::kAngle), lang::to_si(rounded.b, lang::kAngle),
         lang::to_si(rounded.c, lang::kAngle)}));
    angles = {rounded_to(read.a, digits), rounded_to(read.b, digits), rounded_to(read.c, digits)};
    if (same(rounded, angles)) break;
  }
  return angles;
}

}  // namespace rob::runtime
