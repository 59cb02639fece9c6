#include "motion/plan/paul_segment.h"

namespace rob::motion {

namespace {

JointVector parameter(double s) noexcept { return JointVector::Constant(1, s); }

}  // namespace

void PaulSegment::begin(const SegmentDescriptor& segment, const JointVector& a,
                        const JointVector& b, double t_acc, bool from_rest) noexcept {
  before_ = leg_;
  leg_ = {segment.path, b, segment.target, segment.duration};
  corner_ = segment.corner;
  profile_ = segment.profile;
  if (profile_.present()) {
    kind_ = Kind::Profile;
  } else if (corner_ != nullptr && !from_rest) {
    kind_ = Kind::Corner;
  } else if (segment.path != nullptr) {
    kind_ = Kind::Ramp;
    law_ = PaulTransition(parameter(0), parameter(0), parameter(1), segment.duration, t_acc);
  } else {
    kind_ = Kind::Axes;
    law_ = PaulTransition(a, b, segment.target, segment.duration, t_acc);
  }
}

void PaulSegment::stop(const JointVector& a, const JointVector& b, double t_acc,
                       double duration) noexcept {
  if (leg_.path == nullptr || (a - b).isZero(0)) {
    kind_ = Kind::Axes;
    law_ = PaulTransition(a, b, b, duration, t_acc);
    leg_ = {nullptr, b, b, duration};
    return;
  }
  kind_ = Kind::Ramp;
  const double s = 1 - t_acc / leg_.duration;
  law_ = PaulTransition(parameter(s), parameter(1), parameter(1), duration, t_acc);
}

PathPoint PaulSegment::sample(double t) const noexcept {
  switch (kind_) {
    case Kind::Axes:
      return law_.sample(t);
    case Kind::Ramp: {
      const PathPoint s = law_.sample(t);
      return leg_.along(s.q[0], s.qd[0], s.qdd[0]);
    }
    case Kind::Corner:
      if (t < -corner_->half) return before_.at(before_.duration + t);
      if (t <= corner_->half) return corner_->axes.at(t);
      return leg_.at(t);
    case Kind::Profile: {
      const ProfileLaw::Point s = profile_.at(t);
      return leg_.along(s.share, s.rate, s.acceleration);
    }
  }
  return law_.sample(t);
}

}  // namespace rob::motion
