#include "drivers/contact/cell_scene.h"

#include <algorithm>

namespace rob::drivers {

using Eigen::Vector3d;
using motion::RackData;

namespace {

/// m above what it is set down on from which a tube or a cap still comes to stand. [choice]
constexpr double kSetDown = 2e-3;

}  // namespace

CellScene::CellScene(const motion::CellData& cell)
    : cell_(cell),
      racks_(cell.racks),
      law_{cell.contact.stiffness, cell.contact.damping_time, cell.contact.friction},
      sinking_{cell.contact.fall_speed, cell.contact.fall_resistance},
      thread_(cell.cap, cell.contact.torsion) {
  in_hole_.assign(static_cast<std::size_t>(racks_.holes()), kNone);
  for (int number = 0; number < racks_.holes(); ++number) {
    const RackData::Fill fill = racks_.fill(number);
    if (fill == RackData::Fill::Empty) continue;
    const Hole hole = racks_.hole(number);
    in_hole_[static_cast<std::size_t>(number)] = static_cast<int>(tubes_.size());
    Tube standing;
    standing.foot = {hole.mouth.x(), hole.mouth.y(), hole.bottom()};
    standing.hole = number;
    standing.capped = fill == RackData::Fill::CappedTubes;
    tubes_.push_back(standing);
  }
}

bool CellScene::capped(int hole) const noexcept {
  return occupied(hole) && tube(tube_in(hole)).capped;
}

double CellScene::cap_turned(int hole) const noexcept {
  return capped(hole) ? tube(tube_in(hole)).turned : 0;
}

void CellScene::step(const ToolMotion& tool, double dt) noexcept {
  const double way = tool.turn - tool_.turn;
  tool_ = tool;
  const Pressed pressed = touch(tool, dt, foot_);
  touching_ = pressed.touching;
  reaction_ = {pressed.place, pressed.force, 0};
  turn_cap(way);
}

bool CellScene::would_touch(const ToolMotion& tool) const noexcept {
  Foot foot = foot_;
  return touch(tool, kStep, foot).touching;
}

/// The tube that stands around x, y.
int CellScene::standing_at(double x, double y) const noexcept {
  const int hole = racks_.nearest(x, y);
  if (hole == RackGrid::kNone) return kNone;
  const int number = tube_in(hole);
  if (number == kNone) return kNone;
  const double beside = (tube(number).foot - Vector3d(x, y, 0)).head<2>().norm();
  return beside < cell_.tube.radius + cell_.gripper.reach ? number : kNone;
}

double CellScene::cap_bottom(const Tube& tube) const noexcept {
  return tube.foot.z() + cell_.tube.length - cell_.cap.overlap - thread_.sink(tube.turned);
}

double CellScene::top(const Tube& tube) const noexcept {
  return tube.capped ? cap_bottom(tube) + cell_.cap.height : tube.foot.z() + cell_.tube.length;
}

/// The tube that a cap there slips over.
int CellScene::under_cap(const Vector3d& cap) const noexcept {
  const int number = standing_at(cap.x(), cap.y());
  if (number == kNone || tube(number).capped) return kNone;
  const double beside = (tube(number).foot - cap).head<2>().norm();
  return beside <= cell_.gripper.reach ? number : kNone;
}

const motion::CapSupplyData* CellScene::supply_at(const Vector3d& place) const noexcept {
  for (const motion::CapSupplyData& supply : cell_.cap_supplies)
    if ((supply.place - place).head<2>().norm() <= cell_.gripper.reach) return &supply;
  return nullptr;
}

/// Height of what stands for good below a place.
double CellScene::obstacle(const Vector3d& place) const noexcept {
  if (const motion::CapSupplyData* supply = supply_at(place)) return supply->place.z();
  const int hole = racks_.nearest(place.x(), place.y());
  return hole == RackGrid::kNone ? cell_.table : racks_.hole(hole).mouth.z();
}

Carried CellScene::carried(const ToolMotion& tool) const noexcept {
  return {tool.tip - Vector3d(0, 0, below_tip_), tool.velocity};
}

Pressed CellScene::touch(const ToolMotion& tool, double dt, Foot& foot) const noexcept {
  const Carried end = carried(tool);
  if (held_ == Held::Tube) {
    const int hole = racks_.nearest(foot.place.x(), foot.place.y());
    if (hole != RackGrid::kNone && !occupied(hole))
      return carry_into(racks_.hole(hole), end, foot, dt, law_, sinking_);
  }
  const Pressed pressed = held_ == Held::Nothing ? touch_empty(tool) : touch_top(end, foot);
  foot = {pressed.place, false};
  return pressed;
}

/// A tube or a cap on what stands below it.
Pressed CellScene::touch_top(const Carried& end, const Foot& foot) const noexcept {
  const int below = standing_at(end.place.x(), end.place.y());
  double height = obstacle(end.place);
  if (below != kNone) height = top(tube(below));
  if (held_ == Held::Cap && under_cap(end.place) != kNone) height = cap_bottom(tube(below));
  return press({Vector3d(0, 0, height), Vector3d::UnitZ()}, end, foot.place, law_);
}

/// The palm on what is between the fingers, or their ends on what is below.
Pressed CellScene::touch_empty(const ToolMotion& tool) const noexcept {
  double height = obstacle(tool.tip) + cell_.gripper.fingers;
  const int below = standing_at(tool.tip.x(), tool.tip.y());
  if (below != kNone) height = std::max(height, top(tube(below)) - cell_.gripper.palm);
  if (const motion::CapSupplyData* supply = supply_at(tool.tip))
    height = supply->place.z() + cell_.cap.height - cell_.gripper.palm;
  const Plane plane{Vector3d(0, 0, height), Vector3d::UnitZ()};
  return press(plane, {tool.tip, tool.velocity}, foot_.place, law_);
}

/// A cap that is held turns on the thread of a tube that stands, as long as it is pressed.
void CellScene::turn_cap(double way) noexcept {
  if (held_ == Held::Nothing || (held_ == Held::Tube && !by_cap_)) return;
  if (held_ == Held::Cap) held_number_ = under_cap(foot_.place);
  if (held_number_ == kNone || reaction_.force.z() <= 0) return thread_.grip();
  Tube& turning = tube(held_number_);
  const double before = thread_.sink(turning.turned);
  thread_.turn(way, turning.turned);
  reaction_.torque = thread_.torque();
  const double sunk = thread_.sink(turning.turned) - before;
  if (held_ == Held::Tube) {
    below_tip_ -= sunk;  // the thread draws the tube up
    if (turning.turned == 0) unscrew();
  } else if (turning.turned > 0) {
    begin_thread(sunk);
  }
}

/// Cap and tube are one: from now on the hand carries the tube.
void CellScene::begin_thread(double sunk) noexcept {
  Tube& turning = tube(held_number_);
  turning.capped = true;
  in_hole_[static_cast<std::size_t>(turning.hole)] = kNone;
  turning.hole = kNone;
  held_ = Held::Tube;
  by_cap_ = true;
  below_tip_ += cell_.tube.length - cell_.cap.overlap - sunk;
  foot_ = {turning.foot, false};
}

void CellScene::close_jaws() noexcept {
  if (held_ != Held::Nothing) return;
  const int number = standing_at(tool_.tip.x(), tool_.tip.y());
  if (number != kNone && take_standing(number)) return;
  const motion::CapSupplyData* supply = supply_at(tool_.tip);
  if (supply == nullptr) return;
  const double up = foot_.place.z() - supply->place.z();
  if (up >= 0 && up <= cell_.cap.height) take(Held::Cap, kNone, supply->place);
}

void CellScene::open_jaws() noexcept {
  if (held_ == Held::Tube) leave_tube();
  if (held_ == Held::Cap) leave_cap();
  held_ = Held::Nothing;
  held_number_ = kNone;
  by_cap_ = false;
  below_tip_ = 0;
  foot_ = {tool_.tip, false};
}

// The force that presses the tip up stays the same.
void CellScene::take(Held held, int number, const Vector3d& lower_end) noexcept {
  held_ = held;
  held_number_ = number;
  below_tip_ = foot_.place.z() - lower_end.z();
  foot_ = {lower_end, false};
  thread_.grip();
}

bool CellScene::take_standing(int number) noexcept {
  Tube& standing = tube(number);
  const double tip = foot_.place.z();
  if ((standing.foot - tool_.tip).head<2>().norm() > cell_.gripper.reach) return false;
  if (tip > top(standing) || tip < obstacle(tool_.tip)) return false;
  const double cap = cap_bottom(standing);
  const bool at_cap = standing.capped && tip >= cap;
  if (at_cap && standing.turned == 0) {
    standing.capped = false;
    take(Held::Cap, number, {standing.foot.x(), standing.foot.y(), cap});
    return true;
  }
  take(Held::Tube, number, standing.foot);
  by_cap_ = at_cap;
  in_hole_[static_cast<std::size_t>(standing.hole)] = kNone;
  standing.hole = kNone;
  return true;
}

void CellScene::leave_tube() noexcept {
  const int number = racks_.nearest(foot_.place.x(), foot_.place.y());
  const bool free_hole = number != RackGrid::kNone && !occupied(number);
  const Hole hole = free_hole ? racks_.hole(number) : Hole{};
  if (!free_hole || !hole.over_mouth(foot_.place) || foot_.place.z() > hole.mouth.z() + kSetDown) {
    ++dropped_;
    return;
  }
  tube(held_number_).foot = {foot_.place.x(), foot_.place.y(), hole.bottom()};
  tube(held_number_).hole = number;
  in_hole_[static_cast<std::size_t>(number)] = held_number_;
}

/// The cap is off the thread: the tube stays where it stands, the hand keeps the cap.
void CellScene::unscrew() noexcept {
  leave_tube();
  tube(held_number_).capped = false;
  held_ = Held::Cap;
  by_cap_ = false;
  below_tip_ -= cell_.tube.length - cell_.cap.overlap;
  foot_.place.z() += cell_.tube.length - cell_.cap.overlap;
}

void CellScene::leave_cap() noexcept {
  const int below = under_cap(foot_.place);
  if (below != kNone && foot_.place.z() <= cap_bottom(tube(below)) + kSetDown) {
    tube(below).capped = true;
    tube(below).turned = 0;
    return;
  }
  ++dropped_;
}

}  // namespace rob::drivers
