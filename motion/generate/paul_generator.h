#pragma once

#include <atomic>
#include <cstddef>
#include <cstdint>

#include "motion/generate/path_clock.h"
#include "motion/generate/path_events.h"
#include "motion/generate/trajectory_generator.h"
#include "motion/generate/velocity_mode.h"
#include "motion/generate/watch_list.h"
#include "motion/plan/look_ahead_buffer.h"
#include "motion/plan/paul_segment.h"
#include "motion/robots/robot_model.h"
#include "motion/robots/time_scaling.h"
#include "motion/space/spsc_ring.h"

namespace rob::motion {

/// References on line by S1's law: segments, straight in axis space or along a path of the tool,
/// joined by transitions around their via points (PaulSegment). What is to begin at rest makes the
/// target before it exact; a motion with a profile begins and ends at rest by itself.
///
/// A segment is left at its decision instant, t_acc before its target would be reached; what
/// follows is taken from the buffer only when a reference later than that instant is computed. The
/// new segment starts at the exact instant and from the exact place, whatever the periods. If
/// nothing is known by then, a segment of no length follows of itself: the axes arrive at the
/// target and stand (LateDecision, unless the buffer is closed). From rest a segment starts at the
/// stamp at which it is first seen.
///
/// An effect behind segment n is due where the path passes n's target: at the end of n, or of what
/// follows it, where that has no length; else in the middle of the corner, t = 0 of what follows.
/// One that comes later than that, or before any motion, is due at once.
///
/// Each target has a half transition of its own, t_B + t_C <= T1. Tighter corners leave less for
/// slowing down: the tightest that the buffer has seen decides how fast a hold and a change of
/// override may be. One that is tighter than what a ramp under way was made for waits for its end,
/// at the target before it.
///
/// A dwell stands at its target for its duration of the run's time, whatever the override; a hold
/// interrupts it. What follows starts at its exact end.
///
/// What is guarded or braked ends early: the axes brake on the path, beyond the segment's end if
/// need be, and the rest of its generation is dropped. A guarded motion that has begun to round the
/// corner towards it is asked from there on; one that would begin from standstill while its
/// condition holds does not begin. A guarded motion with nothing behind it is a barrier: its Rest
/// tells how it ended.
///
/// WHENs are armed and disarmed by effects, asked in look() before the guard, and act in the cycle;
/// one that raises brakes like a guard, and no effect acts any more from then on.
///
/// One with a handler holds the axes on the path until go_on(), as hold() does; guards are not
/// asked meanwhile.
///
/// Path events are due at their places (PathEvents), to the instant at constant override.
///
/// A jog begins at rest, or joins the jog before it, whose state goes on (VelocityMode); its
/// periods are the run's, and an override or a hold slows its rates and its time. Where none joins
/// it comes to rest, and a Rest says where.
///
/// A segment whose rates would not be finite is not begun: Fault, the axes arrive at the target
/// before it, and nothing more is begun. A reference that is no number all the same is not handed
/// out: Fault, and the one before is held.
///
/// Sample: sigma is S1's t, s; limit 20 stands for the end of the buffer, 21 for an override
/// below 1. The trajectory_generator.h rules on threads and the tick hold; decidable() and
/// late_decisions() may be read, and events taken, by one other thread.
class PaulGenerator final : public TrajectoryGenerator {
 public:
  /// `start`: where the axes stand, m, rad. Takes memory; nothing else here does.
  PaulGenerator(const RobotModel& robot, LookAheadBuffer& buffer, const JointVector& start);

  void look(const CycleView& view) noexcept override;
  const GeneratorSample& advance(std::int64_t period) noexcept override;
  void hold() noexcept override;
  void resume() noexcept override;
  void set_override(double share) noexcept override;
  void go_on(double time) noexcept override;
  void decline_handler(double time) noexcept override;
  void bar_handlers(bool barred) noexcept override;
  void leave_path(const JointVector& q, double time, bool all) noexcept override;
  void stand_at(const JointVector& q) noexcept override;
  void brake() noexcept override;
  std::uint32_t decidable() const noexcept override {
    return decidable_.load(std::memory_order_acquire);
  }
  bool take_event(MotionEvent& event) noexcept override { return events_.take(event); }
  bool take_rest(Rest& rest) noexcept override { return rests_.take(rest); }

  /// How often nothing was known at a decision instant.
  std::uint32_t late_decisions() const noexcept {
    return late_decisions_.load(std::memory_order_relaxed);
  }

 private:
  void catch_up(std::int64_t period) noexcept;
  void adapt_clock() noexcept;
  const SegmentDescriptor* next_segment() const noexcept;
  void step(double stamp) noexcept;
  void run_segments() noexcept;
  void pass_milestone() noexcept;
  void arrive() noexcept;
  void decide() noexcept;
  void begin(const SegmentDescriptor& segment, double instant) noexcept;
  void begin_stop(double instant) noexcept;
  bool take_up(const SegmentDescriptor& segment, double instant) noexcept;
  void start_from_rest() noexcept;
  void finish_if_done() noexcept;
  void report_held() noexcept;
  void fire_effects(double time) noexcept;
  void fire_path_events() noexcept;
  void make_sample() noexcept;
  void follow_path() noexcept;
  void stand() noexcept;
  void fail(const SegmentDescriptor& segment, int axis, double instant) noexcept;
  void publish_decidable() noexcept;
  void tell(MotionEvent event) noexcept;

