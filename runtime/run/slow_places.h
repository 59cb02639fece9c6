#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "motion/generate/trajectory_generator.h"
#include "motion/robots/robot_model.h"
#include "runtime/command/program_log.h"
#include "runtime/run/run_result.h"

namespace rob::runtime {

/// Finds where a path under the look-ahead law is gone much slower than asked for, and what holds
/// it there. Looked at are the places where the speed is least, between slowing down and speeding
/// up or for a while: not the ways from and to rest. Asked for is what AT and OVER say; of a motion
/// without them, the greatest speed that it reaches. For a line the worst place counts.
class SlowPlaces {
 public:
  /// [choice] below half of what was asked for
  static constexpr double kSlow = 0.5;
  static constexpr std::size_t kMost = 3;

  explicit SlowPlaces(const motion::RobotModel& robot) : robot_(robot) {}

  /// A motion has begun; `way`: since the last reference, of the tool's tip, m.
  void begin(const LoggedSegment& segment);
  /// The next reference.
  void take(const motion::GeneratorSample& sample, double way);
  /// The worst first; at most kMost of them.
  std::vector<SlowPlace> finish();

 private:
  struct Leg {
    int tag = 0;
    motion::LegBounds bounds;
    double most = 0;  ///< m/s: the greatest speed on it
    std::optional<SlowPlace> worst{};
  };
  struct Passed {
    motion::GeneratorSample sample;
    bool moves = false;  ///< along the path, and the tool's tip with it
  };

  void judge(const Passed& next);
  SlowPlace describe() const;
  void find_cause(const Passed& next, SlowPlace& place) const;
  void close_leg();

  const motion::RobotModel& robot_;
  std::optional<Leg> leg_;
  std::optional<Leg> begun_;    ///< counts from the next reference on
  double corner_behind_ = 0;    ///< m that the corner may take of the leg at its beginning
  bool corner_judged_ = false;  ///< that one, on the leg before
  Passed before_;
  Passed last_;
  std::vector<SlowPlace> worst_;
};

/// "axis j4 speed near the wrist singularity".
std::string cause_of(const SlowPlace& place);

}  // namespace rob::runtime
