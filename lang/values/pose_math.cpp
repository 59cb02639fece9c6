#include "lang/values/pose_math.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace rob::lang::pose_math {
namespace {

constexpr double kPi = std::numbers::pi;
constexpr double kDegree = kPi / 180;  // as in the table of units

struct HalfTurn {
  double cosine;
  double sine;
};

/// Cosine and sine of half an angle. Where they are equal, or one is 0, rounding would part them by
/// a last bit, and a quarter turn would be none.
HalfTurn half_turn(double angle) {
  constexpr double kLastBit = 2.3e-16;  // [choice] one unit in the last place of 1, and a little
  HalfTurn half{std::cos(angle / 2), std::sin(angle / 2)};
  if (std::fabs(half.cosine) < kLastBit) half = {0, std::copysign(1.0, half.sine)};
  if (std::fabs(half.sine) < kLastBit && std::fabs(angle) > 1) half.sine = 0;
  if (std::fabs(std::fabs(half.cosine) - std::fabs(half.sine)) < kLastBit) {
    half.sine = std::copysign(half.cosine, half.sine);
  }
  return half;
}

Quaternion product(const Quaternion& p, const Quaternion& q) {
  return {(p.w * q.w - p.k * q.k) - (p.i * q.i + p.j * q.j),
          (p.w * q.i - p.k * q.j) + (p.i * q.w + p.j * q.k),
          (p.w * q.j + p.k * q.i) - (p.i * q.k - p.j * q.w),
          (p.w * q.k + p.k * q.w) + (p.i * q.j - p.j * q.i)};
}

double squared_length(const Quaternion& q) {
  return (q.w * q.w + q.j * q.j) + (q.i * q.i + q.k * q.k);
}

Quaternion scaled(const Quaternion& q, double s) {
  return {q.w * s + 0.0, q.i * s + 0.0, q.j * s + 0.0, q.k * s + 0.0};
}

/// Takes back what rounding has added to a length of nearly 1: one Newton step for 1/sqrt, which
/// spares root and division and treats equal components equally.
Quaternion steadied(const Quaternion& q) { return scaled(q, 1.5 - 0.5 * squared_length(q)); }

/// The product of two rotations, steadied: |p·q| is |p|·|q|, which need not wait for the product.
Quaternion turn_product(const Quaternion& p, const Quaternion& q) {
  return scaled(product(p, q), 1.5 - squared_length(p) * (0.5 * squared_length(q)));
}

Quaternion conjugate(const Quaternion& q) { return {q.w, 0 - q.i, 0 - q.j, 0 - q.k}; }

/// The rotation that leads from p to q, with the sign that makes it the shorter way round.
Quaternion between(const Quaternion& p, const Quaternion& q) {
  const Quaternion way = product(conjugate(p), q);
  return way.w < 0 ? scaled(way, -1) : way;
}

Vector3 axis_part(const Quaternion& q) { return {q.i, q.j, q.k}; }

double in_half_turns(double angle) {
  const double turned = std::remainder(angle, 2 * kPi);
  return turned <= -kPi ? kPi : turned;
}

/// To 1e-12 degrees, and then as a literal is converted.
double rounded(double angle) { return std::round(angle / kDegree * 1e12) / 1e12 * kDegree + 0.0; }

/// (-180°, 180°], also of what rounding has brought to -180°.
double rounded_turn(double angle) {
  const double turned = rounded(in_half_turns(angle));
  return turned <= -kPi ? kPi : turned;
}

/// From the columns of a rotation matrix: of the four ways that the diagonal offers, the one whose
/// divisor is greatest (Shepperd 1978).
Quaternion from_axes(const Vector3& x, const Vector3& y, const Vector3& z) {
  const double trace = x.x + y.y + z.z;
  const auto choices = std::to_array<std::pair<double, Quaternion>>(
      {{trace, {1 + trace, y.z - z.y, z.x - x.z, x.y - y.x}},
       {x.x, {y.z - z.y, 1 + 2 * x.x - trace, x.y + y.x, z.x + x.z}},
       {y.y, {z.x - x.z, x.y + y.x, 1 + 2 * y.y - trace, y.z + z.y}},
       {z.z, {x.y - y.x, z.x + x.z, y.z + z.y, 1 + 2 * z.z - trace}}});
  const auto* const best = std::ranges::max_element(
      choices, {}, [](const std::pair<double, Quaternion>& choice) { return choice.first; });
  return *normalized(best->second);
}

}  // namespace

