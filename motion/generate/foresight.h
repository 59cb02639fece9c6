#pragma once

#include <optional>
#include <vector>

#include "motion/ahead/guide.h"
#include "motion/ahead/reference_average.h"
#include "motion/generate/reference_mark.h"

namespace rob::motion {

/// Where the references of look-ahead motion will be: the mean of a second guide, which is stepped
/// on from where the first one is. It comes true as long as override, pace and what is known of the
/// path stay as they are.
///
/// The mean passes a place after the guide, and before the guide's samples are all beyond it: so
/// the second guide is sampled only there, two means' time at most.
///
/// Times are the guide's, s. The constructor alone takes memory.
class Foresight {
 public:
  /// The furthest that it looks, s: the longest LEAD.
  static constexpr double kFurthest = 0.5;

  /// `period`: of the references, s.
  Foresight(const Guide& guide, const ReferenceAverage& average, double period);

  struct Place {
    double sigma = 0;
    double within = 0;  ///< s from now on, at most kFurthest
  };
  /// The outlook on one place, from look to look.
  struct Outlook {
    double guide_passes = 0;
    double again = 0;  ///< the next look
  };
  /// When the references, which are at `now`, will pass a place that they have not reached; none if
  /// that is not foreseen within its time.
  std::optional<double> when(const ReferenceMark& now, const Place& place,
                             Outlook& outlook) noexcept;

 private:
  using GuideState = ReferenceAverage::GuideState;

  double look(const ReferenceMark& now, double sigma, double passes) noexcept;
  ReferenceMark begin_mean(const ReferenceMark& now, Guide& second, int period) noexcept;
  ReferenceMark next_mean(const ReferenceMark& last, Guide& second) noexcept;

  const Guide& guide_;
  const ReferenceAverage& average_;
  const double period_;
  std::vector<GuideState> samples_;  ///< of the second guide, of a mean's time
  int oldest_ = 0;                   ///< of them
};

}  // namespace rob::motion
