#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "motion/robots/robot_model.h"
#include "runtime/tick/channels.h"

namespace rob::runtime {

/// The motion of a run, row by row, for curves: as many rows as a page has room for. When there are
/// more every second one is left out. SI.
class RunCurves {
 public:
  static constexpr std::size_t kMostRows = 6000;  ///< a minute at 100 Hz

  struct Row {
    motion::JointReference reference;
    motion::JointVector measured;
    Eigen::Vector3d tool = Eigen::Vector3d::Zero();           ///< the flange by the reference
    Eigen::Vector3d tool_measured = Eigen::Vector3d::Zero();  ///< as it was measured
    double speed = 0;                                         ///< of the flange, m/s
    double override_share = 1;
    double lateness = 0;  ///< s
    motion::Wrench wrench;
    int line = 0;  ///< a lang::line_tag()
  };

  explicit RunCurves(const motion::RobotModel& robot) : robot_(robot) {}

  void take(const Snapshot& snapshot);
  /// The rows that are kept, and the last one of the run.
  std::vector<Row> rows() const;
  /// One of so many rows is kept.
  std::int64_t every() const { return every_; }

 private:
  const motion::RobotModel& robot_;
  std::vector<Row> rows_;
  std::optional<Row> last_;
  std::int64_t every_ = 1;
  std::int64_t taken_ = 0;
};

}  // namespace rob::runtime
