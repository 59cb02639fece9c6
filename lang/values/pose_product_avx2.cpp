#if defined(__x86_64__)
#include <immintrin.h>

#include "lang/values/pose_functions.h"

/// product() four components at a time, to the same bits: nothing is contracted to a fused
/// multiply-add, which other machines would not have.
namespace rob::lang::pose_functions {
namespace {

#define ROB_AVX2 __attribute__((target("avx2")))

using Four = __m256d;

ROB_AVX2 inline Four four(const Slot* slots) { return _mm256_loadu_pd(&slots->real); }
ROB_AVX2 inline Four all(double value) { return _mm256_set1_pd(value); }
ROB_AVX2 inline Four plus(Four a, Four b) { return _mm256_add_pd(a, b); }
ROB_AVX2 inline Four minus(Four a, Four b) { return _mm256_sub_pd(a, b); }
ROB_AVX2 inline Four times(Four a, Four b) { return _mm256_mul_pd(a, b); }
ROB_AVX2 inline Four negated(Four a, Four signs) { return _mm256_xor_pd(a, signs); }

/// Components a, b, c, d of v.
template <int a, int b, int c, int d>
ROB_AVX2 inline Four picked(Four v) {
  return _mm256_permute4x64_pd(v, a | b << 2 | c << 4 | d << 6);
}

/// In each component the sum of all, in the order of pose_math.cpp.
ROB_AVX2 inline Four sum(Four v) {
  const Four halves = plus(v, _mm256_permute2f128_pd(v, v, 1));
  return plus(halves, _mm256_permute_pd(halves, 0b0101));
}

/// x, y, z and nothing: a place is stored in two parts, and is fetched so.
ROB_AVX2 inline Four place(const Slot* slots) {
  return _mm256_insertf128_pd(_mm256_castpd128_pd256(_mm_loadu_pd(&slots->real)),
                              _mm_load_sd(&slots[2].real), 1);
}

ROB_AVX2 inline Four turn_product(const Slot* p_slots, Four p, Four q) {
  const Four none = _mm256_setzero_pd();
  const Four squares = times(sum(times(p, p)), times(all(0.5), sum(times(q, q))));
  const Four w = times(all(p_slots[0].real), q);
  const Four k =
      times(all(p_slots[3].real), negated(picked<3, 2, 1, 0>(q), _mm256_setr_pd(-0.0, -0.0, 0, 0)));
  const Four i = times(all(p_slots[1].real),
                       negated(_mm256_permute_pd(q, 0b0101), _mm256_setr_pd(-0.0, 0, -0.0, 0)));
  const Four j =
      times(all(p_slots[2].real), negated(picked<2, 3, 0, 1>(q), _mm256_setr_pd(-0.0, 0, 0, -0.0)));
  return times(plus(plus(plus(none, w), k), plus(i, j)), minus(all(1.5), squares));
}

/// v turned by the rotation q.
ROB_AVX2 inline Four turned(Four q, double w, Four v) {
  const Four s = times(all(2), minus(all(2), sum(times(q, q))));
  const Four ijk = picked<1, 2, 3, 0>(q);
  const Four jki = picked<2, 3, 1, 0>(q);
  const Four kij = picked<3, 1, 2, 0>(q);
  const Four across = times(ijk, jki);                // ij jk ki
  const Four about = times(all(w), kij);              // wk wi wj
  const Four below = times(plus(across, about), s);   // yx zy xz
  const Four above = times(minus(across, about), s);  // xy yz zx
  const Four diagonal = minus(all(1), times(plus(times(jki, jki), times(kij, kij)), s));
  return plus(plus(times(diagonal, v), times(above, picked<1, 2, 0, 3>(v))),
              times(picked<2, 0, 1, 3>(below), picked<2, 0, 1, 3>(v)));
}

ROB_AVX2 inline bool finite(Four place) {
  const Four nothing = minus(place, place);
  return (_mm256_movemask_pd(_mm256_cmp_pd(nothing, nothing, _CMP_UNORD_Q)) & 0b111) == 0;
}

}  // namespace

ROB_AVX2 Error product_in_fours(const Slot* p, const Slot* q, Slot* result) {
  const Four rotation = four(p + 3);
  const Four to = plus(place(p), turned(rotation, p[3].real, place(q)));
  if (!finite(to)) return Error::NotFinite;
  _mm256_storeu_pd(&result[3].real, turn_product(p + 3, rotation, four(q + 3)));
  _mm_storeu_pd(&result[0].real, _mm256_castpd256_pd128(to));
  _mm_store_sd(&result[2].real, _mm256_extractf128_pd(to, 1));
  return Error::None;
}

}  // namespace rob::lang::pose_functions
#endif