Vector3 operator+(const Vector3& a, const Vector3& b) { return {a.x + b.x, a.y + b.y, a.z + b.z}; }
Vector3 operator-(const Vector3& a, const Vector3& b) { return {a.x - b.x, a.y - b.y, a.z - b.z}; }
Vector3 operator*(double s, const Vector3& v) { return {s * v.x, s * v.y, s * v.z}; }
double dot(const Vector3& a, const Vector3& b) { return a.x * b.x + a.y * b.y + a.z * b.z; }
Vector3 cross(const Vector3& a, const Vector3& b) {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}
double length(const Vector3& v) { return std::hypot(v.x, v.y, v.z); }

Quaternion from_fixed(const FixedAngles& angles) {
  const HalfTurn a = half_turn(angles.a);
  const HalfTurn b = half_turn(angles.b);
  const HalfTurn c = half_turn(angles.c);
  const Quaternion about_z{c.cosine, 0, 0, c.sine};
  const Quaternion about_y{b.cosine, 0, b.sine, 0};
  const Quaternion about_x{a.cosine, a.sine, 0, 0};
  return steadied(product(about_z, product(about_y, about_x)));
}

Quaternion from_zyz(double alpha, double beta, double gamma) {
  const HalfTurn first = half_turn(alpha);
  const HalfTurn second = half_turn(beta);
  const HalfTurn third = half_turn(gamma);
  const Quaternion tilted =
      product({first.cosine, 0, 0, first.sine}, {second.cosine, 0, second.sine, 0});
  return steadied(product(tilted, {third.cosine, 0, 0, third.sine}));
}

std::optional<Quaternion> normalized(const Quaternion& q) {
  // Scaled first, so that neither very large nor very small numbers spoil the sum of squares.
  const double greatest =
      std::max({std::fabs(q.w), std::fabs(q.i), std::fabs(q.j), std::fabs(q.k)});
  if (greatest == 0) return std::nullopt;
  const Quaternion unit{q.w / greatest, q.i / greatest, q.j / greatest, q.k / greatest};
  return scaled(unit, 1 / std::sqrt(squared_length(unit)));
}

// With half angles, and e = cos(b/2) + sin(b/2), f = cos(b/2) - sin(b/2), both >= 0:
//   w + j = e·cos((c - a)/2)   k - i = e·sin((c - a)/2)
//   w - j = f·cos((c + a)/2)   k + i = f·sin((c + a)/2)
// which, unlike the rotation matrix, keeps full accuracy up to b = ±90° (Bernardes and Viollet
// 2022). There e or f is 0, and one of the two angles between a and c means nothing.
FixedAngles to_fixed(const Quaternion& q) {
  constexpr double kNone = 1e-12;  // [choice] hundreds of roundings above what products leave
  const double e = std::hypot(q.w + q.j, q.k - q.i);
  const double f = std::hypot(q.w - q.j, q.k + q.i);
  double difference = std::atan2(q.k - q.i + 0.0, q.w + q.j + 0.0);
  double sum = std::atan2(q.k + q.i + 0.0, q.w - q.j + 0.0);
  if (f < kNone) sum = difference;
  if (e < kNone) difference = sum;
  return {.a = rounded_turn(sum - difference),
          .b = rounded(2 * std::atan2(e, f) - kPi / 2),
          .c = rounded_turn(sum + difference)};
}

