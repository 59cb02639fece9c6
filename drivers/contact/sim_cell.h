#pragma once

#include <cstdint>
#include <memory>
#include <string>

#include "drivers/contact/cell_scene.h"
#include "drivers/contact/force_sensor.h"
#include "drivers/sim/sim_machine.h"
#include "motion/cell/cell_data.h"
#include "motion/kinematics/kinematics.h"

namespace rob::drivers {

/// A simulated machine in its cell: the joints' true positions carry the tool through the scene,
/// and a force sensor after the flange measures what that does to it. Between two calls of read()
/// the tool goes straight on, in steps of CellScene::kStep while it touches anything.
///
/// A wrench is the reaction on the tool, about the flange's origin and along the flange's axes, and
/// late by the sensor's delay. The jaws take hold when the machine's actuator has closed them, and
/// let go as soon as it moves again; GripperData::held_input shows whether something is in them.
class SimCell final : public motion::ServoBackend {
 public:
  /// `sensor_delay`: s. Throws std::invalid_argument for a sensor that cannot be (ForceSensor).
  SimCell(std::unique_ptr<SimMachine> machine, std::shared_ptr<const motion::Kinematics> kinematics,
          const motion::CellData& cell, double sensor_delay);

  int axes() const noexcept override { return machine_->axes(); }
  /// Powers up in a cell as it was in the beginning.
  void open() override;
  void close() noexcept override { machine_->close(); }
  motion::DriverStatus enable(double now) noexcept override { return machine_->enable(now); }
  void disable(double now) noexcept override { machine_->disable(now); }
  motion::DriverStatus read(double now, motion::ServoState& state) noexcept override;
  motion::DriverStatus write(double now, const motion::ServoCommand& command) noexcept override {
    return machine_->write(now, command);
  }
  std::string trouble() const override { return machine_->trouble(); }

  // For tests and benches
  const CellScene& scene() const noexcept { return scene_; }
  ForceSensor& sensor() noexcept { return sensor_; }
  SimMachine& machine() noexcept { return *machine_; }

 private:
  motion::Pose flange() const noexcept;
  ToolMotion tool_at(const motion::Pose& flange) const noexcept;
  motion::Wrench wrench_at(const motion::Pose& flange) const noexcept;
  void advance_to(double now, const motion::Pose& flange) noexcept;
  void move_jaws(std::uint64_t inputs) noexcept;

  std::unique_ptr<SimMachine> machine_;
  std::shared_ptr<const motion::Kinematics> kinematics_;
  motion::CellData cell_;
  CellScene scene_;
  ForceSensor sensor_;

  bool started_ = false;  // the first read() gives the time
  bool closed_ = false;
  double time_ = 0;
  motion::Pose flange_;  // at time_
  ToolMotion tool_;
  std::int64_t sampled_ = 0;  // the sensor's last sample, counted from the clock's zero
};

}  // namespace rob::drivers