  // Early ends (paul_early_end.cpp)
  static Rest::Outcome outcome_of(WatchAnswer answer) noexcept;
  bool do_watched(WatchedAction& action, WatchAnswer answer) noexcept;
  void ask_guard() noexcept;
  void begin_rest(Rest::Outcome outcome, WatchedAction* by, double time) noexcept;
  void trip(Rest::Outcome outcome, WatchedAction* by = nullptr) noexcept;
  void arm_or_disarm(const Effect& effect, bool dropped) noexcept;
  bool hit_at_start(const SegmentDescriptor& segment, double instant) noexcept;
  void end_early(double instant) noexcept;
  void close_guard() noexcept;
  void tell_rest(double time) noexcept;
  void drop_ended() noexcept;

  // Handlers (paul_handled.cpp)
  bool may_be_handled() const noexcept;
  void begin_handling(WatchedAction& action) noexcept;
  /// The axes are a handler's, or stop for one.
  bool handling() const noexcept {
    return handling_ != nullptr && handling_->kind == WatchedAction::Kind::Handle;
  }
  void tell_handled(double time) noexcept;
  void report_handled() noexcept;
  JointVector standing_place() const noexcept;

  // Jogs (paul_jog.cpp)
  bool jogging() const noexcept { return running_ && segment_.jog.present(); }
  bool jog_is_over() const noexcept;
  bool axes_held() const noexcept { return clock_.held() && jog_.stands(); }
  void begin_jog(const SegmentDescriptor& segment, double instant) noexcept;
  void run_jog() noexcept;
  void join_jog() noexcept;
  void end_jog() noexcept;
  void report_jog_stopped() noexcept;
  void follow_jog() noexcept;

  void begin_dwell(const SegmentDescriptor& segment, double instant) noexcept;
  void begin_profile(const SegmentDescriptor& segment, double instant) noexcept;
  /// Braking for an error of the program.
  bool failing() const noexcept { return clock_.braking() && rest_.by != nullptr; }
  bool dwelling() const noexcept { return running_ && segment_.dwell; }
  /// At the very beginning of a motion from rest, or at the end of a stop.
  bool stands() const noexcept;
  double exit() const noexcept {
    const bool whole = segment_.dwell || segment_.profile.present();
    return whole ? end_ - zero_ : segment_.duration - segment_.t_acc;
  }

  const double period_;
  const std::int64_t most_missed_;
  const AxisReserve reserve_;
  LookAheadBuffer& buffer_;
  PathClock clock_;
  SpscRing<MotionEvent> events_;
  SpscRing<Rest> rests_;
  std::atomic<std::uint32_t> decidable_{0};
  std::atomic<std::uint32_t> late_decisions_{0};
  std::int64_t last_period_ = -1;

  // The segment under way, or the last one.
  SegmentDescriptor segment_;
  PaulSegment path_;
  bool running_ = false;
  bool from_rest_ = false;  ///< segment_ began at standstill
  bool inserted_ = false;   ///< a stop of its own, for want of a successor
  double tightest_;         ///< the least t_acc that clock_ can hold in
  double t_acc_;            ///< half the transition around segment_.target: t_B of the next
  double zero_ = 0;         ///< path time at t = 0
  double end_ = 0;          ///< path time of the decision instant
  double milestone_ = 0;    ///< path time at which the effects up to number `passing_` are due
  std::uint32_t passing_ = 0;
  std::uint32_t passed_ = 0;  ///< effects up to this number are due

  VelocityMode jog_;       ///< stands but for a jog
  double jog_done_ = 0;    ///< s of the jog under way, as planned
  bool jog_told_ = false;  ///< that it goes no further

  // What ends early
  const double usual_t_acc_;  ///< of the first transition after it
  WatchList watches_;
  PathEvents path_events_;
  CycleView view_;           ///< of the present cycle
  Rest rest_;                ///< in the making
  bool untold_ = false;      ///< an error has ended motions, and its Rest cannot be known yet
  std::uint32_t ended_ = 0;  ///< generations up to this one are over
  std::uint32_t kept_ = 0;   ///< effects of the one that ended last act up to this number

  WatchedAction* handling_ = nullptr;  ///< the WHEN whose handler runs, or will
  bool handled_told_ = false;
  bool handlers_barred_ = false;
  bool stopped_ = false;  ///< hold() has been asked for, too
  bool held_told_ = false;
  bool faulted_ = false;
  bool finished_ = false;
  double latest_ = 0;  ///< the latest instant told or arrived at, s
  GeneratorSample sample_;
};

}  // namespace rob::motion
