#pragma once

#include <algorithm>
#include <atomic>
#include <cstddef>
#include <cstdint>
#include <optional>

#include "motion/generate/trajectory_generator.h"
#include "motion/generate/velocity_mode.h"
#include "motion/generate/watch_list.h"
#include "motion/plan/look_ahead_buffer.h"
#include "motion/robots/robot_model.h"
#include "motion/space/cycle_instant.h"
#include "motion/space/spsc_ring.h"

namespace rob::motion {

/// What every law has in common that makes references on line, segment by segment: the periods,
/// effects in motion order, early ends, handlers, dwells, jogs, and what is told. How the axes move
/// along a path, and when they are where, is the law's: the virtual functions below.
///
/// An effect behind segment n is due where the path passes n's target. One that comes later than
/// that, or before any motion, is due at once. From rest a segment starts at the stamp at which it
/// is first seen.
///
/// A dwell stands at its target for its duration of the run's time, whatever the override; a hold
/// interrupts it. What follows starts at its exact end.
///
/// What is guarded or braked ends early: the axes brake on the path, and the rest of its generation
/// is dropped. A guarded motion that would begin from standstill while its condition holds does not
/// begin. A guarded motion with nothing behind it is a barrier: its Rest tells how it ended.
///
/// WHENs are armed and disarmed by effects, asked in look() before the guard, and act in the cycle;
/// one that raises brakes like a guard, and no effect acts any more from then on. One with a
/// handler holds the axes on the path until go_on(), as hold() does; guards are not asked
/// meanwhile.
///
/// What ends at rest and has a SettleWindow goes on as a dwell until the axes are measured within
/// it, and do not just pass through: in look(), whose cycle is then its end. Effects behind it, and
/// behind the motion that it makes exact, wait for that; a hold stops the time. Where the time is
/// over first: Unsettled, and nothing more is begun.
///
/// A jog begins at rest, or joins the jog before it, whose state goes on (VelocityMode); its
/// periods are the run's, and an override or a hold slows its rates and its time. Where none joins
/// it comes to rest, and a Rest says where.
///
/// A segment whose rates would not be finite is not begun: Fault, the axes arrive at the target
/// before it, and nothing more is begun. A reference that is no number all the same is not handed
/// out: Fault, and the one before is held.
///
/// Instants are s since the start of the run. The trajectory_generator.h rules on threads and the
/// tick hold; decidable() and late_decisions() may be read, and events taken, by one other thread.
class SegmentGenerator : public TrajectoryGenerator {
 public:
  void look(const CycleView& view) noexcept override;
  const GeneratorSample& advance(std::int64_t period) noexcept override;
  void hold() noexcept override { stopped_ = true; }
  void resume() noexcept override { stopped_ = held_told_ = false; }
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
  bool take_rest(Rest& rest) noexcept override {
    untold_ = false;
    return rests_.take(rest);
  }

  /// How often nothing was known at a decision instant.
  std::uint32_t late_decisions() const noexcept {
    return late_decisions_.load(std::memory_order_relaxed);
  }

 protected:
  /// `start`: where the axes stand, m, rad. Takes memory; nothing else here does.
  SegmentGenerator(const RobotModel& robot, LookAheadBuffer& buffer, const JointVector& start);

  // What comes next, which may have to wait till it fits(). `closed`: nothing but that.
  virtual const SegmentDescriptor* next_segment() const noexcept { return buffer_.next_segment(); }
  virtual void pop_segment() noexcept { buffer_.pop_segment(); }
  virtual bool fits(const SegmentDescriptor&) const noexcept { return true; }
  virtual bool closed() const noexcept { return buffer_.closed(); }
  /// Not at the exact end of what comes before it.
  virtual bool begins_at_stamp(const SegmentDescriptor& next) const noexcept {
    return next.jog->present();
  }

  // The law. Of these only what is said to be is called while the axes are not on_path().

