#include "motion/path/euler_line.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "base/unit_factors.h"
#include "motion/space/rotation.h"

namespace rob::motion {

namespace {

constexpr double kSteepest = 89 * std::numbers::pi / 180;  // rad, of b

/// From one angle to another, −π … π.
double shorter_way(double from, double to) { return std::remainder(to - from, kFullTurn); }

}  // namespace

EulerLine::EulerLine(const Pose& from, const Pose& to)
    : from_(from.position),
      shift_(to.position - from.position),
      first_(fixed_angles(from.orientation)) {
  const FixedAngles last = fixed_angles(to.orientation);
  change_ = {shorter_way(first_.a, last.a), last.b - first_.b, shorter_way(first_.c, last.c)};
  // b is monotone, and so is the turning speed in sin b: it is greatest at an end.
  greatest_turning_ = std::max(turning_at(0), turning_at(1));
  constexpr int kParts = 64;  // Simpson's rule, over at most 180° of b: to 1e-6
  double sum = turning_at(0) + turning_at(1);
  for (int k = 1; k < kParts; ++k) sum += (k % 2 == 1 ? 4 : 2) * turning_at(k / double{kParts});
  turn_ = sum / (3 * kParts);
}

std::variant<EulerLine, EulerLine::Trouble> EulerLine::between(const Pose& from, const Pose& to) {
  const EulerLine line(from, to);
  if (std::abs(line.first_.b) > kSteepest) return Trouble::SteepBeginning;
  if (std::abs(line.first_.b + line.change_.b) > kSteepest) return Trouble::SteepEnd;
  const double longest = std::max(std::abs(line.change_.a), std::abs(line.change_.c));
  if (longest > kLongestTurn) return Trouble::HalfTurn;
  return line;
}

Pose EulerLine::at(double s) const noexcept {
  return {from_ + s * shift_, orientation_from({first_.a + s * change_.a, first_.b + s * change_.b,
                                                first_.c + s * change_.c})};
}

/// ω = c'·z + b'·Rz·y + a'·Rz·Ry·x, and z·(Rz·Ry·x) = −sin b.
double EulerLine::turning_at(double s) const noexcept {
  const double square = change_.a * change_.a + change_.b * change_.b + change_.c * change_.c -
                        2 * change_.a * change_.c * std::sin(first_.b + s * change_.b);
  return std::sqrt(std::max(square, 0.0));
}

}  // namespace rob::motion
