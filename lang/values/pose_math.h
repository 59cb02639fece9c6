#pragma once

#include <optional>

/// The geometry of poses: plain functions on plain values, for the checker, which folds constants,
/// and for the Vm. Lengths are in one unit, mm or m, angles in rad. None takes memory.
///
/// A frame B seen from A is written a_T_b; compose(a_T_b, b_T_c) is a_T_c. Angles a, b, c turn
/// about the fixed axes x, y, z in this order: R = Rz(c)·Ry(b)·Rx(a).
///
/// Rotations by multiples of 90 degrees are exact, and so are their products: an axis that is
/// turned onto another leaves no 1e-17 on the third. Nothing here looks for overflow; is_finite()
/// does.
namespace rob::lang {

struct Vector3 {
  double x = 0;
  double y = 0;
  double z = 0;

  bool operator==(const Vector3&) const = default;
};

/// A rotation as a quaternion w + i·i + j·j + k·k, of length 1 but for rounding; q and -q are the
/// same rotation.
struct Quaternion {
  double w = 1;
  double i = 0;
  double j = 0;
  double k = 0;

  bool operator==(const Quaternion&) const = default;
};

struct PoseValue {
  Vector3 position;
  Quaternion rotation;

  bool operator==(const PoseValue&) const = default;
};

/// Angles about the fixed axes x, y, z.
struct FixedAngles {
  double a = 0;
  double b = 0;
  double c = 0;
};

namespace pose_math {

Quaternion from_fixed(const FixedAngles& angles);
/// R = Rz(alpha)·Ry(beta)·Rz(gamma).
Quaternion from_zyz(double alpha, double beta, double gamma);
/// To length 1; nothing for zero.
std::optional<Quaternion> normalized(const Quaternion& q);
/// -90° <= b <= 90°, a and c in (-180°, 180°]; where b is ±90° only their sum or difference counts,
/// and a is 0. Rounded to 1e-12 degrees, as the literal of that many degrees would be: the angles
/// that a pose was made from come back to the bit, although sines and square roots lie between.
FixedAngles to_fixed(const Quaternion& q);

Vector3 operator+(const Vector3& a, const Vector3& b);
Vector3 operator-(const Vector3& a, const Vector3& b);
Vector3 operator*(double s, const Vector3& v);
double dot(const Vector3& a, const Vector3& b);
Vector3 cross(const Vector3& a, const Vector3& b);
/// Without overflow between.
double length(const Vector3& v);

/// `v` with its direction turned.
Vector3 rotate(const Quaternion& q, const Vector3& v);
PoseValue compose(const PoseValue& a_t_b, const PoseValue& b_t_c);
PoseValue inverse(const PoseValue& a_t_b);
/// A place given in b, seen from a.
Vector3 transform(const PoseValue& a_t_b, const Vector3& place);

double distance(const PoseValue& p, const PoseValue& q);
/// The angle of the shortest rotation from p to q, 0 to 180°; rounded as in to_fixed().
double turn(const PoseValue& p, const PoseValue& q);
/// On the line from p to q, turning by the shortest rotation: p for t = 0, q for t = 1; other t go
/// on beyond. Nothing if the two are 180° apart (within 1e-10°), where there is no shortest one.
std::optional<PoseValue> mix(const PoseValue& p, const PoseValue& q, double t);
/// The frame with its origin in `origin`, its x axis through `on_x`, and `on_xy` in the half of its
/// xy plane where y > 0. Nothing if the three places lie on a line (within 1e-9 of their distance).
std::optional<PoseValue> frame_through(const Vector3& origin, const Vector3& on_x,
                                       const Vector3& on_xy);

bool is_finite(const PoseValue& pose);

}  // namespace pose_math
}  // namespace rob::lang
