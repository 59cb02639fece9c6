#pragma once

#include <algorithm>
#include <deque>
#include <optional>

#include "motion/dynamics/arm_mechanics.h"

namespace rob::motion {

/// The mechanics of an arm with each load that it has carried so far. They keep their addresses:
/// planned motions point to them.
class CarryingArms {
 public:
  /// `bare` must outlive it; none: nothing is known of the arm, or it is none.
  explicit CarryingArms(const std::optional<ArmMechanics>& bare) : bare_(bare ? &*bare : nullptr) {}

  /// Null where there is no arm.
  const ArmMechanics* with(const ArmLoad& load) {
    if (bare_ == nullptr || load == ArmLoad{}) return bare_;
    const auto known = std::ranges::find(arms_, load, &Carrying::load);
    return known != arms_.end() ? &known->arm
                                : &arms_.emplace_back(Carrying{load, bare_->carrying(load)}).arm;
  }

 private:
  struct Carrying {
    ArmLoad load;
    ArmMechanics arm;
  };
  const ArmMechanics* bare_;
  std::deque<Carrying> arms_;
};

}  // namespace rob::motion
