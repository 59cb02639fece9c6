#pragma once

namespace rob {

/// The number's digits to a prime base, mirrored at the point (Halton 1960): 0 … 1, spread evenly.
inline double halton(int number, int base) noexcept {
  double share = 0;
  double digit = 1;
  for (; number > 0; number /= base) {
    digit /= base;
    share += digit * (number % base);
  }
  return share;
}

}  // namespace rob
