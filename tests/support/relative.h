#pragma once

#include <doctest/doctest.h>

namespace rob::test {

/// Equal to a share of the value. doctest::Approx alone adds 1 to the value before it takes the
/// share: of lengths in m it would accept almost anything. Nothing but 0 itself is near 0.
inline doctest::Approx relative(double expected, double share = 1e-9) {
  return doctest::Approx(expected).epsilon(share).scale(expected == 0 ? 1e-300 : 0);
}

}  // namespace rob::test
