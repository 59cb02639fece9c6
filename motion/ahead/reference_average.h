#pragma once

#include <vector>

#include "motion/ahead/guide.h"

namespace rob::motion {

/// The references: the mean of the guide over its last periods. Place, speed and acceleration stay
/// within every bound that the guide keeps, since they are means of what does, and the jerk within
/// (greatest − least acceleration)/(time of the mean), whatever the guide does (motion.md, jerk).
///
/// It is taken of the axes where the tool's way is straight in them: then straight lines stay
/// straight. Else of σ, so that the path itself is kept. The reference lags by half the mean.
///
/// m, rad, s. The constructor alone takes memory.
class ReferenceAverage {
 public:
  /// [choice] A robot of 1 kHz can have a mean of 4 s, more than any motion takes to speed up.
  static constexpr int kMost = 4096;

  ReferenceAverage(const PathRing& ring, const JointVector& start);

  /// Call it while the guide stands before a run. `periods`: of the run's mean, 1 … kMost.
  /// `of_sigma`: the mean averages σ; otherwise it averages the axes.
  void begin_run(int periods, bool of_sigma, const Guide& guide) noexcept;
  int periods() const noexcept { return periods_; }
  /// Once a period, after Guide::step().
  void take(const Guide& guide) noexcept;

  /// The axes: place, velocity and acceleration in time.
  const PathPoint& mean() const noexcept { return mean_; }
  /// The same of σ.
  double sigma() const noexcept { return sigma_; }
  double rate() const noexcept { return rate_; }
  /// The guide's state some periods ago, as one sample of the mean.
  struct GuideState {
    double sigma = 0;
    double rate = 0;
  };
  /// `periods`: less than periods().
  GuideState past(int periods) const noexcept {
    const int at = newest_ - periods;
    const Sample& sample = samples_[static_cast<std::size_t>(at < 0 ? at + periods_ : at)];
    return {sample.sigma, sample.rate};
  }
  /// The guide has stood for so long that the references do.
  bool stands() const noexcept { return still_ >= periods_; }
  /// Pieces before this one are not needed any more, not by the guide either, which is ahead.
  PathRing::Index oldest() const noexcept { return piece_ == 0 ? 0 : piece_ - 1; }

 private:
  struct Sample {
    double sigma = 0;
    double rate = 0;
    double acceleration = 0;
    PathPoint axes;
  };
  static Sample sample_of(const Guide& guide) noexcept;
  void average_axes() noexcept;
  void average_sigma(const Guide& guide) noexcept;

  bool of_sigma_ = false;
  const PathRing& ring_;
  std::vector<Sample> samples_;
  int periods_ = 1;
  int newest_ = 0;
  int still_ = 1;  ///< the last samples that are alike
  PathRing::Index piece_ = 0;
  PathPoint mean_;
  double sigma_ = 0;
  double rate_ = 0;
};

}  // namespace rob::motion
