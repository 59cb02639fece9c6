#include "motion/generate/rate_change.h"

#include <algorithm>
#include <cmath>

namespace rob::motion {

RateChange rate_change(const JointVector& missing, const JointVector& acceleration,
                       const JointVector& a_max, const JointVector& j_max, double period) noexcept {
  // A whole number that rounding has made a little greater is itself.
  constexpr double kRounding = 1e-9;
  const JointVector gained = missing * (2 / period) - acceleration;  // a'·(n + 1)
  const double by_acceleration = gained.cwiseQuotient(a_max).cwiseAbs().maxCoeff();
  const double by_jerk = gained.cwiseQuotient(j_max).cwiseAbs().maxCoeff() / period;  // n·(n + 1)
  const double least = std::max(by_acceleration - 1, (std::sqrt(1 + 4 * by_jerk) - 1) / 2);
  const double n = std::max(1.0, std::ceil(least * (1 - kRounding)));

  const JointVector change = gained / (n + 1) - acceleration;
  const double jerk = change.cwiseQuotient(j_max).cwiseAbs().maxCoeff() / period;
  const double step = jerk > 1 ? 1 / jerk : 1;
  return {step * 2 / (period * (n + 1)), 1 - step * (1 + 1 / (n + 1))};
}

}  // namespace rob::motion
