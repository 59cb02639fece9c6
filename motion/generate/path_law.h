#pragma once

#include <cmath>
#include <cstdint>
#include <optional>

#include "motion/generate/event_queue.h"
#include "motion/generate/trajectory_generator.h"
#include "motion/generate/under_way.h"
#include "motion/plan/path_event.h"
#include "motion/plan/segment_descriptor.h"

namespace rob::motion {

/// How the axes move along a path, and when they are where: what differs between the laws by which
/// a SegmentGenerator works.
///
/// While the axes are not on a path only those calls are made that say "in any case"
/// (UnderWay). Instants are s since the start of the run. Every call may be used in the tick.
class PathLaw {
 public:
  virtual ~PathLaw() = default;

  // The segments to come. In any case.
  virtual const SegmentDescriptor* next_segment() const noexcept = 0;
  virtual void pop_segment() noexcept = 0;
  /// Else it has to wait.
  virtual bool fits(const SegmentDescriptor&) const noexcept { return true; }
  /// There is nothing but that.
  virtual bool closed() const noexcept = 0;
  /// From rest it begins at a stamp, not at the exact end of what comes before it.
  virtual bool begins_at_stamp(const SegmentDescriptor& next) const noexcept {
    return next.jog->present();
  }
  /// Until then no event may be taken.
  virtual bool ready() const noexcept { return true; }

  // Time. In any case.
  /// PathOrders::share has been set.
  virtual void take_share() noexcept = 0;
  /// News since the last stamp.
  struct News {
    std::uint32_t skipped = 0;         ///< motions up to this number are passed over; 0: none
    std::uint32_t late_decisions = 0;  ///< so often nothing was known of what follows in time
  };
  /// The law's time goes on to UnderWay::stamp.
  virtual News go_on_to_stamp() noexcept = 0;
  /// The path stands still for `gap`, s.
  virtual void skip(double gap) noexcept = 0;

  // Beginnings and ends.
  /// `next`, which has a path, begins, and becomes the segment. In any case; what is under way
  /// ends, or has ended, at standstill, or runs on into it.
  virtual void begin(const SegmentDescriptor& next, double instant) noexcept = 0;
  /// When what follows the segment must be known, or was; infinite if that is not by stamp.
  virtual double end() const noexcept = 0;
  /// The axes stand at the segment's target at its end().
  virtual bool ends_at_rest() const noexcept = 0;
  /// Else, where nothing may follow at its end(): they come to rest at its target.
  virtual void stop() noexcept {}
  /// A target that the path has passed by now: that of the motion `number`.
  struct Passed {
    std::uint32_t number = 0;
    double instant = 0;
  };
  /// The one after that of motion `known`; none: not yet.
  virtual std::optional<Passed> passed(std::uint32_t known) const noexcept = 0;
  /// When the path left the segment and ran on into the next one, which is known; none: not yet.
  virtual std::optional<double> ran_on() const noexcept { return std::nullopt; }
  /// The axes stand elsewhere than their path leads. In any case.
  virtual void end_path() noexcept = 0;
  /// All that is queued is dropped, too, with its `generation`; 0: it will be queued anew. In any
  /// case.
  virtual void drop_path(std::uint32_t) noexcept {}

  // Where the axes are.
  /// Where and how fast they are at stamp, sigma, rate and limit.
  virtual void sample_path(GeneratorSample& sample) const noexcept = 0;
  /// The sigma of axes that stand. In any case.
  virtual double sigma_at_rest() const noexcept = 0;
  /// The share of the segment's time that is done, 0 … 1.
  virtual double share_done() const noexcept = 0;
  /// No jerk of the path can come any more; jogs and profiles wait for that. In any case.
  virtual bool settled() const noexcept { return true; }
  /// Since when the axes stand, holding or braking; none while they move.
  virtual std::optional<double> stands_since() const noexcept = 0;

  // Decision points.
  /// The highest number whose end() comes with the next stamp, or was.
  virtual std::uint32_t decided() const noexcept = 0;
  /// Whether they are not known beforehand, and reported when they come. In any case.
  virtual bool reports_decisions() const noexcept { return false; }

  // Path events. In any case.
  struct DueEvent {
    const Effect* effect = nullptr;  ///< null: none
    double due = 0;
    double cut = 0;  ///< s by which it comes later than its LEAD asked for
  };
  /// The next one of motions up to `number` that is due by `until`, within the last period.
  virtual DueEvent take_path_event(double until, std::uint32_t number) noexcept = 0;
  /// Whether one is still to come.
  virtual bool awaits_path_event() const noexcept = 0;

 protected:
  PathLaw(UnderWay& now, EventQueue& events) noexcept : now_(now), events_(events) {}

  /// 1/s of a motion's own duration: its LivePace, in this cycle. It has one; a pace that cannot be
  /// computed is a fault.
  double live_rate(const SegmentDescriptor& segment) noexcept {
    const double rate = events_.faulted() ? 0 : segment.live.rate(now_.view);
    if (std::isfinite(rate)) return rate;
    events_.report_fault({.kind = MotionEvent::Kind::PaceFailed,
                          .time = now_.stamp,
                          .tag = segment.tag,
                          .number = segment.number});
    return 0;
  }

  UnderWay& now_;
  EventQueue& events_;
};

}  // namespace rob::motion
