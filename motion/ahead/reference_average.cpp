#include "motion/ahead/reference_average.h"

#include <algorithm>
#include <cmath>

namespace rob::motion {

namespace {

/// The error of σ: what sums of a path's lengths leave.
constexpr double kSumRounding = 1e-12;

}  // namespace

ReferenceAverage::ReferenceAverage(const PathRing& ring, const JointVector& start)
    : ring_(ring), samples_(static_cast<std::size_t>(kMost)) {
  const JointVector zero = JointVector::Zero(start.size());
  mean_ = {start, zero, zero};
  for (Sample& sample : samples_) sample.axes = mean_;
}

ReferenceAverage::Sample ReferenceAverage::sample_of(const Guide& guide) noexcept {
  return {guide.sigma(), guide.rate(), guide.acceleration(), guide.place()};
}

void ReferenceAverage::begin_run(int periods, bool of_sigma, const Guide& guide) noexcept {
  of_sigma_ = of_sigma;
  periods_ = std::clamp(periods, 1, kMost);
  const Sample sample = sample_of(guide);
  std::fill_n(samples_.begin(), periods_, sample);
  newest_ = 0;
  still_ = periods_;
  piece_ = guide.index();
  mean_ = sample.axes;
  sigma_ = sample.sigma;
  rate_ = 0;
}

void ReferenceAverage::take(const Guide& guide) noexcept {
  const double before = samples_[static_cast<std::size_t>(newest_)].sigma;
  newest_ = newest_ + 1 == periods_ ? 0 : newest_ + 1;
  samples_[static_cast<std::size_t>(newest_)] = sample_of(guide);
  // A very short motion begins and ends within one period.
  const bool stood = std::abs(guide.sigma() - before) <= kSumRounding * (1 + std::abs(before));
  still_ = !guide.stands() ? 0 : stood ? std::min(still_ + 1, periods_) : 1;
  double sigma = 0;
  double rate = 0;
  for (int i = 0; i < periods_; ++i) {
    const Sample& sample = samples_[static_cast<std::size_t>(i)];
    sigma += sample.sigma - guide.sigma();
    rate += sample.rate;
  }
  sigma_ = guide.sigma() + sigma / periods_;
  rate_ = rate / periods_;
  if (of_sigma_ && periods_ > 1) {
    average_sigma(guide);
  } else {
    average_axes();
    piece_ = guide.index();
  }
}

/// Around the newest sample: at rest the mean is that very place.
void ReferenceAverage::average_axes() noexcept {
  const PathPoint& newest = samples_[static_cast<std::size_t>(newest_)].axes;
  PathPoint sum{JointVector::Zero(newest.q.size()), JointVector::Zero(newest.q.size()),
                JointVector::Zero(newest.q.size())};
  for (int i = 0; i < periods_; ++i) {
    const PathPoint& sample = samples_[static_cast<std::size_t>(i)].axes;
    sum.q += sample.q - newest.q;
    sum.qd += sample.qd;
    sum.qdd += sample.qdd;
  }
  const double share = 1.0 / periods_;
  mean_ = {newest.q + share * sum.q, share * sum.qd, share * sum.qdd};
}

void ReferenceAverage::average_sigma(const Guide& guide) noexcept {
  double acceleration = 0;
  for (int i = 0; i < periods_; ++i)
    acceleration += samples_[static_cast<std::size_t>(i)].acceleration;
  while (piece_ < guide.index()) {
    const Piece& piece = ring_.written(piece_);
    if (sigma_ <= piece.begin + piece.length) break;
    ++piece_;
  }
  if (stands() || ring_.piece(piece_) == nullptr) {
    mean_ = guide.place();
    return;
  }
  const Piece& piece = ring_.written(piece_);
  const double at = std::clamp(sigma_ - piece.begin, 0.0, piece.length);
  mean_ = driven(piece.point(at), rate_, acceleration / periods_);
}

}  // namespace rob::motion
