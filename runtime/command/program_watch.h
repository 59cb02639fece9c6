#pragma once

#include <vector>

#include "lang/code/watch.h"
#include "lang/machine/robot_signature.h"
#include "motion/plan/motion_request.h"
#include "motion/plan/watch.h"
#include "motion/robots/robot_model.h"

namespace rob::runtime {

/// AT LIVE, and what its value is of.
struct ProgramPace {
  motion::LivePace pace;
  motion::MotionRequest::Pace means = motion::MotionRequest::Pace::Unspecified;
};

/// A condition or a pace of the program, as motion asks it: joins the language's code with the
/// world of a control cycle. The program's thread sets it before motion hears of it; the tick alone
/// asks it.
class ProgramWatch {
 public:
  /// `signals`: by the number that the language names. Both must outlive it.
  ProgramWatch(const std::vector<lang::RobotSignature::Signal>& signals,
               const motion::RobotModel& robot)
      : signals_(signals), robot_(robot) {}

  /// `dimension`: of a number that it computes.
  void set(const lang::Watch& watch, lang::Dimension dimension = {}) {
    watch_ = watch;
    dimension_ = dimension;
  }
  /// Where it stands in the program.
  lang::Place written() const { return watch_.chunk->places[watch_.form.end - 1]; }
  /// Stays valid as long as this object.
  motion::Watch handle() const { return {&ProgramWatch::test, this}; }
  /// The same of what computes a number, in SI.
  motion::LivePace pace() const { return {&ProgramWatch::value, this}; }
  /// Why it could not be computed; to be read when the Rest that says so has been taken.
  lang::ArithmeticError error() const { return error_; }

 private:
  static motion::WatchAnswer test(const void* self, const motion::CycleView& view) noexcept;
  static double value(const void* self, const motion::CycleView& view) noexcept;
  lang::WatchResult evaluate(const motion::CycleView& view) const noexcept;

  const std::vector<lang::RobotSignature::Signal>& signals_;
  const motion::RobotModel& robot_;
  lang::Watch watch_;
  lang::Dimension dimension_;
  mutable lang::ArithmeticError error_ = lang::ArithmeticError::None;
};

}  // namespace rob::runtime
