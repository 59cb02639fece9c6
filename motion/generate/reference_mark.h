#pragma once

namespace rob::motion {

/// σ of the references at an instant of the guide's time, m and s, and its rate.
struct ReferenceMark {
  double time = 0;
  double sigma = 0;
  double rate = 0;
};

/// When `sigma` is passed on the cubic through two marks, a period or less apart: the first's time
/// if it lies before both, the second's if it lies beyond both.
double passing_time(const ReferenceMark& before, const ReferenceMark& after, double sigma) noexcept;

/// Whether the mark lies at `sigma` or beyond, but for the rounding of sums of lengths.
bool reaches(const ReferenceMark& mark, double sigma) noexcept;

}  // namespace rob::motion
