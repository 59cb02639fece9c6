#pragma once

#include <array>
#include <atomic>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "motion/force/press.h"
#include "motion/generate/drive_relief.h"
#include "motion/generate/retrace.h"
#include "motion/generate/trajectory_generator.h"
#include "motion/robots/robot_model.h"
#include "runtime/tick/channels.h"
#include "runtime/tick/force_gauge.h"
#include "runtime/tick/last_stop.h"
#include "runtime/tick/pulses.h"
#include "runtime/tick/simulated_inputs.h"

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
  void prepare(double now) noexcept;

  /// `number`: k, ever greater; what lies between was missed. `lateness`: s after its deadline.
  void cycle(std::int64_t number, double lateness) noexcept;

  /// Everything is done, or stands still for good: further cycles change nothing.
  bool over() const noexcept { return over_.load(std::memory_order_acquire); }

 private:
  /// One generator, and whom it tells what.
  struct Track {
    motion::TrajectoryGenerator& generator;
    MotionProgress& progress;
    motion::GeneratorSample current{};  ///< handed out last, measured when its stamp has come
    /// Events are computed up to a period ahead and wait here for their instant.
    motion::SpscRing<motion::MotionEvent> pending{Channels::kEvents};
  };

  void advance(std::int64_t number) noexcept;
  void take_samples() noexcept;
  bool machine_settled() noexcept;
  void latch_inputs(double now) noexcept;
  void take_finding(double time, const motion::FollowingFinding& finding) noexcept;
  void take_requests() noexcept;
  void take_interventions() noexcept;
  void pause(bool asked) noexcept;
  motion::CycleView view(double now) const noexcept;
  // Handlers (motion_task_handlers.cpp)
  void take_after_handler() noexcept;
  void hand_over_rest(Track& track, const motion::MotionEvent& event) noexcept;
  void begin_handler(const motion::Rest& rest) noexcept;
  bool handlers_barred() const noexcept;
  // The way back (motion_task_retrace.cpp)
  void take_way_back() noexcept;
  bool pause_on_way_back(bool asked) noexcept;
  void follow_way_back(double time) noexcept;
  // PRESS (motion_task_press.cpp)
  void follow_press() noexcept;
  PressDesk::State press_state() const noexcept;
  void supervise_force() noexcept;
  void supervise_sensor() noexcept;
  void back_off() noexcept;
  void begin_retreat() noexcept;
  void end_press() noexcept;
  bool handling() const noexcept { return active_ == &handlers_; }
  void publish(const motion::GeneratorSample& sample) noexcept;
  void collect_events() noexcept;
  void release_actions() noexcept;
  void release_events(double until) noexcept;
  void release(Track& track, motion::MotionEvent event, double cycle_time) noexcept;
  void hold() noexcept;
  void brake() noexcept;
  void follow_last_stop(double stamp) noexcept;
  void take_immediate() noexcept;
  void act(const motion::Effect& effect, double now) noexcept;
  /// Whether the effect is on an output that has taken its SAFE value for good.
  bool locked(const motion::Effect& effect) const noexcept;
  void lock(const motion::Effect& effect) noexcept;
  /// What has gone wrong cannot wait for standstill: all SAFE values at once.
  void take_safe_values() noexcept;
  void simulate(WorldSignal place, double value, double time, std::uint32_t answer = 0) noexcept;
  void set_override(double share) noexcept;
  /// The path is slowed down while the drives cannot follow it.
  void relieve_drives() noexcept;
  /// What holds now: the override, or less.
  double path_share() const noexcept;
  void switch_output(int channel, bool on) noexcept;
  /// Switches off what was on for a PULSE that is over at `now`.
  void end_pulses(double now) noexcept;
  void tell(const motion::MotionEvent& event) noexcept;
  /// What is kept of a ServoSample.
  struct Seen {
    motion::JointMeasurement measured;
    motion::JointVector drive;
    bool settled = true;
    bool joining = false;
  };
  /// What was measured at `stamp`; null before the first servo cycle.
  const Seen* seen_at(double stamp) const noexcept;

  Channels& channels_;
  Track program_;
  Track handlers_;
  Track* active_ = &program_;  ///< the one that has the axes
  const motion::RobotModel& robot_;
  double period_;
  bool scales_time_;       ///< the rate of a sample is that of the path's time
  double most_share_;      ///< of an override that the law can follow
  double override_share_;  ///< with the program's OVERRIDE

  bool started_ = false;
  double now_ = 0;  ///< of the present cycle, s
  double lateness_ = 0;
  std::uint64_t outputs_ = 0;
  motion::AnalogValues analog_outputs_{};
  std::uint64_t locked_ = 0;  ///< bit i: output channel i keeps its SAFE value
  std::uint64_t analog_locked_ = 0;
  bool safe_ = false;                 ///< take_safe_values() has been called
  std::uint64_t machine_inputs_ = 0;  ///< as the machine says
  motion::AnalogValues machine_analog_inputs_{};
  ForceGauge gauge_;
  motion::Wrench wrench_;  ///< of the present cycle, along the world
  SimulatedInputs simulated_;
  Pulses pulses_;
  bool finished_ = false;              ///< motion is over; pulses may still be under way
  std::optional<double> finished_at_;  ///< s
  bool disables_ = false;              ///< the drives, when the last stop has come to its end
  double saturation_ = 0;
  motion::DriveRelief relief_;
  motion::Retrace retrace_;
  LastStop last_stop_;
  motion::Press press_;
  motion::JointVector unpressed_;  ///< where the path is, without what the PRESS adds
  int beyond_ = 0;                 ///< cycles in which the force has been beyond the robot's limit
  bool yielding_ = false;          ///< the program has braked meanwhile
  /// From a force beyond the robot's limit.
  enum class BackOff : std::uint8_t { None, Braking, Retreating, Ending };
  BackOff backing_off_ = BackOff::None;
  double retreats_until_ = 0;
  bool relieved_ = false;  ///< once at least; it has been said
  bool warned_ = false;
  bool faulted_ = false;
  bool paused_ = false;

  /// The servo's last samples: what was measured at the stamp of a reference is looked up here.
  static constexpr std::size_t kHistory = 64;
  std::array<Seen, kHistory> history_;
  std::size_t samples_ = 0;  ///< taken so far; the newest is at (samples_ − 1) % kHistory

  std::atomic<bool> over_{false};
};

}  // namespace rob::runtime
