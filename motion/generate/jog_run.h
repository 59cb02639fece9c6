#pragma once

#include <optional>

#include "motion/generate/trajectory_generator.h"
#include "motion/generate/velocity_mode.h"
#include "motion/plan/jog_rates.h"
#include "motion/robots/robot_model.h"
#include "motion/space/cycle_instant.h"

namespace rob::motion {

/// A jog under way. It begins at rest, or joins the jog before it, whose state goes on
/// (VelocityMode). Its periods are the run's, and an override or a hold slows its rates and its
/// time. s. Every call but the constructor may be used in the tick.
class JogRun {
 public:
  explicit JogRun(const RobotModel& robot) : mode_(robot), period_(robot.reference_period) {}

  void keep_to(const JogRoom& room) noexcept { mode_.keep_to(room); }
  /// The axes stand at `from`, m, rad.
  void begin(const JogRates& rates, const JointVector& from) noexcept;
  /// The one under way goes on with other rates.
  void join(const JogRates& rates) noexcept;
  /// Whether these can join it now: what follows at the end of its time, or while it comes to rest;
  /// rates in another space, or of another tool, begin at rest.
  bool joins(const JogRates& rates) const noexcept {
    return mode_.takes(rates) && (over() || rates.at_once);
  }

  /// One period on, with this share of its rates. Whether it goes no further, as it did not say
  /// before.
  bool step(double share) noexcept;

  bool over() const noexcept { return done_ >= lasts_ - kSameInstant; }
  bool stands() const noexcept { return mode_.stands(); }
  const JointVector& place() const noexcept { return mode_.reference().q; }
  /// The axis whose end it is near; −1: none.
  int axis_at_end() const noexcept;
  /// The pair that stops it, as JogRoom says; none if it is something else.
  std::optional<int> body() const noexcept {
    if (mode_.limit().kind != JogLimit::Kind::Body) return std::nullopt;
    return mode_.limit().axis;
  }
  /// The reference but its time, and what else a sample says of it. `share`: as in step().
  void sample(double share, bool slowed, GeneratorSample& sample) const noexcept;

 private:
  VelocityMode mode_;
  const double period_;
  double lasts_ = 0;
  double done_ = 0;
  bool stopped_ = false;  ///< it goes no further
};

}  // namespace rob::motion
