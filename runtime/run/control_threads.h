#pragma once

#include <atomic>
#include <optional>

#include "runtime/run/controller.h"
#include "runtime/run/execution.h"
#include "runtime/time/clock.h"
#include "runtime/time/periodic_task.h"

namespace rob::runtime {

/// s before the clock begins, in which every thread wakes up. [choice]
inline constexpr double kThreadLead = 0.02;

/// The threads that keep a robot under control in real time: servo, motion, and the path ahead.
class ControlThreads {
 public:
  /// Makes the threads, which wait for begin(). Throws std::system_error where the system permits
  /// no more of them; so the robot is enabled only when they are there.
  explicit ControlThreads(Controller& controller);
  ~ControlThreads();
  ControlThreads(const ControlThreads&) = delete;
  ControlThreads& operator=(const ControlThreads&) = delete;

  /// The controller has been enabled at −kThreadLead and prepared; its time begins here.
  void begin();
  /// After begin(): waits until motion is over, which has been asked for, and ends the other two.
  /// Once.
  Timing finish();

 private:
  Controller& controller_;
  SystemClock clock_;
  StartLine line_;
  bool begun_ = false;
  std::atomic<bool> stopping_{false};
  std::optional<double> first_;  ///< when the first cycle began, s
  double drift_ = 0;             ///< s
  PeriodicTask servo_;
  PeriodicTask motion_;
  PeriodicTask path_;
  std::optional<PeriodicTask> jogs_;  ///< where there is something to be hit
};

}  // namespace rob::runtime
