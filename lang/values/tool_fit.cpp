#include "lang/values/tool_fit.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace rob::lang {
namespace {

using pose_math::operator+;
using pose_math::operator-;
using pose_math::operator*;

/// The columns of a matrix.
using Columns = std::array<Vector3, 3>;

Columns columns_of(const Quaternion& q) {
  return {pose_math::rotate(q, {1, 0, 0}), pose_math::rotate(q, {0, 1, 0}),
          pose_math::rotate(q, {0, 0, 1})};
}

double determinant(const Vector3& a, const Vector3& b, const Vector3& c) {
  return pose_math::dot(a, pose_math::cross(b, c));
}

/// The least eigenvalue of a symmetric matrix, in closed form (Smith 1961).
double least_eigenvalue(const Columns& m) {
  const double mean = (m[0].x + m[1].y + m[2].z) / 3;
  const Columns off{m[0] - Vector3{mean, 0, 0}, m[1] - Vector3{0, mean, 0},
                    m[2] - Vector3{0, 0, mean}};
  double square = 0;
  for (const Vector3& column : off) square += pose_math::dot(column, column);
  const double spread = std::sqrt(square / 6);
  if (spread == 0) return mean;
  const double cosine = determinant(off[0], off[1], off[2]) / (2 * spread * spread * spread);
  const double angle = std::acos(std::clamp(cosine, -1.0, 1.0)) / 3;
  return mean + 2 * spread * std::cos(angle + 2 * std::numbers::pi / 3);
}

/// Cramer's rule.
Vector3 solve(const Columns& m, const Vector3& b) {
  const double whole = determinant(m[0], m[1], m[2]);
  return {determinant(b, m[1], m[2]) / whole, determinant(m[0], b, m[2]) / whole,
          determinant(m[0], m[1], b) / whole};
}

PoseValue minus(const PoseValue& pose, const Vector3& place) {
  return {pose.position - place, pose.rotation};
}

/// Means over the poses: of places, and of the columns of their orientations.
struct Means {
  Vector3 place;
  Columns turn{};
};

Means means_of(std::span<const PoseValue> flanges) {
  const double share = 1 / static_cast<double>(flanges.size());
  Means means;
  for (const PoseValue& flange : flanges) {
    means.place = means.place + share * flange.position;
    const Columns turn = columns_of(flange.rotation);
    for (std::size_t i = 0; i < turn.size(); ++i) means.turn[i] = means.turn[i] + share * turn[i];
  }
  return means;
}

/// The places of the tip around their mean.
double miss_of(std::span<const PoseValue> flanges, const Vector3& tip) {
  const double share = 1 / static_cast<double>(flanges.size());
  Vector3 mean;
  for (const PoseValue& flange : flanges) mean = mean + share * pose_math::transform(flange, tip);
  double square = 0;
  for (const PoseValue& flange : flanges) {
    const Vector3 off = pose_math::transform(minus(flange, mean), tip);
    square += share * pose_math::dot(off, off);
  }
  return std::sqrt(square);
}

}  // namespace

/// Place p and orientation R of each pose bring the tip t to one place: (R − R̄)·t = p̄ − p. Of
/// poses that are turned from their mean by small w the normal matrix is Σ([w]×)ᵀ[w]×; its least
/// eigenvalue counts the turns about all axes but the one most turned about. Four poses on a cross,
/// those opposite turned by θ from each other, give it as N·θ²/8.
std::optional<ToolFit> fit_tool(std::span<const PoseValue> flanges) {
  constexpr double kLeastTurn = 10 * std::numbers::pi / 180;
  const Means means = means_of(flanges);
  Columns normal{};
  Vector3 right;
  for (const PoseValue& flange : flanges) {
    const Columns turn = columns_of(flange.rotation);
    const Columns off{turn[0] - means.turn[0], turn[1] - means.turn[1], turn[2] - means.turn[2]};
    const Vector3 back = means.place - flange.position;
    const auto seen = [&](const Vector3& v) {
      return Vector3{pose_math::dot(off[0], v), pose_math::dot(off[1], v),
                     pose_math::dot(off[2], v)};
    };
    for (std::size_t i = 0; i < off.size(); ++i) normal[i] = normal[i] + seen(off[i]);
    right = right + seen(back);
  }
  const double least = least_eigenvalue(normal) / static_cast<double>(flanges.size());
  if (!(8 * least > kLeastTurn * kLeastTurn)) return std::nullopt;
  ToolFit fit;
  fit.tip = solve(normal, right);
  fit.miss = miss_of(flanges, fit.tip);
  return fit;
}

}  // namespace rob::lang
