#include "motion/plan/segment_maker.h"

#include <cmath>
#include <memory>

#include "motion/plan/planned_segment.h"

namespace rob::motion {

namespace {

bool same(const Pose& a, const Pose& b) {
  return (a.position - b.position).norm() <= kSamePose &&
         a.orientation.angularDistance(b.orientation) <= kSamePose;
}

}  // namespace

SegmentDescriptor SegmentMaker::segment_to(const JointVector& target, bool no_length,
                                           const Timing& timing) const noexcept {
  SegmentDescriptor segment;
  segment.target = target;
  segment.duration = timing.duration;
  segment.t_acc_before = last_.t_acc;
  segment.t_acc = timing.t_acc;
  segment.no_length = no_length;
  segment.limit = timing.limit;
  segment.profile = timing.profile;
  return segment;
}

SegmentDescriptor SegmentMaker::joined(MotionDraft& draft, const Timing& timing,
                                       std::uint8_t& warnings) const {
  SegmentDescriptor segment = segment_to(draft.target, draft.no_length, timing);
  if (draft.leg != nullptr && draft.leg->axes) segment.path = &*draft.leg->axes;
  if (!last_.exact && !draft.no_length) join(draft, segment, warnings);
  return segment;
}

/// The corner out of the motion before, where S1's in the axes is not the one.
void SegmentMaker::join(MotionDraft& draft, SegmentDescriptor& segment,
                        std::uint8_t& warnings) const {
  const LastTarget::Before& before = last_.before;
  segment.from_rest = segment.profile.present();
  if (segment.from_rest) return;
  const bool straight = segment.path == nullptr && before.motion.path == nullptr;
  const bool bounded = robot_.tool_coordinates && std::isfinite(before.zone);
  if (straight && !bounded) return;
  if (draft.leg == nullptr) draft.leg = std::make_shared<PlannedLeg>();
  CornerTask task;
  task.in = before.motion;
  task.out = {segment.path, before.motion.to, segment.target, segment.duration};
  const auto line_of = [](const PlannedLeg* leg) {
    return leg != nullptr && leg->line ? &*leg->line : nullptr;
  };
  if (same(before.tool, tip_.pose())) {
    task.line_in = line_of(before.leg.get());
    task.line_out = line_of(draft.leg.get());
  }
  task.tip = tip_.pose();
  task.longest = segment.t_acc_before;
  task.zone = before.zone;
  task.braking = timing_.braking();
  draft.leg->corner = make_corner(robot_, task);
  if (draft.leg->corner) {
    segment.corner = &*draft.leg->corner;
  } else {
    segment.from_rest = true;
    warnings |= PlannedSegment::kCornerExact;
  }
}

}  // namespace rob::motion
