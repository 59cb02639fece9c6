#include "motion/plan/drive_fit.h"

#include <cstdint>

#include "motion/plan/paul_segment.h"

namespace rob::motion {

namespace {

/// The demand of the part of a motion that must be slowed down most.
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

void DriveFit::suit(const ArmMechanics& mechanics, const MotionRequest& request, MotionDraft& draft,
                    Timing& timing) const {
  constexpr int kTurns = 4;  // [choice] places in the corner move a little with T1
  const auto suited = [&](Timing& trial, auto demanded) {
    for (int turn = 0; turn < kTurns; ++turn) {
      std::uint8_t unused = 0;
      const TorqueShare most = (this->*demanded)(mechanics, segments_.joined(draft, trial, unused));
      if (most.speed >= 1) return true;
      if (most.speed <= 0) return false;
      timing_.slow_down(most, request, trial);
    }
    return false;
  };
  suited(timing, &DriveFit::demanded_alone);
  Timing slower = timing;
  if (suited(slower, &DriveFit::demanded_by_corner)) timing = slower;
}

/// From rest to rest.
TorqueShare DriveFit::demanded_alone(const ArmMechanics& mechanics,
                                     const SegmentDescriptor& segment) const {
  Demanded all(robot_, mechanics);
  PaulSegment part;
  part.begin(segment, last_.q, last_.q, last_.t_acc, true);
  if (segment.profile.present()) {
    all.look(part, 0, segment.duration);
    return all.most();
  }
  const double end = segment.duration - segment.t_acc;
  all.look(part, -last_.t_acc, end);
  part.stop(part.sample(end).q, segment.target, segment.t_acc, 2 * segment.t_acc);
  all.look(part, -segment.t_acc, segment.t_acc);
  return all.most();
}

/// Out of the motion before; nothing where that is exact.
TorqueShare DriveFit::demanded_by_corner(const ArmMechanics& mechanics,
                                         const SegmentDescriptor& segment) const {
  if (last_.exact || segment.from_rest || segment.no_length) return {};
  const LegMotion& motion = last_.before.motion;
  SegmentDescriptor before;
  before.path = motion.path;
  before.target = motion.to;
  before.duration = motion.duration;
  PaulSegment part;
  part.begin(before, motion.from, motion.from, last_.t_acc, true);
  const JointVector a = motion.at(before.duration - last_.t_acc).q;
  part.begin(segment, a, last_.q, last_.t_acc, false);
  Demanded corner(robot_, mechanics);
  corner.look(part, -last_.t_acc, last_.t_acc);
  return corner.most();
}

}  // namespace rob::motion
