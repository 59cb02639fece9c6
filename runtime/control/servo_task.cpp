#include "runtime/control/servo_task.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "motion/servo/pulse_servo.h"
#include "motion/servo/servo_law.h"

namespace rob::runtime {

using motion::DriverStatus;
using motion::JointVector;

namespace {

std::vector<motion::DriveData> drives_of(const motion::RobotModel& robot) {
  std::vector<motion::DriveData> drives;
  for (const motion::Axis& axis : robot.axes) drives.push_back(axis.drive);
  return drives;
}

/// The one that the robot file chooses.
std::unique_ptr<motion::Servo> servo_of(const motion::RobotModel& robot) {
  const std::vector<motion::DriveData> drives = drives_of(robot);
  if (robot.servo == motion::ServoStructure::Force)
    return std::make_unique<motion::ServoLaw>(drives, robot.servo_period, robot.mechanics);
  std::vector<motion::PulseDriveData> pulses;
  for (const motion::Axis& axis : robot.axes) pulses.push_back(axis.pulses);
  return std::make_unique<motion::PulseServo>(drives, pulses, robot.servo, robot.servo_period);
}

JointVector limits_of(const motion::RobotModel& robot, double motion::Axis::*limit) {
  JointVector values(robot.axis_count());
  for (int i = 0; i < robot.axis_count(); ++i) {
    values[i] = robot.axes[static_cast<std::size_t>(i)].*limit;
  }
  return values;
}

constexpr double kNoisyWire = 0.05;  // [choice] fault 25: 1 % is repeated, 10 % is told

/// s between two cycles. As much lateness as the generator makes up (20 reference periods, at least
/// 200 ms), and the period itself: after more the machine has been on its own.
double longest_gap(const motion::RobotModel& robot) {
  return std::max(20 * robot.reference_period, 0.2) + robot.reference_period;
}

}  // namespace

ServoTask::ServoTask(const motion::RobotModel& robot, motion::ServoBackend& backend,
                     Channels& channels)
    : backend_(backend),
      channels_(channels),
      interpolator_(robot.reference_period, limits_of(robot, &motion::Axis::v_max),
                    limits_of(robot, &motion::Axis::a_max), limits_of(robot, &motion::Axis::j_max)),
      servo_(servo_of(robot)),
      supervisor_(drives_of(robot), limits_of(robot, &motion::Axis::v_max),
                  limits_of(robot, &motion::Axis::a_max), robot.servo_period),
      reference_period_(robot.reference_period),
      bridged_gap_((motion::ReferenceInterpolator::kLongestGap - 1) *
                   std::max(robot.reference_period, robot.servo_period)),
      longest_gap_(longest_gap(robot)) {
  const JointVector zero = JointVector::Zero(robot.axis_count());
  state_.measured = {0, robot.start, zero};
  command_.reference = {0, robot.start, zero, zero};
  command_.drive = zero;
}

void ServoTask::learn_stand(double now) noexcept {
  now_ = now;
  followed_ = now;
  backend_.read(now, state_);
  take_as_it_stands(now);
  channels_.inputs.store(state_.inputs, std::memory_order_relaxed);
  channels_.analog_inputs.store(state_.analog_inputs);
}

void ServoTask::enable(double now) noexcept {
  learn_stand(now);
  written_ = backend_.enable(now);
  enabled_ = true;
}

/// What follows starts from the measured place and joins the references slowly, wherever they are.
void ServoTask::take_as_it_stands(double now) noexcept {
  const JointVector zero = JointVector::Zero(state_.measured.q.size());
  command_.reference = {now, state_.measured.q, zero, zero};
  interpolator_.rejoin(command_.reference);
  servo_->reset(now);
  supervisor_.reset(command_.reference, state_.measured);
  history_.reset(command_.reference);
}

/// The whole process was stopped for a while, and this thread came back before the one that makes
/// the references: what it lacks, or the instant from which it holds, is about to come. Until then
/// the drives go on as they were told.
bool ServoTask::references_are_coming(double now, double gap) const noexcept {
  return gap > bridged_gap_ && gap <= longest_gap_ && std::abs(now - newest_) > reference_period_;
}

/// Nobody looked after the machine for too long: its drives have stopped it by themselves, and
/// where it should be by now no longer counts.
motion::FollowingFinding ServoTask::judge(DriverStatus status, double gap) noexcept {
  using motion::FollowingFinding;
  if (gap <= longest_gap_) {
    const FollowingFinding found = supervisor_.check(status, history_.at(state_.measured.time),
                                                     state_.measured, state_.spread);
    if (found.verdict != FollowingFinding::Verdict::None || state_.wire_errors <= kNoisyWire)
      return found;
    return {FollowingFinding::Verdict::Warn, FollowingFinding::Cause::Noisy, -1, state_.wire_errors,
            kNoisyWire};
  }
  return {FollowingFinding::Verdict::Stop, FollowingFinding::Cause::Overrun, -1, gap, longest_gap_};
}

void ServoTask::guide(double now) noexcept {
  learn_stand(now);
  guided_ = true;
}

void ServoTask::disable() noexcept {
  backend_.disable(now_);
  enabled_ = false;
}

/// Where the machine is after a moment on its own. One that follows references has stayed at the
/// last one.
motion::JointReference ServoTask::found_at(double instant) const noexcept {
  const JointVector zero = JointVector::Zero(state_.measured.q.size());
  if (backend_.follows_references()) return {instant, command_.reference.q, zero, zero};
  return {instant, state_.measured.q, state_.measured.qd, zero};
}

void ServoTask::cycle(double now, double due) noexcept {
  const bool follows = backend_.follows_references();
  const double instant = follows ? due : now;
  const double gap = now - followed_;
  now_ = now;
  const DriverStatus read = backend_.read(now, state_);
  const DriverStatus status = read == DriverStatus::Ok ? written_ : read;
  if (gap > longest_gap_ && read == DriverStatus::Ok) take_as_it_stands(instant);
  motion::JointReference newest;
  while (channels_.references.take(newest)) {
    interpolator_.push(newest);
    newest_ = newest.time;
  }
  if (guided_) {
    followed_ = now;
    return tell(status == DriverStatus::Ok ? motion::FollowingFinding{} : judge(status, 0));
  }
  if (enabled_ && channels_.drives_off.load(std::memory_order_relaxed)) disable();
  if (references_are_coming(now, gap)) return tell({});
  followed_ = now;
  if (gap > bridged_gap_ && gap <= longest_gap_ && read == DriverStatus::Ok) {
    interpolator_.join_from(found_at(instant));
  }
  command_.reference = interpolator_.at(instant);
  history_.push(command_.reference);
  command_.outputs = channels_.outputs.load(std::memory_order_relaxed);
  command_.analog_outputs = channels_.analog_outputs.load();

  const motion::FollowingFinding finding = judge(status, gap);
  if (enabled_ && (follows ? read != DriverStatus::Lost : read == DriverStatus::Ok)) {
    if (!follows) command_.drive = servo_->update(now, command_.reference, state_.measured);
    written_ = backend_.write(now, command_);
  }
  tell(finding);
}

void ServoTask::tell(const motion::FollowingFinding& finding) noexcept {
  ServoSample sample;
  sample.finding = finding;
  sample.measured = state_.measured;
  sample.time = now_;
  sample.measured.time = backend_.follows_references() ? state_.measured.time : now_;
  sample.drive = command_.drive;
  sample.inputs = state_.inputs;
  sample.analog_inputs = state_.analog_inputs;
  sample.saturation = servo_->take_saturation();
  sample.felt = {state_.wrench_time, state_.wrench};
  channels_.samples.push(sample);
}

}  // namespace rob::runtime
