#include "lang/vm/observations.h"

#include <array>
#include <span>

#include "lang/machine/robot_signature.h"
#include "lang/machine/seen_from.h"
#include "lang/values/pose_slots.h"

namespace rob::lang {
namespace {

/// Whether joints bring the tool to a point. A points file has 0.001 mm and 0.0001 deg, so each
/// number is off by half of that at most. The place of the pose is then off by sqrt(3) * 0.5 um,
/// and each rotary axis, by 8.7e-7 rad, moves the tool by 0.9 um for each metre of its lever: 50 um
/// are reached with levers of 56 m together. Turns add up to 8.7e-7 rad for each of three angles
/// and of the axes: to 1e-5 rad with eight. [choice] A tool or frame that has been measured anew
/// differs by more.
constexpr double kSamePlace = 5e-5;  // m
constexpr double kSameTurn = 1e-5;   // rad

using Axes = std::array<double, kMaxCoordinates>;

/// In SI.
Axes load_axes(const Slot* slots, std::span<const Dimension> dimensions) {
  Axes axes{};
  for (std::size_t i = 0; i < dimensions.size(); ++i) {
    axes[i] = to_si(slots[i].real, dimensions[i]);
  }
  return axes;
}

}  // namespace

Reply read_signal(Machine& machine, int line, const Instruction* pc, Slot* n) {
  bool value = false;
  const Reply reply = machine.read_signal(line, pc->x(), value);
  if (reply == Reply::Done) n[pc->a()].integer = value ? 1 : 0;
  return reply;
}

Reply read_group(Machine& machine, int line, const Instruction* pc, Slot* n) {
  return machine.read_group(line, pc->x(), static_cast<int>((pc + 1)->word), n[pc->a()].integer);
}

Reply read_analog(Machine& machine, int line, const Instruction* pc, Slot* n) {
  return machine.read_analog(line, pc->x(), n[pc->a()].real);
}

Reply read_value(Machine& machine, int line, const Instruction* pc, Slot* n, const Setting& setting,
                 const Chunk& chunk) {
  const auto what = static_cast<Reading>(pc->b());
  Slot* const value = &n[pc->a()];
  std::array<Slot, kPoseSlots> tool{};
  Reply reply = Reply::Done;
  const bool by_tool = needs_sensor(what) && setting.in_tool;
  if (by_tool) reply = machine.read(line, Reading::Here, tool.data());
  if (reply == Reply::Done) reply = machine.read(line, what, value);
  if (reply != Reply::Done) return reply;
  turn_into_frame(what, setting, load_pose(tool.data()), value);
  read_in_units(what, axes_of(chunk), value);
  return reply;
}

Reply exists(Machine& machine, int line, const Instruction* pc, Slot* n, const std::string* t) {
  bool there = false;
  const Reply reply = machine.exists(line, t[pc->b()], there);
  if (reply == Reply::Done) n[pc->a()].integer = there ? 1 : 0;
  return reply;
}

Reply forward(Machine& machine, int line, const Instruction* pc, Slot* n, const Chunk& chunk) {
  const Axes axes = load_axes(&n[pc->b()], axes_of(chunk));
  PoseValue pose;
  const Reply reply = machine.forward(line, {axes.data(), pc->c()}, pose);
  if (reply == Reply::Done) store(from_si(pose), &n[pc->a()]);
  return reply;
}

Reply at_joints(Machine& machine, int line, const Instruction* pc, Slot* n, const Chunk& chunk) {
  using pose_math::operator-;
  const std::size_t count = (pc + 1)->word;
  const Axes axes = load_axes(&n[pc->b()], axes_of(chunk));
  const PoseValue asked = to_si(load_pose(&n[pc->c()]));
  PoseValue pose;
  const Reply reply = machine.forward(line, {axes.data(), count}, pose);
  if (reply != Reply::Done) return reply;
  const bool same = pose_math::length(pose.position - asked.position) <= kSamePlace &&
                    pose_math::turn(pose, asked) <= kSameTurn;
  n[pc->a()].integer = same ? 1 : 0;
  return reply;
}

Reply inverse(Machine& machine, int line, const Instruction* pc, Slot* n, const Chunk& chunk) {
  const std::size_t count = (pc + 1)->word;
  const bool near = pc->b() != pc->c();
  const std::span<const Dimension> dimensions = axes_of(chunk);
  const Axes from = near ? load_axes(&n[pc->c()], dimensions) : Axes{};
  Axes found{};
  const Reply reply =
      machine.inverse(line, to_si(load_pose(&n[pc->b()])), std::span(from.data(), near ? count : 0),
                      std::span(found.data(), count));
  for (std::size_t i = 0; reply == Reply::Done && i < count; ++i) {
    n[pc->a() + i].real = from_si(found[i], dimensions[i]);
  }
  return reply;
}

Reply publish(Machine& machine, int line, const Instruction* pc, Stack& stack, Budget& budget) {
  const auto first = static_cast<std::size_t>(stack.numbers()[pc->a()].integer);
  const std::uint32_t count = (pc + 1)->word;
  budget.charge(count);
  if (pc->b() != 0) return machine.publish(line, first, stack.texts_at(first, count));
  return machine.publish(line, first, stack.numbers_at(first, count));
}

Reply publish_list(Machine& machine, int line, const Instruction* pc, Stack& stack,
                   Budget& budget) {
  const Slot home = stack.numbers()[pc->a()];
  const ListElements& list = stack.list_at(home);
  budget.charge(list.count);
  return machine.publish_list(line, static_cast<std::size_t>(home.integer),
                              {list.size, list.count, list.numbers, list.texts});
}

Reply refresh(Machine& machine, int line, const Instruction* pc, Stack& stack, Budget& budget) {
  const std::size_t first = (pc + 1)->word;
  const std::uint32_t count = (pc + 2)->word;
  budget.charge(count);
  if (pc->a() != 0) return machine.refresh(line, first, stack.texts_at(first, count));
  return machine.refresh(line, first, stack.numbers_at(first, count));
}

}  // namespace rob::lang
