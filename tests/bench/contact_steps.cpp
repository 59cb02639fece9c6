/// How many steps a second the contact model makes on one core (docs/performance.md), in each kind
/// of contact, of the goal of 2·10⁶. Of the simulated LWA 4P's cell, with all its holes and tubes.
#include <fmt/format.h>

#include <cmath>
#include <functional>

#include "drivers/contact/cell_scene.h"
#include "motion/robots/robot_library.h"
#include "tests/bench/busy.h"

namespace {

using Eigen::Vector3d;
using rob::drivers::CellScene;
using rob::drivers::ToolMotion;
using rob::motion::CellData;

constexpr double kGoal = 2e6;  // steps/s
constexpr int kSteps = 4'000'000;
constexpr double kStep = CellScene::kStep;

/// A scene and the tool that is led through it.
class Hand {
 public:
  explicit Hand(const CellData& cell) : scene_(cell) {}

  void put(const Vector3d& tip) {
    tool_.tip = tip;
    scene_.step(tool_, kStep);
  }
  void step(const Vector3d& velocity, double turning = 0) {
    tool_.velocity = velocity;
    tool_.tip += velocity * kStep;
    tool_.turn += turning * kStep;
    scene_.step(tool_, kStep);
  }
  void sink(double speed, double way) {
    for (double left = way; left > 0; left -= speed * kStep) step(Vector3d(0, 0, -speed));
  }
  CellScene& scene() { return scene_; }

 private:
  CellScene scene_;
  ToolMotion tool_;
};

/// Back and forth with `speed` along x, over `way`.
struct Sway {
  double speed = 0;  // m/s
  double way = 0;    // m
  int at = 0;

  Vector3d next() {
    const int half = static_cast<int>(way / (speed * kStep));
    return {at++ / half % 2 == 0 ? speed : -speed, 0, 0};
  }
};

/// Steps a second while `step` goes on; the scene has to touch something throughout.
void print_rate(const char* what, Hand& hand, const std::function<void()>& step) {
  const double begin = rob::bench::thread_time();
  int touching = 0;
  for (int i = 0; i < kSteps; ++i) {
    step();
    touching += hand.scene().touching() ? 1 : 0;
  }
  const double rate = kSteps / (rob::bench::thread_time() - begin);
  fmt::print("{:<34} {:>5.2f} million steps/s, {:>4.1f} of the goal; in contact {:.0f} %\n", what,
             rate * 1e-6, rate / kGoal, 100.0 * touching / kSteps);
}

/// The tube of the supply's first hole, carried to above `place` with its end at `height`.
void fetch_tube(Hand& hand, const Vector3d& place, double height) {
  hand.put(Vector3d(0.22, 0.13, 0.1));  // 90 mm above the tube's lower end
  hand.scene().close_jaws();
  hand.put(Vector3d(0.22, 0.13, 0.3));
  hand.put(Vector3d(place.x(), place.y(), height + 0.09));
}

void measure(const CellData& cell) {
  const Vector3d searched(0.36, 0, 0.06);
  {
    Hand hand(cell);
    hand.put(Vector3d(0.1, 0.0, 0.0051));
    hand.sink(0.001, 0.3e-3);
    Sway sway{0.01, 0.02};
    print_rate("fingers on the table", hand, [&] { hand.step(sway.next()); });
  }
  {
    Hand hand(cell);
    fetch_tube(hand, searched - Vector3d(0.012, 0, 0), searched.z());
    hand.sink(0.001, 0.1e-3);
    Sway sway{0.01, 0.008};
    print_rate("a tube on the face of a rack", hand, [&] { hand.step(sway.next()); });
  }
  {
    Hand hand(cell);
    fetch_tube(hand, searched + Vector3d(2.4e-3, -1.8e-3, 0), searched.z());
    hand.sink(0.003, 0.01);
    hand.sink(0.01, 0.03);
    for (int i = 0; i < 1000; ++i) hand.step(Vector3d(0.005, 0, 0));
    Sway sway{1e-4, 1e-4};
    print_rate("a tube on the wall of its hole", hand, [&] { hand.step(sway.next()); });
  }
  {
    Hand hand(cell);
    hand.put(Vector3d(0.46, 0, 0.122));
    hand.sink(0.005, 12.4e-3);
    hand.scene().close_jaws();
    for (int i = 0; i < 1200; ++i) hand.step(Vector3d::Zero(), 1);
    Sway turning{1, 0.2};  // rad/s, rad
    print_rate("a cap pressed and turned on a tube", hand,
               [&] { hand.step(Vector3d::Zero(), turning.next().x()); });
  }
}

}  // namespace

int main() { measure(*rob::motion::embedded_robot("lwa4p").cell); }
