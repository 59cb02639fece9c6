#include "runtime/files/point_digits.h"

#include <algorithm>
#include <cmath>

#include "lang/values/units.h"
#include "runtime/words/pose_values.h"
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

/// How the tip moves, seen from itself, when the axes go from where they stood to the point's.
lang::PoseValue moved_tip(const motion::RobotModel& robot, const std::vector<double>& stood,
                          const lang::TaughtPoint& point) {
  using lang::pose_math::compose;
  const auto flange_at = [&](const std::vector<double>& joints) {
    const Eigen::Map<const Eigen::VectorXd> q(joints.data(), robot.axis_count());
    return to_lang(robot.kinematics->forward(q));
  };
  return compose(lang::pose_math::inverse(compose(flange_at(stood), point.tip)),
                 compose(flange_at(point.joints), point.tip));
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
    const int places = digits_for(count, usual);
    const lang::Dimension dimension = linear ? lang::kLength : lang::kAngle;
    digits.joints.push_back(
        {places, lang::from_si(axis.min, dimension), lang::from_si(axis.max, dimension)});
    // The finest axis counts for the pose, to which all of them add.
    const int more = places - usual;
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

double rounded_within(double value, const PointDigits::Joint& joint) {
  const double nearest = rounded_to(value, joint.digits);
  if (nearest >= joint.min && nearest <= joint.max) return nearest;
  const double scale = std::pow(10.0, joint.digits);
  const double inside =
      (nearest > joint.max ? std::floor(joint.max * scale) : std::ceil(joint.min * scale)) / scale;
  return inside >= joint.min && inside <= joint.max ? inside + 0.0 : value;
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

/// As a points file is read.
static lang::PoseValue rounded_pose(const lang::PoseValue& pose, const PointDigits& digits) {
  const auto length = [&](double si) {
    return lang::to_si(rounded_to(lang::from_si(si, lang::kLength), digits.length), lang::kLength);
  };
  const lang::FixedAngles angles = rounded_angles(pose.rotation, digits.angle);
  const auto angle = [](double degrees) { return lang::to_si(degrees, lang::kAngle); };
  const auto& [x, y, z] = pose.position;
  return {{length(x), length(y), length(z)},
          lang::pose_math::from_fixed({angle(angles.a), angle(angles.b), angle(angles.c)})};
}

void round_as_kept(const motion::RobotModel& robot, lang::TaughtPoint& point) {
  const PointDigits digits = digits_of(robot);
  const std::vector<double> stood = point.joints;
  bool at_end = false;
  for (std::size_t i = 0; i < stood.size(); ++i) {
    const bool linear = robot.axes[i].kind == motion::AxisKind::Linear;
    const lang::Dimension dimension = linear ? lang::kLength : lang::kAngle;
    const double value = lang::from_si(stood[i], dimension);
    const double kept = rounded_within(value, digits.joints[i]);
    at_end = at_end || kept != rounded_to(value, digits.joints[i].digits);
    point.joints[i] = lang::to_si(kept, dimension);
  }
  if (at_end) point.pose = lang::pose_math::compose(point.pose, moved_tip(robot, stood, point));
  point.pose = rounded_pose(point.pose, digits);
}

}  // namespace rob::runtime
