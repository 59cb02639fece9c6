#include "drivers/contact/plane_contact.h"

#include <algorithm>

namespace rob::drivers {

using Eigen::Vector3d;

Pressed press(const Plane& plane, const Carried& carried, const Vector3d& before,
              const ContactLaw& law) noexcept {
  const double depth = plane.normal.dot(plane.point - carried.place);
  if (depth <= 0) return {carried.place, Vector3d::Zero(), false};
  const double rate = -plane.normal.dot(carried.velocity);
  const double across = law.stiffness * std::max(0.0, depth + law.damping_time * rate);
  const Vector3d below = carried.place + depth * plane.normal;  // on the plane, without friction
  Vector3d way = before - below;
  way -= plane.normal.dot(way) * plane.normal;
  const double stretched = law.stiffness * way.norm();
  const double most = law.friction * across;
  if (stretched > most) way *= most / stretched;
  return {below + way, across * plane.normal + law.stiffness * way, true};
}

}  // namespace rob::drivers
