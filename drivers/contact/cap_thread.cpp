#include "drivers/contact/cap_thread.h"

#include <algorithm>
#include <cmath>

#include "base/unit_factors.h"

namespace rob::drivers {

double CapThread::friction(double turned) const noexcept {
  const double risen = std::clamp((turned - (cap_.turns - cap_.rise)) / cap_.rise, 0.0, 1.0);
  return cap_.running_torque + risen * (cap_.slip_torque - cap_.running_torque);
}

double CapThread::sink(double turned) const noexcept { return cap_.pitch * turned / kFullTurn; }

void CapThread::turn(double way, double& turned) noexcept {
  twist_ += way;
  const double borne = friction(turned) / torsion_;
  if (std::abs(twist_) > borne) {
    const double moved = twist_ - std::copysign(borne, twist_);
    const double before = turned;
    turned = std::clamp(turned + moved, 0.0, cap_.turns);
    // Off its thread the cap turns with the hand.
    twist_ -= moved < 0 ? moved : turned - before;
  }
  const double slips = cap_.slip_torque / torsion_;
  twist_ = std::clamp(twist_, -slips, slips);
}

}  // namespace rob::drivers
