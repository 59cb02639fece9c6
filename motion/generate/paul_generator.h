#pragma once

#include <cstdint>
#include <optional>

#include "motion/generate/path_clock.h"
#include "motion/generate/path_events.h"
#include "motion/generate/path_law.h"
#include "motion/generate/segment_generator.h"
#include "motion/plan/look_ahead_buffer.h"
#include "motion/plan/paul_segment.h"
#include "motion/robots/time_scaling.h"

namespace rob::motion {

/// S1's law: segments, straight in axis space or along a path of the tool,
/// joined by transitions around their via points (PaulSegment). A motion that must begin at rest
/// makes the target before it exact; a motion with a profile begins and ends at rest by itself.
///
/// A segment is left at its decision instant, t_acc before its target would be reached; what
/// follows is taken from the buffer only when a reference later than that instant is computed. The
/// new segment starts at the exact instant and from the exact place, whatever the periods. If
/// nothing is known by then, a segment of no length follows of itself: the axes arrive at the
/// target and stand (LateDecision, unless the buffer is closed).
///
/// The path passes n's target at the end of n, or of what follows it, where that has no length;
/// else in the middle of the corner, t = 0 of what follows.
///
/// Each target has a half transition of its own, t_B + t_C <= T1. Tighter corners leave less for
/// slowing down: the tightest that the buffer has seen decides how fast a hold and a change of
/// override may be. One that is tighter than what a ramp under way was made for waits for its end,
/// at the target before it.
///
/// A motion that brakes does so beyond the segment's end if need be. A guarded motion that has
/// begun to round the corner towards it is asked from there on.
///
/// Path events are due at their places (PathEvents), to the instant at constant override.
///
/// Sample: sigma is S1's t, s; limit 20 stands for the end of the buffer, 21 for an override
/// below 1.
class PaulLaw final : public PathLaw {
 public:
  PaulLaw(const RobotModel& robot, LookAheadBuffer& buffer, UnderWay& now, EventQueue& events);

  const SegmentDescriptor* next_segment() const noexcept override { return buffer_.next_segment(); }
  void pop_segment() noexcept override { buffer_.pop_segment(); }
  bool fits(const SegmentDescriptor& next) const noexcept override {
    return !(next.t_acc < tightest_);
  }
  bool closed() const noexcept override { return buffer_.closed(); }
  void take_share() noexcept override;
  News go_on_to_stamp() noexcept override;
  void skip(double gap) noexcept override { clock_.skip(gap); }
  void begin(const SegmentDescriptor& next, double instant) noexcept override;
  double end() const noexcept override;
  bool ends_at_rest() const noexcept override { return now_.segment.ends_at_rest(); }
  void stop() noexcept override;
  std::optional<Passed> passed(std::uint32_t known) const noexcept override;
  void end_path() noexcept override;
  void sample_path(GeneratorSample& sample) const noexcept override;
  double sigma_at_rest() const noexcept override { return exit(); }
  double share_done() const noexcept override;
  std::optional<double> stands_since() const noexcept override;
  std::uint32_t decided() const noexcept override;
  DueEvent take_path_event(double until, std::uint32_t number) noexcept override;
  bool awaits_path_event() const noexcept override { return path_events_.pending(); }

 private:
  void aim_clock() noexcept;
  void adapt_clock() noexcept;
  double path_instant(double instant) const noexcept;
  double live_share() noexcept;
  void brake_harder() noexcept;
  void begin_profile(const SegmentDescriptor& next, double instant) noexcept;
  bool may_jump() const noexcept;
  double sigma() const noexcept { return clock_.path_time() - zero_; }
  /// S1's t at the decision instant.
  double exit() const noexcept {
    const SegmentDescriptor& segment = now_.segment;
    const bool whole = segment.dwell || segment.profile.present();
    return whole ? segment.duration : segment.duration - segment.t_acc;
  }

  LookAheadBuffer& buffer_;
  const AxisReserve reserve_;
  const double usual_t_acc_;  ///< of the first transition from a place that no path has led to
  PathClock clock_;
  PathEvents path_events_;
  PaulSegment path_;
  bool from_rest_ = false;  ///< the segment began at standstill
  bool inserted_ = false;   ///< a stop of its own, for want of a successor
  double tightest_;         ///< the least t_acc that clock_ can hold in
  double zero_ = 0;         ///< path time at t = 0
  double end_ = 0;          ///< path time of the decision instant
  double milestone_ = 0;    ///< path time at which the effects up to number `passing_` are due
  std::uint32_t passing_ = 0;
};

/// References on line by S1's law.
class PaulGenerator final : public SegmentGenerator {
 public:
  /// `start`: where the axes stand, m, rad. Takes memory; nothing else here does.
  PaulGenerator(const RobotModel& robot, LookAheadBuffer& buffer, const JointVector& start)
      : SegmentGenerator(robot, buffer, law_, start), law_(robot, buffer, now(), events()) {}

 private:
  PaulLaw law_;
};

}  // namespace rob::motion
