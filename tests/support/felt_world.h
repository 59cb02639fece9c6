#pragma once

#include <deque>
#include <functional>
#include <memory>
#include <utility>

#include "motion/kinematics/kinematics.h"
#include "motion/servo/servo_backend.h"

namespace rob::test {

/// A machine with a force sensor, in a world that is a function: what acts on the tool, along the
/// axes of the world, at an instant and a pose of the flange. The sensor tells it so many servo
/// cycles later, along the axes of the flange. SI.
class FeltWorld final : public motion::ServoBackend {
 public:
  using Acts = std::function<motion::Wrench(double time, const motion::Pose& flange)>;

  FeltWorld(std::unique_ptr<motion::ServoBackend> machine,
            std::shared_ptr<const motion::Kinematics> kinematics, Acts acts, int late = 0)
      : machine_(std::move(machine)),
        kinematics_(std::move(kinematics)),
        acts_(std::move(acts)),
        late_(late) {}

  int axes() const noexcept override { return machine_->axes(); }
  void open() override { machine_->open(); }
  void close() noexcept override { machine_->close(); }
  motion::DriverStatus enable(double now) noexcept override { return machine_->enable(now); }
  void disable(double now) noexcept override { machine_->disable(now); }

  motion::DriverStatus read(double now, motion::ServoState& state) noexcept override {
    const motion::DriverStatus status = machine_->read(now, state);
    const motion::Pose flange = kinematics_->forward(state.measured.q);
    const motion::Wrench acting = acts_(now, flange);
    const auto back = flange.orientation.conjugate();
    told_.push_back({back * acting.force, back * acting.torque});
    if (static_cast<int>(told_.size()) > late_ + 1) told_.pop_front();
    if (silent) return status;
    state.wrench = told_.front();
    state.wrench_time = now;
    return status;
  }
  motion::DriverStatus write(double now, const motion::ServoCommand& command) noexcept override {
    return machine_->write(now, command);
  }

  bool silent = false;  ///< the sensor says nothing more

 private:
  std::unique_ptr<motion::ServoBackend> machine_;
  std::shared_ptr<const motion::Kinematics> kinematics_;
  Acts acts_;
  int late_;
  std::deque<motion::Wrench> told_;
};

}  // namespace rob::test
