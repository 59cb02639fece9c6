#include "drivers/contact/hole.h"

#include <algorithm>
#include <numbers>

namespace rob::drivers {

using Eigen::Vector3d;

namespace {

Vector3d level(const Vector3d& way) noexcept { return {way.x(), way.y(), 0}; }

Pressed on_face(const Hole& hole, const Carried& carried, const Vector3d& before,
                const ContactLaw& law) noexcept {
  return press({hole.mouth, Vector3d::UnitZ()}, carried, before, law);
}

Pressed on_chamfer(const Hole& hole, const Carried& carried, const Vector3d& before,
                   const ContactLaw& law) noexcept {
  const Vector3d beside = level(before - hole.mouth);
  const double distance = beside.norm();
  if (distance <= hole.clearance) return {carried.place, Vector3d::Zero(), false};
  const Vector3d outwards = beside / distance;
  const Plane slope{hole.mouth + (hole.clearance + hole.chamfer) * outwards,
                    (Vector3d::UnitZ() - outwards) / std::numbers::sqrt2};
  const Pressed pressed = press(slope, carried, before, law);
  // Over the edge and out again.
  if (pressed.place.z() > hole.mouth.z()) return on_face(hole, carried, before, law);
  return pressed;
}

Pressed in_bore(const Hole& hole, const Carried& carried, const Vector3d& before,
                const ContactLaw& law) noexcept {
  const Vector3d beside = level(carried.place - hole.mouth);
  const double distance = beside.norm();
  if (distance <= hole.clearance) return {carried.place, Vector3d::Zero(), false};
  const Vector3d outwards = beside / distance;
  Pressed pressed =
      press({hole.mouth + hole.clearance * outwards, -outwards}, carried, before, law);
  const Vector3d led = level(pressed.place - hole.mouth);  // on the tangent, outside of the circle
  pressed.place.head<2>() += ((hole.clearance / led.norm() - 1) * led).head<2>();
  return pressed;
}

/// The tube comes no deeper than it sinks in `dt`; the tool's spring bears the difference.
void hold_up(Pressed& pressed, const Carried& carried, const Vector3d& before, double dt,
             const ContactLaw& law, const Sinking& sinking) noexcept {
  const double pressing = std::max(0.0, law.stiffness * (before.z() - carried.place.z()));
  const double least = before.z() - (sinking.speed + pressing / sinking.resistance) * dt;
  if (pressed.place.z() >= least) return;
  pressed.place.z() = least;
  pressed.force.z() = law.stiffness * (least - carried.place.z());
  pressed.touching = true;
}

void stop_at_bottom(Pressed& pressed, const Hole& hole, const Carried& carried,
                    const Vector3d& before, const ContactLaw& law) noexcept {
  if (pressed.place.z() >= hole.bottom()) return;
  const Plane bottom{Vector3d(hole.mouth.x(), hole.mouth.y(), hole.bottom()), Vector3d::UnitZ()};
  const Pressed stopped = press(bottom, carried, before, law);
  if (pressed.touching) {  // the wall leads it sideways
    pressed.place.z() = stopped.place.z();
    pressed.force.z() = stopped.force.z();
    return;
  }
  pressed = stopped;
}

}  // namespace

Pressed carry_into(const Hole& hole, const Carried& carried, Foot& foot, double dt,
                   const ContactLaw& law, const Sinking& sinking) noexcept {
  const Vector3d before = foot.place;
  const double depth = hole.mouth.z() - before.z();
  Pressed pressed;
  if (!hole.over_mouth(before)) {
    pressed = on_face(hole, carried, before, law);
    foot.tilted = pressed.touching;
  } else {
    pressed = depth < hole.chamfer ? on_chamfer(hole, carried, before, law)
                                   : in_bore(hole, carried, before, law);
    foot.tilted = foot.tilted && depth < Sinking::kNeck && carried.place.z() < hole.mouth.z();
    if (foot.tilted) hold_up(pressed, carried, before, dt, law, sinking);
    stop_at_bottom(pressed, hole, carried, before, law);
  }
  foot.place = pressed.place;
  return pressed;
}

}  // namespace rob::drivers
