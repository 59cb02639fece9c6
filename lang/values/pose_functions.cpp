#include "lang/values/pose_functions.h"

#include <array>
#include <optional>

#include "lang/values/pose_slots.h"
#include "lang/values/tool_fit.h"

namespace rob::lang::pose_functions {
namespace {

Error store_finite(const PoseValue& pose, Slot* result) {
  if (!pose_math::is_finite(pose)) return Error::NotFinite;
  store(pose, result);
  return Error::None;
}

std::optional<ToolFit> fit_of(Arguments a) {
  std::array<PoseValue, kMostToolPoses> poses;
  const std::size_t count = a.size() / kPoseSlots;
  for (std::size_t i = 0; i < count; ++i) poses[i] = load_pose(&a[i * kPoseSlots]);
  return fit_tool(std::span(poses).first(count));
}

}  // namespace

Error pose_of(Arguments a, Slot& r) {
  const auto angle = [&](std::size_t i) { return i < a.size() ? to_si(a[i].real, kAngle) : 0; };
  return store_finite(
      {load_vector(a.data()), pose_math::from_fixed({.a = angle(3), .b = angle(4), .c = angle(5)})},
      &r);
}

Error pose_at(Arguments a, Slot& r) {
  return store_finite({load_vector(a.data()), load_pose(&a[3]).rotation}, &r);
}

Error pose_of_zyz(Arguments a, Slot& r) {
  const auto angle = [&](std::size_t i) { return to_si(a[i].real, kAngle); };
  return store_finite({load_vector(a.data()), pose_math::from_zyz(angle(3), angle(4), angle(5))},
                      &r);
}

Error pose_of_quat(Arguments a, Slot& r) {
  const auto rotation = pose_math::normalized({a[3].real, a[4].real, a[5].real, a[6].real});
  if (!rotation) return Error::ZeroQuaternion;
  return store_finite({load_vector(a.data()), *rotation}, &r);
}

Error inverse_of(Arguments a, Slot& r) {
  return store_finite(pose_math::inverse(load_pose(a.data())), &r);
}

Error pose_distance(Arguments a, Slot& r) {
  return arithmetic::store_finite(
      pose_math::distance(load_pose(a.data()), load_pose(&a[kPoseSlots])), r.real);
}

Error pose_turn(Arguments a, Slot& r) {
  r.real = from_si(pose_math::turn(load_pose(a.data()), load_pose(&a[kPoseSlots])), kAngle);
  return Error::None;
}

Error pose_mix(Arguments a, Slot& r) {
  const auto mixed =
      pose_math::mix(load_pose(a.data()), load_pose(&a[kPoseSlots]), a[2 * kPoseSlots].real);
  return mixed ? store_finite(*mixed, &r) : Error::OppositePoses;
}

Error seen_from(Arguments a, Slot& r) {
  const PoseValue world_t_frame = load_pose(&a[kPoseSlots]);
  return store_finite(pose_math::compose(pose_math::inverse(world_t_frame), load_pose(a.data())),
                      &r);
}

Error frame_three(Arguments a, Slot& r) {
  const auto frame = pose_math::frame_through(load_vector(a.data()), load_vector(&a[kPoseSlots]),
                                              load_vector(&a[2 * kPoseSlots]));
  return frame ? store_finite(*frame, &r) : Error::CollinearPlaces;
}

Error tool_four(Arguments a, Slot& r) {
  const auto fit = fit_of(a);
  return fit ? store_finite({fit->tip, {}}, &r) : Error::ToolNotTurned;
}

Error tool_miss(Arguments a, Slot& r) {
  const auto fit = fit_of(a);
  return fit ? arithmetic::store_finite(fit->miss, r.real) : Error::ToolNotTurned;
}

Error transformed(const Slot* p, const Slot* v, Slot* result) {
  const PoseValue there{pose_math::transform(load_pose(p), load_vector(v)), {}};
  if (!pose_math::is_finite(there)) return Error::NotFinite;
  store(there.position, result);
  return Error::None;
}

void angle(const Slot* p, int which, Slot& result) {
  const FixedAngles angles = pose_math::to_fixed(load_pose(p).rotation);
  result.real = from_si(which == 0 ? angles.a : which == 1 ? angles.b : angles.c, kAngle);
}

}  // namespace rob::lang::pose_functions
