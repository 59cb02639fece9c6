#include <cmath>

#include "motion/plan/motion_planner.h"
#include "motion/plan/paul_segment.h"
#include "motion/plan/torque_share.h"

/// Member functions of MotionPlanner for what gears and drives can give.
namespace rob::motion {

namespace {

/// What parts of a motion ask for: of the one that must be slowed down most.
class Demanded {
 public:
  Demanded(const RobotModel& robot, const ArmMechanics& mechanics)
      : robot_(robot), mechanics_(mechanics) {}

  void look(const PaulSegment& part, double begin, double end) {
    const TorqueShare here = torque_share_along(
        robot_, &mechanics_, [&](double t) { return part.sample(t); }, begin, end);
    if (here.speed < most_.speed || (here.speed == 1 && here.share > most_.share)) most_ = here;
  }
  const TorqueShare& most() const { return most_; }

 private:
  const RobotModel& robot_;
  const ArmMechanics& mechanics_;
  TorqueShare most_;
};

}  // namespace

/// Slows a motion down until its gears and drives suffice, in the corner too if that helps; else
/// it will have to begin at rest. A weight that they do not bear is not the planner's: the servo
/// will tell.
void MotionPlanner::suit_drives(Draft& draft, const MotionRequest& request, Timing& timing) const {
  constexpr int kTurns = 4;  // [choice] places in the corner move a little with T1
  const auto suited = [&](Timing& trial, auto demanded) {
    for (int turn = 0; turn < kTurns; ++turn) {
      std::uint8_t unused = 0;
      const TorqueShare most = demanded(joined(draft, trial, unused));
      if (most.speed >= 1) return true;
      if (most.speed <= 0) return false;
      slow_down(trial, most, request);
    }
    return false;
  };
  suited(timing, [&](const SegmentDescriptor& segment) { return demanded_alone(segment); });
  Timing slower = timing;
  if (suited(slower, [&](const SegmentDescriptor& segment) { return demanded_by_corner(segment); }))
    timing = slower;
}

void MotionPlanner::slow_down(Timing& timing, const TorqueShare& most,
                              const MotionRequest& request) const {
  // The accelerations of a profile go down with the square of its speed.
  const double share = timing.profile.present() ? std::sqrt(most.speed) : most.speed;
  timing.duration /= share;
  if (timing.profile.present()) timing.profile = timing.profile.slowed(share);
  timing.limit = static_cast<std::uint8_t>(10 + most.axis);
  if (request.at_least > 0 && timing.duration * boost_ > request.at_least)
    timing.warnings |= PlannedSegment::kStretched;
  if (request.pace != MotionRequest::Pace::Unspecified) timing.warnings |= PlannedSegment::kPaceCut;
}

/// From rest to rest.
TorqueShare MotionPlanner::demanded_alone(const SegmentDescriptor& segment) const {
  Demanded all(robot_, *mechanics_);
  PaulSegment part;
  part.begin(segment, commanded_, commanded_, t_acc_before_, true);
  if (segment.profile.present()) {
    all.look(part, 0, segment.duration);
    return all.most();
  }
  const double end = segment.duration - segment.t_acc;
  all.look(part, -t_acc_before_, end);
  part.stop(part.sample(end).q, segment.target, segment.t_acc, 2 * segment.t_acc);
  all.look(part, -segment.t_acc, segment.t_acc);
  return all.most();
}

/// Out of the motion before; nothing where that is exact.
TorqueShare MotionPlanner::demanded_by_corner(const SegmentDescriptor& segment) const {
  if (exact_ || segment.from_rest || segment.no_length) return {};
  SegmentDescriptor before;
  before.path = before_.motion.path;
  before.target = before_.motion.to;
  before.duration = before_.motion.duration;
  PaulSegment part;
  part.begin(before, before_.motion.from, before_.motion.from, t_acc_before_, true);
  const JointVector a = before_.motion.at(before.duration - t_acc_before_).q;
  part.begin(segment, a, commanded_, t_acc_before_, false);
  Demanded corner(robot_, *mechanics_);
  corner.look(part, -t_acc_before_, t_acc_before_);
  return corner.most();
}

}  // namespace rob::motion
