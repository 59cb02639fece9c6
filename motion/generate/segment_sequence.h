#pragma once

#include <atomic>
#include <cstdint>
#include <optional>

#include "motion/generate/dwell.h"
#include "motion/generate/early_end.h"
#include "motion/generate/effect_order.h"
#include "motion/generate/event_queue.h"
#include "motion/generate/jog_run.h"
#include "motion/generate/path_law.h"
#include "motion/generate/trajectory_generator.h"
#include "motion/generate/under_way.h"
#include "motion/robots/robot_model.h"

namespace rob::motion {

/// How segments follow each other: paths, dwells and jogs, each in its time, and where the axes are
/// meanwhile. From rest a segment starts at the stamp at which it is first seen.
///
/// A dwell stands at its target for its duration of the run's time, whatever the override; a hold
/// interrupts it. The next segment starts at its exact end.
///
/// A segment that ends at rest and has a SettleWindow goes on as a dwell until the robot is in
/// position; the cycle in which it is seen to be is then its end. Effects after it, and after the
/// motion that it makes exact, wait for that; a hold stops the time. Where the time is over first:
/// Unsettled, and nothing more is begun.
///
/// Where no jog joins a jog it comes to rest, and a Rest says where.
///
/// A segment whose rates would not be finite is not begun: Fault, the axes arrive at the target
/// before it, and nothing more is begun. A reference that is no number all the same is not handed
/// out: Fault, and the one before is held.
///
/// Instants are s since the start of the run. Every call but the constructor may be used in the
/// tick.
class SegmentSequence {
 public:
  SegmentSequence(const RobotModel& robot, PathLaw& law, UnderWay& now, EffectOrder& effects,
                  EarlyEnd& early, EventQueue& events);

  void keep_to(const JogRoom& room) noexcept { jog_.keep_to(room); }
  /// All that happens up to the stamp, in order of time.
  void go_on() noexcept;
  /// Starts from standstill what may start.
  void start_from_rest() noexcept;
  /// Reports once that everything is done.
  void finish_if_done() noexcept;
  /// The path, and what has stood, stand for `gap`, s.
  void skip(double gap) noexcept;
  void interrupt_dwell(double gap) noexcept { dwell_.skip(gap); }
  /// Nothing is known that could follow, and something will.
  void report_late_decision(double instant) noexcept;
  std::uint32_t late_decisions() const noexcept {
    return late_decisions_.load(std::memory_order_relaxed);
  }

  // In position.
  void keep_measured() noexcept { dwell_.keep_measured(); }
  void look_at_position() noexcept;

  // The queue.
  /// Motions up to `number` are passed over.
  void skip_to(std::uint32_t number) noexcept;
  /// Motions of a generation that has ended are passed over; after them the axes stand.
  void drop_ended() noexcept;
  void let_effects_act(double time) noexcept;

  // Where the axes are.
  const GeneratorSample& sample() const noexcept { return sample_; }
  /// Makes the sample of the stamp, but for its state.
  void make_sample() noexcept;
  void set_state(MotionState state) noexcept { sample_.state = state; }
  /// The axes stand at q, m, rad.
  void stand_at(const JointVector& q) noexcept;
  JointVector standing_place() const noexcept;
  /// Since when the axes stand, and would if they went on as asked; none while they move.
  std::optional<double> at_rest_since() const noexcept;
  /// The share of the segment's time, 0 … 1.
  double share_done() const noexcept;
  /// The highest number at whose end it must be known by the next stamp what follows.
  std::uint32_t decided() const noexcept;

 private:
  void run_segments() noexcept;
  double next_end() const noexcept { return now_.segment.dwell ? dwell_.end() : law_.end(); }
  void leave(double instant) noexcept;
  void decide(double instant) noexcept;
  void pass_by() noexcept;
  void pass_targets() noexcept;
  void pass(std::uint32_t number, double instant) noexcept;
  void arrive(double instant) noexcept;
  const SegmentDescriptor* next_to_begin() const noexcept;
  void follow_from_rest(double instant) noexcept;
  bool take_up(const SegmentDescriptor& next, double instant) noexcept;
  void begin_dwell(const SegmentDescriptor& segment, double instant) noexcept;
  void begin_settling(double instant) noexcept;
  void begin_jog(const SegmentDescriptor& segment, double instant) noexcept;
  void run_jog() noexcept;
  void join_jog() noexcept;
  void end_jog() noexcept;
  /// The share of a jog's rates, for now.
  double jog_share() const noexcept;
  bool awaits_position(const Effect& effect) const noexcept;
  void let_path_events_act(double until, std::uint32_t number) noexcept;
  void follow_path() noexcept;
  void stand() noexcept;
  void report_start(double instant, double way) noexcept;
  void fail(const SegmentDescriptor& segment, int axis, double instant) noexcept;

  const double period_;
  PathLaw& law_;
  UnderWay& now_;
  EffectOrder& effects_;
  EarlyEnd& early_;
  EventQueue& events_;
  Dwell dwell_;
  JogRun jog_;
  std::atomic<std::uint32_t> late_decisions_{0};
  bool finished_ = false;
  GeneratorSample sample_;
};

}  // namespace rob::motion
