#pragma once

#include <memory>
#include <vector>

#include "motion/path/joint_path.h"
#include "motion/path/tool_path.h"

namespace rob::motion {

/// When a path's parameter s, 0 … 1, is where, if each place is passed at its own rate: s(t), with
/// even accelerations between its points, and the mean of that over a time. 1, s.
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

  /// Of the mean: s, s' and s'' at a time. At its ends s goes on as it came, mirrored, so that they
  /// stay where they are.
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

/// A path of the tool whose parameter, 0 … 1, is a share of the time in which it is gone at the
/// rates of a PaceLaw.
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

  /// The axes along the path, `axes` as they are along it without a pace, so that they follow this.
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
