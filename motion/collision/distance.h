#pragma once

#include "motion/collision/collision_data.h"

/// How far a capsule is from another body, m, both in one frame: 0 or less where they touch. There
/// it is minus the way by which one of them must be moved at least so that they do not. Closed
/// forms without memory.
namespace rob::motion {

double distance(const Capsule& capsule, const Sphere& sphere) noexcept;
double distance(const Capsule& a, const Capsule& b) noexcept;
double distance(const Capsule& capsule, const Box& box) noexcept;
double distance(const Capsule& capsule, const HalfSpace& below) noexcept;
double distance(const Capsule& capsule, const std::shared_ptr<const ConvexBody>& body) noexcept;
double distance(const Capsule& capsule, const Obstacle& obstacle) noexcept;

}  // namespace rob::motion
