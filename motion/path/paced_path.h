#pragma once

#include <utility>
#include <vector>

#include "motion/path/joint_path.h"
#include "motion/path/tool_path.h"

namespace rob::motion {

/// A law of time for a path's parameter s, 0 … 1, that passes each place at its own rate: s(t) has
/// an even acceleration between the places, and is then averaged over a time. 1, s.
class PaceLaw {
 public:
  /// Where a place is, and its rate there, 1/s, above 0.
  struct Place {
    double s = 0;
    double rate = 0;
  };
  /// Two places or more, from 0 to 1. `average`: s.
  PaceLaw(const std::vector<Place>& places, double average);

  double duration() const noexcept { return points_.back().time; }
  double average() const noexcept { return average_; }

  /// The mean's s, s' and s'' at a time. For the mean, s goes on beyond its ends mirrored, so that
  /// it begins at 0 and ends at 1.
  struct Point {
    double s = 0;
    double rate = 0;
    double acceleration = 0;
  };
  Point at(double time) const noexcept;
  /// When the mean is at s.
  double time_at(double s) const noexcept;
  double greatest_rate() const noexcept { return greatest_; }

 private:
  struct Instant {
    double time = 0;
    double s = 0;
    double rate = 0;
    double sum = 0;  ///< of s over the time
  };
  Instant without_mean(double time) const noexcept;

  std::vector<Instant> points_;
  double average_ = 0;
  double greatest_ = 0;
};

/// A path of the tool whose parameter, 0 … 1, is a share of the time that a PaceLaw gives it.
class PacedPath final : public ToolPath {
 public:
  /// The path must outlive it.
  PacedPath(const ToolPath& path, PaceLaw law) : path_(path), law_(std::move(law)) {}

  Pose at(double s) const noexcept override { return path_.at(inner(s)); }
  double way() const noexcept override { return path_.way(); }
  double turn() const noexcept override { return path_.turn(); }
  double greatest_speed() const noexcept override { return path_.greatest_speed() * steepest(); }
  double greatest_turning() const noexcept override {
    return path_.greatest_turning() * steepest();
  }
  double first_point() const noexcept override { return outer(path_.first_point()); }
  double last_point() const noexcept override { return outer(path_.last_point()); }
  double parts() const noexcept override { return path_.parts(); }
  double at_share(double share) const noexcept override { return outer(path_.at_share(share)); }
  double share_at(double s) const noexcept override { return path_.share_at(inner(s)); }

  /// The axes along this path; `axes` are those along the path without a pace.
  JointPath paced(const JointPath& axes) const;

 private:
  double span() const noexcept { return path_.end() - path_.begin(); }
  double steepest() const noexcept { return law_.greatest_rate() * law_.duration() * span(); }
  double inner(double s) const noexcept;
  double outer(double s) const noexcept;

  const ToolPath& path_;
  PaceLaw law_;
};

}  // namespace rob::motion