// The matrix of a quaternion, divided by the square of its length: exact for quarter turns, whose
// components are equal, however they were rounded. So near to 1 the inverse of n is 2 - n.
Vector3 rotate(const Quaternion& q, const Vector3& v) {
  const double s = 2 * (2 - squared_length(q));
  const double ii = q.i * q.i;
  const double jj = q.j * q.j;
  const double kk = q.k * q.k;
  const double ij = q.i * q.j;
  const double ik = q.i * q.k;
  const double jk = q.j * q.k;
  const double wi = q.w * q.i;
  const double wj = q.w * q.j;
  const double wk = q.w * q.k;
  return {(1 - (jj + kk) * s) * v.x + (ij - wk) * s * v.y + (ik + wj) * s * v.z + 0.0,
          (1 - (kk + ii) * s) * v.y + (jk - wi) * s * v.z + (ij + wk) * s * v.x + 0.0,
          (1 - (ii + jj) * s) * v.z + (ik - wj) * s * v.x + (jk + wi) * s * v.y + 0.0};
}

PoseValue compose(const PoseValue& a_t_b, const PoseValue& b_t_c) {
  return {a_t_b.position + rotate(a_t_b.rotation, b_t_c.position),
          turn_product(a_t_b.rotation, b_t_c.rotation)};
}

PoseValue inverse(const PoseValue& a_t_b) {
  const Quaternion back = conjugate(a_t_b.rotation);
  return {rotate(back, Vector3{} - a_t_b.position), back};
}

Vector3 transform(const PoseValue& a_t_b, const Vector3& place) {
  return a_t_b.position + rotate(a_t_b.rotation, place);
}

double distance(const PoseValue& p, const PoseValue& q) { return length(q.position - p.position); }

double turn(const PoseValue& p, const PoseValue& q) {
  const Quaternion way = between(p.rotation, q.rotation);
  return rounded(2 * std::atan2(length(axis_part(way)), way.w));
}

std::optional<PoseValue> mix(const PoseValue& p, const PoseValue& q, double t) {
  constexpr double kOpposite = 1e-12;  // [choice] as in to_fixed()
  const Quaternion way = between(p.rotation, q.rotation);
  if (way.w < kOpposite) return std::nullopt;
  const double sine = length(axis_part(way));
  const double angle = std::atan2(sine, way.w);
  Quaternion part;
  if (sine > 0) {
    const Vector3 axis = (std::sin(t * angle) / sine) * axis_part(way);
    part = {std::cos(t * angle), axis.x, axis.y, axis.z};
  }
  const Vector3 way_there = q.position - p.position;
  // From the nearer end, so that t = 1 gives q to the bit.
  const Vector3 place = t < 0.5 ? p.position + t * way_there : q.position - (1 - t) * way_there;
  return PoseValue{{place.x + 0.0, place.y + 0.0, place.z + 0.0}, turn_product(p.rotation, part)};
}

std::optional<PoseValue> frame_through(const Vector3& origin, const Vector3& on_x,
                                       const Vector3& on_xy) {
  constexpr double kOnALine = 1e-9;  // [choice] rad: a micrometre over a kilometre
  const Vector3 along = on_x - origin;
  const Vector3 aside = on_xy - origin;
  const double along_length = length(along);
  const double aside_length = length(aside);
  if (along_length == 0 || aside_length == 0) return std::nullopt;
  const Vector3 x{along.x / along_length, along.y / along_length, along.z / along_length};
  const Vector3 normal =
      cross(x, {aside.x / aside_length, aside.y / aside_length, aside.z / aside_length});
  const double sine = length(normal);
  if (!(sine > kOnALine)) return std::nullopt;
  const Vector3 z{normal.x / sine, normal.y / sine, normal.z / sine};
  return PoseValue{origin, from_axes(x, cross(z, x), z)};
}

bool is_finite(const PoseValue& pose) {
  // A sum of seven is finite only if all are; that it is not can be an overflow of the sum alone.
  const auto& [position, rotation] = pose;
  const double sum =
      position.x + position.y + position.z + rotation.w + rotation.i + rotation.j + rotation.k;
  if (std::isfinite(sum)) return true;
  return std::isfinite(position.x) && std::isfinite(position.y) && std::isfinite(position.z) &&
         std::isfinite(rotation.w) && std::isfinite(rotation.i) && std::isfinite(rotation.j) &&
         std::isfinite(rotation.k);
}

}  // namespace rob::lang::pose_math
