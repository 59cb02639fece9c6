#include "motion/generate/reference_mark.h"

#include <cmath>

namespace rob::motion {

namespace {

/// σ on the cubic through both marks, at a share of their time.
double between(const ReferenceMark& a, const ReferenceMark& b, double share) noexcept {
  const double T = b.time - a.time;
  const double left = 1 - share;
  return a.sigma + share * share * (3 - 2 * share) * (b.sigma - a.sigma) +
         share * left * T * (left * a.rate - share * b.rate);
}

}  // namespace

double passing_time(const ReferenceMark& before, const ReferenceMark& after,
                    double sigma) noexcept {
  if (before.sigma >= sigma) return before.time;
  double low = 0;
  double high = 1;
  for (int i = 0; i < 50; ++i) {  // 50 halvings: below 1e-15
    const double middle = (low + high) / 2;
    (between(before, after, middle) < sigma ? low : high) = middle;
  }
  return before.time + high * (after.time - before.time);
}

bool reaches(const ReferenceMark& mark, double sigma) noexcept {
  return mark.sigma >= sigma - 1e-12 * (1 + std::abs(sigma));
}

}  // namespace rob::motion
