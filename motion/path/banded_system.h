#pragma once

#include <Eigen/Core>
#include <algorithm>
#include <array>
#include <cstddef>
#include <vector>

namespace rob::motion {

/// Normal equations of rows with up to four neighbouring unknowns, solved by LDLᵀ in the band.
class BandedSystem {
 public:
  /// How far apart two unknowns of one row may be.
  static constexpr std::size_t kWidth = 3;

  explicit BandedSystem(std::size_t unknowns)
      : matrix_(unknowns, Band{}), right_(unknowns, Eigen::Vector3d::Zero()) {}

  /// For the term factor · (Σ coefficients·x − value)²: the coefficients of the unknowns i and j <=
  /// i.
  void add(std::size_t i, std::size_t j, double value) { matrix_[i][i - j] += value; }
  void add_right(std::size_t i, const Eigen::Vector3d& value) { right_[i] += value; }

  std::vector<Eigen::Vector3d>& solve() {
    factorize();
    const std::size_t n = matrix_.size();
    for (std::size_t i = 0; i < n; ++i)
      for (std::size_t d = 1; d <= std::min(i, kWidth); ++d)
        right_[i] -= matrix_[i][d] * right_[i - d];
    for (std::size_t i = 0; i < n; ++i) right_[i] /= matrix_[i][0];
    for (std::size_t i = n; i-- > 0;)
      for (std::size_t d = 1; d <= kWidth && i + d < n; ++d)
        right_[i] -= matrix_[i + d][d] * right_[i + d];
    return right_;
  }

 private:
  using Band = std::array<double, kWidth + 1>;

  void factorize() {
    constexpr double kLeastPivot = 1e-14;  // where nothing holds a control
    for (std::size_t i = 0; i < matrix_.size(); ++i) {
      for (std::size_t d = std::min(i, kWidth) + 1; d-- > 0;) {
        const std::size_t j = i - d;
        double value = matrix_[i][d];
        for (std::size_t e = d + 1; e <= kWidth && e <= i; ++e)
          value -= matrix_[i][e] * matrix_[j][e - d] * matrix_[i - e][0];
        matrix_[i][d] = d == 0 ? std::max(value, kLeastPivot) : value / matrix_[j][0];
      }
    }
  }

  std::vector<Band> matrix_;  ///< [i][d]: of the unknowns i and i − d
  std::vector<Eigen::Vector3d> right_;
};

}  // namespace rob::motion
