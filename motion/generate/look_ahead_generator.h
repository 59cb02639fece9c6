#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>

#include "motion/ahead/path_ring.h"
#include "motion/ahead/reference_average.h"
#include "motion/generate/guide_history.h"
#include "motion/generate/path_clock.h"
#include "motion/generate/path_events.h"
#include "motion/generate/place_events.h"
#include "motion/generate/segment_generator.h"
#include "motion/plan/paul_segment.h"

namespace rob::motion {

/// References on line by the look-ahead law: the mean (ReferenceAverage) of a guide that runs along
/// the path as fast as what is known of it allows (Guide). The path comes from a PathPlanner,
/// through the ring; the LookAheadBuffer is here for its effects alone.
///
/// A reference has the mean of the guide's σ, and events go by that σ, too: a motion begins in the
/// middle of the corner that leads to it, where the target before it is passed, and path events are
/// due at their places, all at their exact instants. At a standstill the references
/// come to rest later than the guide by the mean's time. What then follows begins at the next
/// stamp.
///
/// Hold, brake and a lower override slow the guide on the path, as hard as the axes can. Where
/// nothing is known it stands within what is; the PathPlanner tells when that was too late.
///
/// A motion with a profile runs in its own time, scaled as under Paul's law.
///
/// What ends early takes the path ahead with it. Until the PathPlanner has given it up nothing is
/// told and nothing begins.
///
/// Sample: sigma is the way on its motion, m; rate m/s; limit_numbers.h.
class LookAheadGenerator final : public SegmentGenerator {
 public:
  /// `start`: where the axes stand, m, rad. Takes memory; nothing else here does.
  LookAheadGenerator(const RobotModel& robot, LookAheadBuffer& buffer, PathRing& ring,
                     const JointVector& start);

  void set_override(double share) noexcept override;
  bool take_event(MotionEvent& event) noexcept override {
    return !dropping_ && SegmentGenerator::take_event(event);
  }

 private:
  const SegmentDescriptor* next_segment() const noexcept override;
  void pop_segment() noexcept override;
  bool closed() const noexcept override { return !dropping_ && ring_.closed.load(); }
  bool begins_at_stamp(const SegmentDescriptor& next) const noexcept override;
  void go_on_to_stamp() noexcept override;
  void skip(double gap) noexcept override;
  void pass_targets() noexcept override;
  double end() const noexcept override;
  bool ends_at_rest() const noexcept override { return true; }
  void begin(const SegmentDescriptor& next, double instant) noexcept override;
  void end_path() noexcept override;
  void drop_path(std::uint32_t generation) noexcept override;
  void sample_path(GeneratorSample& sample) const noexcept override;
  double sigma_at_rest() const noexcept override { return leg_.way(length()); }
  double share_done() const noexcept override;
  bool settled() const noexcept override;
  std::optional<double> stands_since() const noexcept override;
  std::uint32_t decided() const noexcept override;
  bool tells_decisions() const noexcept override { return true; }
  const Effect* take_path_event(double until, std::uint32_t number, double& due) noexcept override;
  bool awaits_path_event() const noexcept override {
    return events_.pending() || profile_events_.pending();
  }

  bool profiled() const noexcept { return segment().profile.present(); }
  /// Under way on the path of the guide.
  bool on_run() const noexcept { return on_path() && run_; }
  double length() const noexcept { return end_ - begin_; }
  double guide_time() const noexcept { return stamp() - skipped_; }
  /// s by which a reference lags behind the guide.
  double lag() const noexcept { return (average_.periods() - 1) * period() / 2; }
  /// When what the guide did at `time` shows in the references.
  double told(double time) const noexcept { return time + lag() + skipped_; }
  /// σ of the references.
  double cursor() const noexcept { return average_.sigma(); }
  bool beyond_end() const noexcept;
  std::optional<double> passed_end() const noexcept;
  double arrival() const noexcept;
  void step_guide() noexcept;
  double live_pace() noexcept;
  void tell_missed_leads() noexcept;
  void finish_drop() noexcept;
  void begin_run(const PathLeg& leg) noexcept;
  void begin_profile(const SegmentDescriptor& next) noexcept;
  void expect_events(const SegmentDescriptor& next, double instant) noexcept;

  PathRing& ring_;
  Guide guide_;
  ReferenceAverage average_;
  GuideHistory history_;
  PlaceEvents events_;
  bool run_ = false;    ///< the segment is part of a path from rest to rest
  double skipped_ = 0;  ///< s of the run that the guide's time has not
  double begin_ = 0;    ///< σ of the segment under way
  double end_ = 0;
  PathLeg leg_;         ///< of the segment under way
  double arrival_ = 0;  ///< of a segment without a way
  PathRing::Index released_ = 0;
  std::uint32_t late_ = 0;  ///< PathRing::late, as told
  bool moved_ = false;      ///< the axes stand elsewhere than the guide
  bool dropping_ = false;
  std::uint32_t dropped_ = 0;  ///< the generation that ends by it; 0: what is queued comes again

  PathClock clock_;  ///< of a profile
  PaulSegment profile_;
  PathEvents profile_events_;
  double zero_ = 0;  ///< path time at its beginning
};

}  // namespace rob::motion
