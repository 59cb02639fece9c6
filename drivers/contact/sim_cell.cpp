#include "drivers/contact/sim_cell.h"

#include <algorithm>
#include <cmath>

#include "base/unit_factors.h"

namespace rob::drivers {

using Eigen::Vector3d;
using motion::DriverStatus;
using motion::Pose;

namespace {

// s. After a longer gap the contact begins anew: the tool is where it is, and nothing was sampled.
constexpr double kLongestGap = 0.05;

Pose between(const Pose& from, const Pose& to, double share) noexcept {
  Pose pose;
  pose.position = from.position + share * (to.position - from.position);
  const double near = from.orientation.dot(to.orientation) < 0 ? -1 : 1;
  pose.orientation.coeffs() =
      (1 - share) * near * from.orientation.coeffs() + share * to.orientation.coeffs();
  pose.orientation.normalize();
  return pose;
}

std::uint64_t bit(int channel) noexcept { return std::uint64_t{1} << channel; }

}  // namespace

SimCell::SimCell(std::unique_ptr<SimMachine> machine,
                 std::shared_ptr<const motion::Kinematics> kinematics, const motion::CellData& cell,
                 double sensor_delay)
    : machine_(std::move(machine)),
      kinematics_(std::move(kinematics)),
      cell_(cell),
      scene_(cell),
      sensor_(cell.sensor, sensor_delay, cell.seed) {}

void SimCell::open() {
  machine_->open();
  scene_ = CellScene(cell_);
  sensor_.clear();
  started_ = false;
  closed_ = false;
}

DriverStatus SimCell::read(double now, motion::ServoState& state) noexcept {
  const DriverStatus status = machine_->read(now, state);
  advance_to(now, flange());
  move_jaws(state.inputs);
  if (scene_.holds_something()) state.inputs |= bit(cell_.gripper.held_input);
  const ForceSensor::Told told = sensor_.told(now);
  state.wrench = told.wrench;
  state.wrench_time = told.time;
  return status;
}

Pose SimCell::flange() const noexcept {
  motion::JointVector q(machine_->axes());
  for (int i = 0; i < machine_->axes(); ++i) q[i] = machine_->true_position(i);
  return kinematics_->forward(q);
}

ToolMotion SimCell::tool_at(const Pose& flange) const noexcept {
  ToolMotion tool;
  tool.tip = motion::place_of(Vector3d(0, 0, cell_.gripper.tip), flange);
  const Vector3d x = flange.orientation * Vector3d::UnitX();
  const double turn = -std::atan2(x.y(), x.x());
  tool.turn = tool_.turn + std::remainder(turn - tool_.turn, kFullTurn);
  return tool;
}

motion::Wrench SimCell::wrench_at(const Pose& flange) const noexcept {
  const Reaction& reaction = scene_.reaction();
  const Vector3d lever = reaction.point - flange.position;
  const Vector3d torque = lever.cross(reaction.force) + Vector3d(0, 0, reaction.torque);
  const Eigen::Quaterniond seen = flange.orientation.conjugate();
  return {seen * reaction.force, seen * torque};
}

// In steps that end where the sensor takes its samples, and shorter ones where something is
// touched.
void SimCell::advance_to(double now, const Pose& flange) noexcept {
  const ToolMotion goal = tool_at(flange);
  const double begin = time_;
  const Pose before = flange_;
  ToolMotion tool = tool_;
  if (!started_ || now - begin > kLongestGap) {
    started_ = true;
    time_ = now;
    sampled_ = static_cast<std::int64_t>(std::floor(now / sensor_.period()));
    scene_.step(goal, CellScene::kStep);
  }
  const Vector3d way = goal.tip - tool.tip;
  const double turned = goal.turn - tool.turn;
  const double span = now - begin;
  while (time_ < now) {
    const double due = static_cast<double>(sampled_ + 1) * sensor_.period();
    const double fine = scene_.touching() || scene_.would_touch(goal) ? CellScene::kStep : span;
    const double next = std::max(time_, std::min({now, due, time_ + fine}));
    const double share = (next - begin) / span;
    tool.tip = tool_.tip + share * way;
    tool.velocity = way / span;
    tool.turn = tool_.turn + share * turned;
    scene_.step(tool, next - time_);
    time_ = next;
    if (next < due) continue;
    ++sampled_;
    sensor_.take(due, wrench_at(between(before, flange, share)));
  }
  tool_ = goal;
  flange_ = flange;
}

void SimCell::move_jaws(std::uint64_t inputs) noexcept {
  const bool closed = (inputs & bit(cell_.gripper.closed_input)) != 0;
  if (closed == closed_) return;
  closed_ = closed;
  closed ? scene_.close_jaws() : scene_.open_jaws();
}

}  // namespace rob::drivers
