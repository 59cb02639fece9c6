#pragma once

#include <cstdint>
#include <optional>

#include "motion/ahead/path_ring.h"
#include "motion/ahead/reference_average.h"
#include "motion/generate/guide_history.h"
#include "motion/generate/path_clock.h"
#include "motion/generate/path_events.h"
#include "motion/generate/path_law.h"
#include "motion/generate/place_events.h"
#include "motion/generate/segment_generator.h"
#include "motion/plan/paul_segment.h"

namespace rob::motion {

/// The look-ahead law: references are the mean (ReferenceAverage) of a guide that runs along
/// the path as fast as what is known of it allows (Guide). The path comes from a PathPlanner,
/// through the ring; the LookAheadBuffer is here for its effects alone.
///
/// A reference has the mean of the guide's σ, and events go by that σ, too: a motion begins in the
/// middle of the corner that leads to it, where the target before it is passed, and path events are
/// due at their places, all at their exact instants. At a standstill the references
/// come to rest later than the guide by the mean's time. A motion that then follows begins at the
/// next stamp.
///
/// Hold, brake and a lower override slow the guide on the path, as hard as the axes can. Where
/// nothing is known it stands within what is; the PathPlanner reports when that was too late.
///
/// A motion with a profile runs in its own time, scaled as under Paul's law.
///
/// A motion that ends early takes the path ahead with it. Until the PathPlanner has given it up
/// nothing is reported and nothing begins.
///
/// Sample: sigma is the way on its motion, m; rate m/s; limit_numbers.h.
class LookAheadLaw final : public PathLaw {
 public:
  LookAheadLaw(const RobotModel& robot, PathRing& ring, UnderWay& now, EventQueue& events);

  const SegmentDescriptor* next_segment() const noexcept override;
  void pop_segment() noexcept override { ring_.pop_leg(); }
  bool closed() const noexcept override { return !dropping_ && ring_.closed.load(); }
  bool begins_at_stamp(const SegmentDescriptor& next) const noexcept override;
  bool ready() const noexcept override { return !dropping_; }
  void take_share() noexcept override;
  News go_on_to_stamp() noexcept override;
  void skip(double gap) noexcept override;
  void begin(const SegmentDescriptor& next, double instant) noexcept override;
  double end() const noexcept override;
  bool ends_at_rest() const noexcept override { return true; }
  std::optional<Passed> passed(std::uint32_t known) const noexcept override;
  std::optional<double> ran_on() const noexcept override;
  void end_path() noexcept override;
  void drop_path(std::uint32_t generation) noexcept override;
  void sample_path(GeneratorSample& sample) const noexcept override;
  double sigma_at_rest() const noexcept override { return leg_.way(length()); }
  double share_done() const noexcept override;
  bool settled() const noexcept override;
  std::optional<double> stands_since() const noexcept override;
  std::uint32_t decided() const noexcept override;
  bool reports_decisions() const noexcept override { return true; }
  DueEvent take_path_event(double until, std::uint32_t number) noexcept override;
  bool awaits_path_event() const noexcept override {
    return events_on_way_.pending() || profile_events_.pending();
  }

 private:
  bool profiled() const noexcept { return now_.segment.profile.present(); }
  /// Under way on the path of the guide.
  bool on_run() const noexcept { return now_.on_path() && run_; }
  double length() const noexcept { return end_ - begin_; }
  double guide_time() const noexcept { return now_.stamp - skipped_; }
  /// s by which a reference lags the guide.
  double lag() const noexcept { return (average_.periods() - 1) * period_ / 2; }
  /// When what the guide did at `time` shows in the references.
  double told(double time) const noexcept { return time + lag() + skipped_; }
  /// σ of the references.
  double cursor() const noexcept { return average_.sigma(); }
  bool beyond_end() const noexcept;
  std::optional<double> passed_end() const noexcept;
  double arrival() const noexcept;
  void step_guide() noexcept;
  double live_pace() noexcept;
  void report_missed_leads() noexcept;
  std::uint32_t finish_drop() noexcept;
  void begin_run(const PathLeg& leg) noexcept;
  void begin_profile(const SegmentDescriptor& next) noexcept;
  void expect_events(const SegmentDescriptor& next, double instant) noexcept;

  const double period_;
  PathRing& ring_;
  Guide guide_;
  ReferenceAverage average_;
  GuideHistory history_;
  PlaceEvents events_on_way_;
  bool run_ = false;    ///< the segment is part of a path from rest to rest
  double skipped_ = 0;  ///< s of the run that the guide's time has not
  double begin_ = 0;    ///< σ of the segment under way
  double end_ = 0;
  PathLeg leg_;         ///< of the segment under way
  double arrival_ = 0;  ///< of a segment without a way
  PathRing::Index released_ = 0;
  std::uint32_t late_ = 0;  ///< PathRing::late, as reported
  bool moved_ = false;      ///< the axes stand elsewhere than the guide
  bool dropping_ = false;
  std::uint32_t dropped_ = 0;  ///< the generation that ends by it; 0: what is queued comes again

  PathClock clock_;  ///< of a profile
  PaulSegment profile_;
  PathEvents profile_events_;
  double zero_ = 0;  ///< path time at its beginning
};

/// References on line by the look-ahead law.
class LookAheadGenerator final : public SegmentGenerator {
 public:
  /// `start`: where the axes stand, m, rad. Takes memory; nothing else here does.
  LookAheadGenerator(const RobotModel& robot, LookAheadBuffer& buffer, PathRing& ring,
                     const JointVector& start)
      : SegmentGenerator(robot, buffer, law_, start), law_(robot, ring, now(), events()) {}

 private:
  LookAheadLaw law_;
};

}  // namespace rob::motion
