#include <cmath>
#include <cstring>

#include "lang/values/pose_functions.h"

/// The product of two poses, made for the Vm: what pose_math::compose() computes, to the bit.
namespace rob::lang::pose_functions {
namespace {

// In a loop each product waits for the one before, so what counts is how long the way from the old
// rotation to the new one is. Two components at a time; signs and halves are put where nothing
// waits for them, which changes no bit. The sums are in the order of pose_math.cpp, to the bit.
using Pair = double __attribute__((vector_size(16)));  // an extension that g++ and clang share

Pair pair(const Slot* slots) {
  Pair both;
  std::memcpy(&both, slots, sizeof both);
  return both;
}
Pair twice(double value) { return Pair{value, value}; }
Pair swapped(Pair v) { return Pair{v[1], v[0]}; }
void store(Pair value, Slot* slots) { std::memcpy(slots, &value, sizeof value); }

struct Rotation {
  double w, i, j, k;
};

/// The product of two unit quaternions, as long as 1 again by a Newton step: q · (3 - |q|²) / 2.
void store_rotation(const Rotation& p, const Slot* q, Slot* result) {
  constexpr Pair kFirst{-1, 1};
  constexpr Pair kSecond{1, -1};
  const Pair wi = pair(q);
  const Pair jk = pair(q + 2);
  Pair left = twice(p.w) * wi + twice(p.i) * (kFirst * swapped(wi)) + twice(p.j) * (kFirst * jk) -
              twice(p.k) * swapped(jk);
  Pair right = twice(p.w) * jk + twice(p.i) * (kFirst * swapped(jk)) + twice(p.j) * (kSecond * wi) +
               twice(p.k) * swapped(wi);
  const Pair left_squares = left * left;
  const Pair right_squares = right * right;
  const double squares = left_squares[0] + left_squares[1] + right_squares[0] + right_squares[1];
  left = left * twice(0.5) * twice(3 - squares);
  right = right * twice(0.5) * twice(3 - squares);
  const auto zero = (left == twice(0)) | (right == twice(0));
  if ((zero[0] | zero[1]) != 0) {  // it may be -0; a sum for all would be one to wait for
    left += twice(0);
    right += twice(0);
  }
  store(left, result);
  store(right, result + 2);
}

/// The place p, and v turned by a rotation, as in pose_math::rotate(). False if it is not finite:
/// places can grow, rotations cannot.
bool store_place(const Slot* p, const Rotation& q, const Slot* v, Slot* result) {
  const Pair wi{q.w, q.i};
  const Pair jk{q.j, q.k};
  const Pair squares = wi * wi;
  const Pair more_squares = jk * jk;
  const Pair wk_ij = wi * swapped(jk);
  const Pair wj_ik = wi * jk;
  const double jj = more_squares[0];
  const double kk = more_squares[1];
  const double sum = squares[0] + squares[1];
  const double difference = squares[0] - squares[1];
  const Pair s = twice(2 - (sum + jj + kk));
  const Pair x{sum - jj - kk, 2 * (wk_ij[1] + wk_ij[0])};
  const Pair y{2 * (wk_ij[1] - wk_ij[0]), difference + jj - kk};
  const Pair z = twice(2) * Pair{wj_ik[1] + wj_ik[0], q.j * q.k - q.w * q.i};
  const Pair xy =
      pair(p) + (x * s * twice(v[0].real) + y * s * twice(v[1].real) + z * s * twice(v[2].real));
  const Pair across = twice(2) * Pair{wj_ik[1] - wj_ik[0], q.j * q.k + q.w * q.i} * s * pair(v);
  const double height =
      p[2].real + (across[0] + across[1] + (difference - jj + kk) * s[0] * v[2].real);
  if (!std::isfinite(xy[0] + xy[1] + height) &&
      !(std::isfinite(xy[0]) && std::isfinite(xy[1]) && std::isfinite(height))) {
    return false;
  }
  store(xy, result);
  result[2].real = height;
  return true;
}

}  // namespace

Error product(const Slot* p, const Slot* q, Slot* result) {
  const Rotation turned{p[3].real, p[4].real, p[5].real, p[6].real};
  store_rotation(turned, q + 3, result + 3);
  return store_place(p, turned, q, result) ? Error::None : Error::NotFinite;
}

}  // namespace rob::lang::pose_functions
