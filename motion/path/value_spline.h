#pragma once

#include <vector>

namespace rob::motion {

/// A number along a parameter: the cubic spline through values, twice continuously differentiable,
/// without a second derivative at its ends, beyond which it goes on evenly.
class ValueSpline {
 public:
  /// Two values or more, at rising places.
  ValueSpline(std::vector<double> places, std::vector<double> values);

  double at(double place) const noexcept;

 private:
  std::vector<double> places_;
  std::vector<double> values_;
  std::vector<double> bends_;  ///< the second derivatives
};

}  // namespace rob::motion
