#include "drivers/sim_gantry.h"

#include <stdexcept>

namespace rob::drivers {

using motion::JointVector;

SimGantry::SimGantry(const SimGantryParameters& parameters)
    : SimMachine(parameters.start, parameters.actuators) {
  const auto count = static_cast<Eigen::Index>(parameters.drives.size());
  if (count > motion::kMaxJoints || parameters.start.size() != count)
    throw std::invalid_argument("SimGantry: drives and start position differ in number");
  for (const motion::DriveData& drive : parameters.drives) axes_.emplace_back(drive);
  SimMachine::open();
}

void SimGantry::place(const JointVector& q) noexcept {
  for (std::size_t i = 0; i < axes_.size(); ++i) axes_[i].place(q[static_cast<Eigen::Index>(i)]);
}

void SimGantry::push(const JointVector& drive) noexcept {
  for (std::size_t i = 0; i < axes_.size(); ++i) axes_[i].push(drive[static_cast<Eigen::Index>(i)]);
}

void SimGantry::hold() noexcept {
  for (SimAxis& axis : axes_) axis.hold();
}

void SimGantry::release() noexcept {
  for (SimAxis& axis : axes_) axis.release();
}

void SimGantry::advance(double dt) noexcept {
  for (SimAxis& axis : axes_) axis.advance(dt);
}

void SimGantry::sample() noexcept {
  for (SimAxis& axis : axes_) axis.sample();
}

void SimGantry::settle() noexcept {
  for (SimAxis& axis : axes_) axis.settle();
}

void SimGantry::measure(JointVector& q, JointVector& qd) const noexcept {
  for (std::size_t i = 0; i < axes_.size(); ++i) {
    q[static_cast<Eigen::Index>(i)] = axes_[i].measured_q();
    qd[static_cast<Eigen::Index>(i)] = axes_[i].measured_v();
  }
}

}  // namespace rob::drivers
