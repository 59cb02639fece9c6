#pragma once

#include <optional>
#include <vector>

#include "motion/robots/robot_model.h"
#include "runtime/tick/channels.h"

namespace rob::runtime {

/// The way of the flange in a run, as polylines for a picture. Between two references the axes
/// follow the quintic through both, as the servo does. No point of the way is farther from the
/// polyline than kMiss. m; in the world.
class ToolWay {
 public:
  static constexpr double kMiss = 8e-6;  ///< m [choice] a picture of 0.01 mm, less its own rounding

  /// The motion for one line, without a break.
  struct Stretch {
    int line = 0;                          ///< a lang::line_tag()
    double begins = 0;                     ///< s
    double ends = 0;                       ///< s
    std::vector<Eigen::Vector3d> corners;  ///< of its polyline: at least two
  };

  explicit ToolWay(const motion::RobotModel& robot) : robot_(robot) {}

  /// The place that a motion was programmed to go to.
  struct Target {
    int line = 0;
    Eigen::Vector3d place = Eigen::Vector3d::Zero();
  };

  /// The next reference of the run.
  void take(const Snapshot& snapshot);
  /// A motion has begun that was programmed to go to these axis values.
  void aim(const motion::JointVector& target, int line) {
    targets_.push_back({line, place_at(target)});
  }
  const std::vector<Target>& targets() const { return targets_; }
  /// All of it so far, in the order of time. A motion that is shorter than a period may have none.
  const std::vector<Stretch>& stretches() const { return stretches_; }
  /// Where the flange was at a time, s; at the start before the run.
  Eigen::Vector3d at(double time) const;

 private:
  using Place = Eigen::Vector3d;

  Place place_at(const motion::JointVector& q) const {
    return robot_.kinematics->forward(q).position;
  }
  void begin(int line);
  void divide(const motion::JointReference& next, double from, const Place& start, double to,
              const Place& end, int depth);
  void add(double time, const Place& place);
  bool lies_on_chord(const Place& end) const;

  const motion::RobotModel& robot_;
  std::optional<motion::JointReference> last_;
  Place place_ = Place::Zero();  ///< of last_
  std::vector<Stretch> stretches_;
  std::vector<Target> targets_;
  std::vector<Place> between_;  ///< the last corner of the polyline, and what came after it
};

}  // namespace rob::runtime
