#include "motion/robots/arm_file.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "base/unit_factors.h"

namespace rob::motion {

namespace {

// [choice] They leave room for an arm under a microscope and for the longest that are built.
constexpr Range kBeside{-10, 10};
constexpr Range kHeight{-100, 100};
constexpr Range kUpperArm{1e-3, 10};
constexpr Range kForearm{0, 10};
constexpr Range kHand{0, 10};
constexpr Range kOffset{-kFullTurn, kFullTurn};

/// Shorter than this from axis 3 to the wrist is no forearm. [choice] as kUpperArm
constexpr double kShortest = 1e-3;

}  // namespace

std::shared_ptr<const ArmKinematics> read_arm(const TableReader& file,
                                              const std::vector<Axis>& axes) {
  const TableReader arm =
      file.table("arm", {"a1", "a2", "b", "c1", "c2", "c3", "c4", "signs", "offsets"});
  ArmParameters p;
  p.a1 = arm.quantity("a1", Quantity::Length, kBeside);
  p.a2 = arm.quantity("a2", Quantity::Length, kBeside);
  p.b = arm.quantity("b", Quantity::Length, kBeside);
  p.c1 = arm.quantity("c1", Quantity::Length, kHeight);
  p.c2 = arm.quantity("c2", Quantity::Length, kUpperArm);
  p.c3 = arm.quantity("c3", Quantity::Length, kForearm);
  p.c4 = arm.quantity("c4", Quantity::Length, kHand);
  if (std::hypot(p.a2, p.c3) < kShortest)
    arm.fail("c3", "the wrist must be at least 1 mm from axis 3");
  std::ranges::copy(arm.signs("signs", p.sign.size()), p.sign.begin());
  std::ranges::copy(arm.quantities("offsets", Quantity::Angle, kOffset, p.offset.size()),
                    p.offset.begin());
  ArmLimits limits;
  std::ranges::transform(axes, limits.min.begin(), [](const Axis& axis) { return axis.min; });
  std::ranges::transform(axes, limits.max.begin(), [](const Axis& axis) { return axis.max; });
  return std::make_shared<const ArmKinematics>(p, limits);
}

}  // namespace rob::motion
