#pragma once

#include <atomic>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "motion/generate/trajectory_generator.h"
#include "motion/robots/robot_model.h"
#include "runtime/tick/channels.h"
#include "runtime/tick/effects.h"
#include "runtime/tick/force_watch.h"
#include "runtime/tick/inputs.h"
#include "runtime/tick/outputs.h"
#include "runtime/tick/pressing.h"
#include "runtime/tick/retracing.h"
#include "runtime/tick/servo_history.h"
#include "runtime/tick/speed_share.h"
#include "runtime/tick/stopping.h"
#include "runtime/tick/tracks.h"

namespace rob::runtime {

/// One control cycle of motion: takes up what the servo measured, lets effects act, and hands out
/// the next reference. The cycle that starts at k·T makes the reference stamped (k + 1)·T, so that
/// the servo interpolates between two known ones and a cycle late by less than T is not noticed.
///
/// cycle() is the tick: no memory, no lock, no text, bounded work. One thread calls it.
class MotionTask {
 public:
  /// `handlers`: makes the motions of handlers, which have the axes one at a time. `recorded`:
  /// periods of the way of the axes, for WayBack.
  MotionTask(const motion::RobotModel& robot, motion::TrajectoryGenerator& generator,
             motion::TrajectoryGenerator& handlers, double override_share, Channels& channels,
             const std::vector<SimulationRule>& script, std::size_t recorded = 0);

  /// Once, before the program's first step: what the machine said when it was enabled, and what is
  /// simulated from the start, are the inputs until the first cycle.
  void prepare(double now) noexcept { inputs_.prepare(now); }

  /// `number`: k, ever greater; what lies between was missed. `lateness`: s after its deadline.
  void cycle(std::int64_t number, double lateness) noexcept;

  /// Everything is done, or stands still for good: further cycles change nothing.
  bool over() const noexcept { return over_.load(std::memory_order_acquire); }

 private:
  void take_samples() noexcept;
  void supervise_force() noexcept;
  void take_requests() noexcept;
  void take_interventions() noexcept;
  bool handlers_barred() const noexcept;
  void lead(std::int64_t number) noexcept;
  void collect_events() noexcept;
  void release_actions() noexcept;
  void release_events() noexcept;
  void release(Track& track, motion::MotionEvent event) noexcept;
  void begin_motion(const Track& track, const motion::MotionEvent& event) noexcept;
  bool release_effect(Track& track, motion::MotionEvent& event) noexcept;
  bool carry_out(const motion::Effect& effect) noexcept;
  void publish() noexcept;
  bool done() noexcept;
  bool machine_settled() noexcept;

  Channels& channels_;
  double period_;
  Tracks tracks_;
  ServoHistory history_;
  Outputs outputs_;
  Inputs inputs_;
  SpeedShare speed_;
  Effects effects_;
  Retracing retracing_;
  Pressing pressing_;
  ForceWatch force_watch_;
  Stopping stopping_;

  bool started_ = false;
  double now_ = 0;  ///< of the current cycle, s
  double lateness_ = 0;
  bool finished_ = false;              ///< motion is over; pulses may still be under way
  std::optional<double> finished_at_;  ///< s
  std::atomic<bool> over_{false};
};

}  // namespace rob::runtime
