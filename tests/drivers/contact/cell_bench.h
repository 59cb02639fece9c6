#pragma once

#include <numbers>

#include "drivers/contact/cell_scene.h"
#include "motion/cell/cell_data.h"

namespace rob::test {

/// A small cell with round figures: table at 0; a tube of 100 mm in each hole 50 mm deep of a rack
/// of three by two, face at 60 mm; an empty hole at (0.3, 0), one with a loose cap on its tube at
/// (0.4, 0); caps at (0.5, 0, 0.04). 50 N/mm without damping and friction.
inline motion::CellData small_cell() {
  using Fill = motion::RackData::Fill;
  motion::CellData cell;
  cell.contact = {50e3, 0, 0, 100, 3e-3, 2000};
  cell.gripper = {0, 2, 0.12, 5e-3, 10e-3, 3e-3};
  cell.tube = {0.1, 8e-3};
  cell.cap = {0.015, 5e-3, 3e-3, 3.5 * std::numbers::pi, 0.15, std::numbers::pi / 4, 1.4};
  motion::RackData rack{0, 0, 0.06, 0.05, 0.022, 1e-3, 0.05e-3, 3, 2, Fill::Tubes, {0, 0}};
  cell.racks.push_back(rack);
  rack.columns = 1;
  rack.rows = 1;
  rack.pitch = 0.04;
  rack.x = 0.3;
  rack.fill = Fill::Empty;
  cell.racks.push_back(rack);
  rack.x = 0.4;
  rack.fill = Fill::CappedTubes;
  cell.racks.push_back(rack);
  cell.cap_supplies.push_back({{0.5, 0, 0.04}});
  return cell;
}

constexpr int kEmptyHole = 6;  // of small_cell()
constexpr int kCappedHole = 7;

/// Moves a scene's tool along straight lines, in steps of CellScene::kStep.
class SceneHand {
 public:
  explicit SceneHand(drivers::CellScene& scene) : scene_(scene) {}

  void put(const Eigen::Vector3d& tip) {
    tool_.tip = tip;
    tool_.velocity.setZero();
    scene_.step(tool_, drivers::CellScene::kStep);
  }
  /// Goes there with `speed`, m/s, until `done()`; whether it was.
  template <typename Done>
  bool go(const Eigen::Vector3d& tip, double speed, Done done) {
    const Eigen::Vector3d way = tip - tool_.tip;
    const double length = way.norm();
    const int steps = static_cast<int>(length / speed / drivers::CellScene::kStep + 0.5);
    const Eigen::Vector3d from = tool_.tip;
    tool_.velocity = way * (speed / length);
    for (int i = 1; i <= steps; ++i) {
      tool_.tip = from + way * i / steps;
      scene_.step(tool_, drivers::CellScene::kStep);
      if (done()) return true;
    }
    return false;
  }
  void go(const Eigen::Vector3d& tip, double speed) {
    go(tip, speed, [] { return false; });
  }
  void rest(double time) {
    tool_.velocity.setZero();
    for (double t = 0; t < time; t += drivers::CellScene::kStep)
      scene_.step(tool_, drivers::CellScene::kStep);
  }
  /// Turns clockwise by `way`, rad, and goes down by `lower`, m, meanwhile.
  void turn(double way, double lower = 0, int steps = 4000) {
    tool_.velocity.setZero();
    for (int i = 0; i < steps; ++i) {
      tool_.turn += way / steps;
      tool_.tip.z() -= lower / steps;
      scene_.step(tool_, drivers::CellScene::kStep);
    }
  }
  const drivers::ToolMotion& tool() const { return tool_; }
  double force() const { return scene_.reaction().force.z(); }

 private:
  drivers::CellScene& scene_;
  drivers::ToolMotion tool_;
};

}  // namespace rob::test