  /// The law's time goes on to stamp(); in any case.
  virtual void go_on_to_stamp() noexcept = 0;
  /// The path stands still for `gap`; in any case.
  virtual void skip(double gap) noexcept = 0;
  /// Tells of the targets that the path has passed by now.
  virtual void pass_targets() noexcept = 0;
  /// When it has to be known, or was, what follows segment(); infinite if that is not by stamp().
  virtual double end() const noexcept = 0;
  /// The axes stand at the segment's target at its end().
  virtual bool ends_at_rest() const noexcept { return segment_.ends_at_rest(); }
  /// That instant has passed.
  virtual void decide(double instant) noexcept { follow_from_rest(instant); }
  /// segment() ends, or has ended, at standstill, and `next`, which has a path, begins; in any
  /// case.
  virtual void begin(const SegmentDescriptor& next, double instant) noexcept = 0;
  /// The axes stand elsewhere than their path leads; in any case.
  virtual void end_path() noexcept = 0;
  /// So does all that is queued, with its `generation`; 0: it will be queued anew.
  virtual void drop_path(std::uint32_t) noexcept {}
  /// Where and how fast the axes are at stamp(), sigma, rate and limit.
  virtual void sample_path(GeneratorSample& sample) const noexcept = 0;
  /// The sigma of axes that stand; in any case.
  virtual double sigma_at_rest() const noexcept = 0;
  /// What of the segment's time is done, 0 … 1.
  virtual double share_done() const noexcept = 0;
  /// What the path has asked of the jerk lies behind; in any case. Jogs and profiles wait for it.
  virtual bool settled() const noexcept { return true; }
  /// Since when the axes stand, holding or braking; none while they move.
  virtual std::optional<double> stands_since() const noexcept = 0;
  /// The highest number whose end() comes with the next stamp, or was.
  virtual std::uint32_t decided() const noexcept = 0;
  /// Whether decision points are not known beforehand, and told when they come; in any case.
  virtual bool tells_decisions() const noexcept { return false; }
  /// The next path event of motions up to `number` that is due by `until`, within the last period,
  /// and when; null: none. In any case.
  virtual const Effect* take_path_event(double until, std::uint32_t number,
                                        double& due) noexcept = 0;
  /// Whether one is still to come. In any case.
  virtual bool awaits_path_event() const noexcept = 0;

  // For the law.
  double period() const noexcept { return period_; }
  double stamp() const noexcept { return stamp_; }
  const LookAheadBuffer& buffer() const noexcept { return buffer_; }
  /// The segment under way, or the last one.
  const SegmentDescriptor& segment() const noexcept { return segment_; }
  SegmentDescriptor& segment() noexcept { return segment_; }
  bool running() const noexcept { return running_; }
  bool dwelling() const noexcept { return running_ && segment_.dwell; }
  bool jogging() const noexcept { return running_ && segment_.jog->present(); }
  bool on_path() const noexcept { return running_ && !segment_.dwell && !segment_.jog->present(); }
  /// The axes shall come to rest on the path, and stand there.
  bool stopping() const noexcept { return holding() || braking_; }
  /// It ends there.
  bool braking() const noexcept { return braking_; }
  double override_share() const noexcept { return override_; }
  /// 1/s of a motion's own duration: its LivePace, in this cycle. It has one; a pace that cannot be
  /// computed is a fault.
  double live_rate(const SegmentDescriptor& segment) noexcept;
  /// What may begin now; null: nothing.
  const SegmentDescriptor* next_to_begin() const noexcept;
  /// Motions up to `number` are passed over.
  void skip_to(std::uint32_t number) noexcept { segment_.number = passed_ = number; }
  /// Effects up to `number` are due at `instant`, behind what is on the way of their motions.
  void pass(std::uint32_t number, double instant) noexcept;
  bool passed(std::uint32_t number) const noexcept { return passed_ >= number; }
  /// Begins `next` and says so; false, with a fault, if its rates would not be finite.
  bool take_up(const SegmentDescriptor& next, double instant) noexcept;
  /// The axes stand at the end of the segment, and may go on at `instant`.
  void follow_from_rest(double instant) noexcept;
  void close_guard(double instant) noexcept;
  /// Nothing is known that could follow, and something will.
  void tell_late_decision(double instant) noexcept;
  /// A path event comes s later than its LEAD asked for; what is less than a period is nothing.
  void tell_cut_lead(const Effect& effect, double due, double by) noexcept;
  void tell(MotionEvent event) noexcept;

