#include "motion/collision/jog_room.h"

namespace rob::motion {

void JogRoom::look(double now) noexcept {
  now_ = now;
  while (views_.at(1) != nullptr) views_.pop();
}

int JogRoom::stops(const JointVector& q) const noexcept {
  if (!used_) return kFree;
  const View* const view = views_.front();
  if (view == nullptr || now_ - view->time > kOld) return kUnknown;
  const JointVector way = q - view->q;
  for (int i = 0; i < view->count; ++i) {
    const Near& near = view->near[static_cast<std::size_t>(i)];
    if (!may(near, way)) return near.pair;
  }
  return view->levers.dot(way.cwiseAbs()) > view->others - kKept ? kOther : kFree;
}

bool JogRoom::may(const Near& near, const JointVector& way) noexcept {
  constexpr double kParts = -0.02;  // [choice] of the way: along a body, but for rounding
  const double most = near.levers.dot(way.cwiseAbs());
  if (most <= near.distance - kKept) return true;
  if (most > kTrusted) return false;
  const double parts = near.up.dot(way.cwiseMax(0)) - near.down.dot(way.cwiseMin(0));
  return parts >= 0 || (parts >= kParts * most && near.distance - most > kLeast);
}

}  // namespace rob::motion
