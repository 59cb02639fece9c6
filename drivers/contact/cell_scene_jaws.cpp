#include "drivers/contact/cell_scene.h"

namespace rob::drivers {

using Eigen::Vector3d;

namespace {

// m above what it is set down on from which a tube or a cap still comes to stand. [choice]
constexpr double kSetDown = 2e-3;

}  // namespace

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

// What the tip is pressed up by stays so.
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
