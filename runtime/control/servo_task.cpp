#include "runtime/control/servo_task.h"

#include <vector>

namespace rob::runtime {

using motion::DriverStatus;
using motion::JointVector;

namespace {

std::vector<motion::DriveData> drives_of(const motion::RobotModel& robot) {
  std::vector<motion::DriveData> drives;
  for (const motion::Axis& axis : robot.axes) drives.push_back(axis.drive);
  return drives;
}

JointVector limits_of(const motion::RobotModel& robot, double motion::Axis::*limit) {
  JointVector values(robot.axis_count());
  for (int i = 0; i < robot.axis_count(); ++i) {
    values[i] = robot.axes[static_cast<std::size_t>(i)].*limit;
  }
  return values;
}

}  // namespace

ServoTask::ServoTask(const motion::RobotModel& robot, motion::ServoBackend& backend,
                     Channels& channels)
    : backend_(backend),
      channels_(channels),
      interpolator_(robot.reference_period, limits_of(robot, &motion::Axis::v_max),
                    limits_of(robot, &motion::Axis::a_max)),
      law_(drives_of(robot), robot.servo_period),
      supervisor_(drives_of(robot), limits_of(robot, &motion::Axis::v_max), robot.servo_period) {
  const JointVector zero = JointVector::Zero(robot.axis_count());
  state_.measured = {0, robot.start, zero};
  command_.reference = {0, robot.start, zero, zero};
  command_.drive = zero;
}

void ServoTask::enable(double now) noexcept {
  now_ = now;
  command_.reference.time = now;
  interpolator_.reset(command_.reference);
  law_.reset(now);
  backend_.read(now, state_);
  supervisor_.reset(command_.reference, state_.measured);
  written_ = backend_.enable(now);
  enabled_ = true;
}

void ServoTask::disable() noexcept {
  backend_.disable(now_);
  enabled_ = false;
}

void ServoTask::cycle(double now) noexcept {
  now_ = now;
  const DriverStatus read = backend_.read(now, state_);
  const DriverStatus status = read == DriverStatus::Ok ? written_ : read;
  motion::JointReference newest;
  while (channels_.references.take(newest)) interpolator_.push(newest);
  command_.reference = interpolator_.at(now);
  command_.outputs = channels_.outputs.load(std::memory_order_relaxed);

  ServoSample sample;
  sample.finding = supervisor_.check(status, command_.reference, state_.measured);
  if (enabled_ && read == DriverStatus::Ok) {
    command_.drive = law_.update(now, command_.reference, state_.measured);
    written_ = backend_.write(now, command_);
  }
  sample.measured = state_.measured;
  sample.measured.time = now;
  sample.drive = command_.drive;
  sample.inputs = state_.inputs;
  sample.saturation = law_.take_saturation();
  channels_.samples.push(sample);
}

}  // namespace rob::runtime
