#include <array>
#include <span>
#include <string>

#include "lang/text/codes.h"
#include "lang/values/pose_slots.h"
#include "lang/vm/vm.h"

/// Member functions of Vm that ask the Machine where axes bring the tool, and what it has felt.
namespace rob::lang {
namespace {

/// Whether joints bring the tool to a point. [choice] What a points file loses by its digits is far
/// less, and a tool or frame that has been measured anew differs by more.
constexpr double kSamePlace = 1e-6;  // m
constexpr double kSameTurn = 1e-6;   // rad

using Axes = std::array<double, kMaxCoordinates>;

Axes load_axes(const Slot* slots, std::size_t count) {
  Axes axes{};
  for (std::size_t i = 0; i < count; ++i) axes[i] = slots[i].real;
  return axes;
}

}  // namespace

Reply Vm::forward(Code pc) {
  const Axes axes = load_axes(&numbers_[pc->b()], pc->c());
  PoseValue pose;
  const Reply reply = machine_->forward(line(pc), {axes.data(), pc->c()}, pose);
  if (reply == Reply::Done) store(pose, &numbers_[pc->a()]);
  return reply;
}

Reply Vm::at_joints(Code pc) {
  using pose_math::operator-;
  const std::size_t count = (pc + 1)->word;
  const Axes axes = load_axes(&numbers_[pc->b()], count);
  const PoseValue asked = load_pose(&numbers_[pc->c()]);
  PoseValue pose;
  const Reply reply = machine_->forward(line(pc), {axes.data(), count}, pose);
  if (reply != Reply::Done) return reply;
  const bool same = pose_math::length(pose.position - asked.position) <= kSamePlace &&
                    pose_math::turn(pose, asked) <= kSameTurn;
  numbers_[pc->a()].integer = same ? 1 : 0;
  return reply;
}

Reply Vm::inverse(Code pc) {
  const std::size_t count = (pc + 1)->word;
  const bool near = pc->b() != pc->c();
  const Axes from = near ? load_axes(&numbers_[pc->c()], count) : Axes{};
  Axes found{};
  const Reply reply =
      machine_->inverse(line(pc), load_pose(&numbers_[pc->b()]),
                        std::span(from.data(), near ? count : 0), std::span(found.data(), count));
  for (std::size_t i = 0; reply == Reply::Done && i < count; ++i) {
    numbers_[pc->a() + i].real = found[i];
  }
  return reply;
}

Reply Vm::simulate_force(Code pc) {
  const Slot* const slots = &numbers_[pc->a()];
  return machine_->simulate_force(line(pc), pc->b(), slots[0].real, slots[1].real);
}

bool Vm::check_hit_pose(Code pc) {
  if (guarded_ || static_cast<Reading>(pc->b()) != Reading::HitPose) return true;
  error_ = {.code = std::string(code::kNoHit),
            .place = place(pc),
            .message = "there is no HITPOSE yet: no motion with UNTIL has been executed",
            .help = "MOVE(140, 40, 0) UNTIL touched comes first"};
  return false;
}

}  // namespace rob::lang
