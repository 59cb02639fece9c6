/// The contact model beside MuJoCo on the same scene: a point on springs is pressed on a plane and
/// drawn along it (docs/performance.md). Built where libmujoco-dev is installed.
#include <fmt/format.h>
#include <mujoco/mujoco.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstring>
#include <memory>
#include <stdexcept>
#include <vector>

#include "drivers/contact/plane_contact.h"

namespace {

using Eigen::Vector3d;
using rob::drivers::Carried;
using rob::drivers::ContactLaw;
using rob::drivers::Pressed;

constexpr double kStiffness = 50e3;  // N/m, of the springs: a cell of S4
constexpr double kFriction = 0.2;
constexpr double kStep = 0.25e-3;  // s, of the model
constexpr int kFiner = 25;         // MuJoCo's steps in one: its tip has a mass
constexpr double kDown = 2e-3;     // m/s, for 0.1 s: 10 N
constexpr double kAlong = 1e-3;    // m/s, for 0.2 s: 0.2 mm, slipping from 0.04 mm on

/// A ball of 5 g without gravity, on springs to where it is commanded, over a plane 400 times as
/// stiff as they are: MuJoCo's stiffness is solref·mass·d/(1 − d), d of solimp.
constexpr const char* kScene = R"(
<mujoco>
  <option timestep="1e-5" gravity="0 0 0" cone="elliptic" impratio="100" noslip_iterations="20"/>
  <default><joint type="slide" damping="30"/><position kp="50000"/></default>
  <worldbody>
    <geom name="plane" type="plane" size="1 1 1" friction="0.2" solref="-440000000 -42000" solimp="0.9 0.9 0.001"/>
    <body pos="0 0 0.001">
      <joint name="x" axis="1 0 0"/><joint name="y" axis="0 1 0"/><joint name="z" axis="0 0 1"/>
      <geom type="sphere" size="0.001" mass="0.005" friction="0.2" solref="-440000000 -42000" solimp="0.9 0.9 0.001"
            condim="3"/>
    </body>
  </worldbody>
  <actuator><position joint="x"/><position joint="y"/><position joint="z"/></actuator>
</mujoco>
)";

/// Where the carried point would be at `t`, and how it moves.
Carried carried_at(double t) {
  const double down = std::min(t, 0.1), along = std::clamp(t - 0.2, 0.0, 0.2);
  return {{kAlong * along, 0, -kDown * down},
          {t > 0.2 && t < 0.4 ? kAlong : 0, 0, t < 0.1 ? -kDown : 0}};
}

class Engine {
 public:
  Engine() {
    const auto files = std::make_unique<mjVFS>();
    mj_defaultVFS(files.get());
    const std::size_t size = std::strlen(kScene);
    mj_makeEmptyFileVFS(files.get(), kFile, static_cast<int>(size));
    std::memcpy(files->filedata[mj_findFileVFS(files.get(), kFile)], kScene, size);
    char trouble[500] = "";
    model_ = mj_loadXML(kFile, files.get(), trouble, sizeof trouble);
    mj_deleteVFS(files.get());
    if (model_ == nullptr) throw std::runtime_error(trouble);
    data_ = mj_makeData(model_);
  }
  ~Engine() {
    mj_deleteData(data_);
    mj_deleteModel(model_);
  }
  Engine(const Engine&) = delete;
  Engine& operator=(const Engine&) = delete;

  /// The force of the plane on the point, N: across it and along x.
  Vector3d step(const Carried& carried) {
    for (int i = 0; i < 3; ++i) data_->ctrl[i] = carried.place[i];
    for (int i = 0; i < kFiner; ++i) mj_step(model_, data_);
    // At rest what the springs hold is what the plane does.
    return {kStiffness * (data_->qpos[0] - carried.place[0]), 0,
            kStiffness * (data_->qpos[2] - carried.place[2])};
  }

 private:
  static constexpr const char* kFile = "scene.xml";
  mjModel* model_ = nullptr;
  mjData* data_ = nullptr;
};

int compare() {
  Engine engine;
  const ContactLaw law{kStiffness, 0, kFriction};
  const rob::drivers::Plane plane;
  Vector3d place = Vector3d::Zero();
  double most = 0;
  fmt::print("|   s | across N | MuJoCo | along N | MuJoCo |\n|---|---|---|---|---|\n");
  for (int k = 1; k <= 1800; ++k) {
    const double t = k * kStep;
    const Carried carried = carried_at(t);
    const Pressed pressed = press(plane, carried, place, law);
    place = pressed.place;
    const Vector3d other = engine.step(carried);
    most = std::max(most, (pressed.force - other).norm());
    if (k % 200 == 0)
      fmt::print("| {:.2f} | {:.3f} | {:.3f} | {:.3f} | {:.3f} |\n", t, pressed.force.z(),
                 other.z(), pressed.force.x(), other.x());
  }
  fmt::print("At most {:.3f} N apart, of 10 N.\n", most);
  constexpr double kSame = 0.1;  // N [choice] 1 %; the damping of MuJoCo's joints is 0.03 N of it
  return most < kSame ? 0 : 1;
}

}  // namespace

int main() {
  try {
    return compare();
  } catch (const std::exception& error) {
    fmt::print(stderr, "contact_mujoco: {}\n", error.what());
    return 70;
  }
}
