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

double added(Pair v) { return v[0] + v[1]; }

/// The product of two rotations, as long as 1 again by a Newton step: p·q·(3 - |p|²·|q|²)/2. A
/// zero in it is no -0: the sum that begins with one is none.
void store_rotation(const Slot* p, const Slot* q, Slot* result) {
  constexpr Pair kSigns{-1, 1};
  const Pair wi = pair(q);
  const Pair jk = pair(q + 2);
  const double half_squares = 0.5 * added(wi * wi + jk * jk);
  const double squares = added(pair(p) * pair(p) + pair(p + 2) * pair(p + 2));
  const Pair length = twice(1.5 - squares * half_squares);
  const Pair pw = twice(p[0].real);
  const Pair pi = twice(p[1].real);
  const Pair pj = twice(p[2].real);
  const Pair pk = twice(p[3].real);
  const Pair left =
      ((twice(0) + pw * wi) - pk * swapped(jk)) + kSigns * (pi * swapped(wi) + pj * jk);
  const Pair right =
      ((twice(0) + pw * jk) + pk * swapped(wi)) + kSigns * (pi * swapped(jk) - pj * wi);
  store(left * length, result);
  store(right * length, result + 2);
}

/// The place p, and v turned by a rotation, as in pose_math::rotate(). False if it is not finite:
/// places can grow, rotations cannot.
bool store_place(const Slot* p, Pair wi, Pair jk, const Slot* v, Slot* result) {
  const Pair squares = jk * jk;
  const Pair more = wi * wi;
  const Pair s = twice(2) * twice(2 - added(more + squares));
  const Pair w = twice(wi[0]);
  const Pair i = twice(wi[1]);
  const Pair ij_ik = i * jk;
  const Pair wk_wj = w * swapped(jk);
  const Pair sums = (ij_ik + wk_wj) * s;                                     // yx, xz
  const Pair differences = (ij_ik - wk_wj) * s;                              // xy, zx
  const Pair diagonal = twice(1) - (twice(more[1]) + swapped(squares)) * s;  // yy, zz
  const double jk_product = jk[0] * jk[1];
  const double wi_product = wi[0] * wi[1];
  const double yz = (jk_product - wi_product) * s[0];
  const double zy = (jk_product + wi_product) * s[0];
  const double xx = 1 - added(squares) * s[0];
  const double x = p[0].real + (xx * v[0].real + differences[0] * v[1].real + sums[1] * v[2].real);
  const Pair across = pair(p + 1) + (diagonal * pair(v + 1) +
                                     Pair{yz, differences[1]} * Pair{v[2].real, v[0].real} +
                                     Pair{sums[0], zy} * pair(v));
  if (!std::isfinite(x + across[0] + across[1]) &&
      !(std::isfinite(x) && std::isfinite(across[0]) && std::isfinite(across[1]))) {
    return false;
  }
  result[0].real = x;
  store(across, result + 1);
  return true;
}

}  // namespace

/// Where it fails, what lies in `result` stays: it may be p or q.
Error product_in_pairs(const Slot* p, const Slot* q, Slot* result) {
  const Pair wi = pair(p + 3);
  const Pair jk = pair(p + 5);
  const Pair earlier_wi = pair(result + 3);
  const Pair earlier_jk = pair(result + 5);
  store_rotation(p + 3, q + 3, result + 3);
  if (store_place(p, wi, jk, q, result)) return Error::None;
  store(earlier_wi, result + 3);
  store(earlier_jk, result + 5);
  return Error::NotFinite;
}

#if defined(__x86_64__)
Error (*const product)(const Slot*, const Slot*, Slot*) = __builtin_cpu_supports("avx2") != 0
                                                              ? product_in_fours
                                                              : product_in_pairs;
#else
Error (*const product)(const Slot*, const Slot*, Slot*) = product_in_pairs;
#endif

}  // namespace rob::lang::pose_functions