 private:
  void catch_up(std::int64_t period) noexcept;
  void step(double stamp) noexcept;
  void interrupt_dwell() noexcept;
  void run_segments() noexcept;
  double next_end() const noexcept { return segment_.dwell ? dwell_end_ : end(); }
  void leave(double instant) noexcept;
  void pass_by() noexcept;
  void arrive(double instant) noexcept;
  void begin_dwell(const SegmentDescriptor& segment, double instant) noexcept;
  double dwell_done() const noexcept;
  void start_from_rest() noexcept;
  void finish_if_done() noexcept;
  void report_held() noexcept;
  double share_of_time() const noexcept;
  void fire_effects(double time) noexcept;
  void fire_path_events(double until, std::uint32_t number) noexcept;
  void make_sample() noexcept;
  MotionState state() const noexcept;
  void follow_path() noexcept;
  void stand() noexcept;
  void fail(const SegmentDescriptor& segment, int axis, double instant) noexcept;
  void publish_decidable() noexcept;
  /// Since when the axes stand, and would if they went on as asked; none while they move.
  std::optional<double> at_rest_since() const noexcept;
  bool axes_held() const noexcept { return holding() && at_rest_since(); }
  bool holding() const noexcept { return stopped_ || handling(); }
  /// Braking for an error of the program.
  bool failing() const noexcept { return braking_ && rest_.by != nullptr; }

  // In position (segment_settling.cpp)
  bool settling() const noexcept { return dwelling() && segment_.settle.present(); }
  void begin_settling(double instant) noexcept;
  void look_at_position() noexcept;
  bool awaits_position(const Effect& effect) const noexcept;

  // Early ends (segment_early_end.cpp)
  static Rest::Outcome outcome_of(WatchAnswer answer) noexcept;
  bool do_watched(WatchedAction& action, WatchAnswer answer) noexcept;
  void ask_guard() noexcept;
  void begin_rest(Rest::Outcome outcome, WatchedAction* by, double time) noexcept;
  void trip(Rest::Outcome outcome, WatchedAction* by = nullptr) noexcept;
  void arm_or_disarm(const Effect& effect, bool dropped) noexcept;
  bool hit_at_start(const SegmentDescriptor& segment, double instant) noexcept;
  void end_early(double instant) noexcept;
  void tell_rest(double time) noexcept;
  void drop_ended() noexcept;

  // Handlers (segment_handled.cpp)
  bool may_be_handled() const noexcept;
  void begin_handling(WatchedAction& action) noexcept;
  /// The axes are a handler's, or stop for one.
  bool handling() const noexcept {
    return handling_ != nullptr && handling_->kind == WatchedAction::Kind::Handle;
  }
  void tell_handled(double time) noexcept;
  void report_handled() noexcept;
  JointVector standing_place() const noexcept;

  // Jogs (segment_jog.cpp)
  bool jog_is_over() const noexcept;
  /// Of its rates, for now.
  double jog_share() const noexcept { return stopping() ? 0 : std::min(override_, 1.0); }
  void begin_jog(const SegmentDescriptor& segment, double instant) noexcept;
  void run_jog() noexcept;
  void join_jog() noexcept;
  void end_jog() noexcept;
  void report_jog_stopped() noexcept;
  void follow_jog() noexcept;

  const RobotModel& robot_;
  const double period_;
  const std::int64_t most_missed_;
  LookAheadBuffer& buffer_;
  SpscRing<MotionEvent> events_;
  SpscRing<Rest> rests_;
  std::atomic<std::uint32_t> decidable_{0};
  std::atomic<std::uint32_t> late_decisions_{0};
  std::int64_t last_period_ = -1;
  double stamp_;
  double override_ = 1;

  SegmentDescriptor segment_;
  bool running_ = false;
  double dwell_end_ = 0;      ///< infinite while settling()
  double settle_by_ = 0;      ///< of settling(), s
  std::uint32_t passed_ = 0;  ///< effects up to this number are due

  VelocityMode jog_;       ///< stands but for a jog
  double jog_done_ = 0;    ///< s of the jog under way, as planned
  bool jog_told_ = false;  ///< that it goes no further

  // What ends early
  WatchList watches_;
  CycleView view_;               ///< of the present cycle
  JointVector measured_before_;  ///< in the cycle before
  bool braking_ = false;
  Rest rest_;                ///< in the making
  bool untold_ = false;      ///< an error has ended motions, and its Rest cannot be known yet
  std::uint32_t ended_ = 0;  ///< generations up to this one are over
  std::uint32_t kept_ = 0;   ///< effects of the one that ended last act up to this number

  WatchedAction* handling_ = nullptr;  ///< the WHEN whose handler runs, or will
  bool handled_told_ = false;
  bool handlers_barred_ = false;
  bool stopped_ = false;  ///< hold() has been asked for
  bool held_told_ = false;
  bool faulted_ = false;
  bool finished_ = false;
  double latest_ = 0;  ///< the latest instant told or arrived at, s
  GeneratorSample sample_;
};

}  // namespace rob::motion
