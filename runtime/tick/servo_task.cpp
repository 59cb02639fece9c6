#include "runtime/tick/servo_task.h"

#include <vector>

#include "motion/servo/pulse_servo.h"
#include "motion/servo/servo_law.h"
#include "runtime/tick/axis_values.h"

namespace rob::runtime {

using motion::DriverStatus;
using motion::JointVector;

namespace {

/// The one that the robot file chooses.
std::unique_ptr<motion::Servo> servo_of(const motion::RobotModel& robot) {
  const std::vector<motion::DriveData> drives = drives_of(robot);
  if (robot.servo == motion::ServoStructure::Force)
    return std::make_unique<motion::ServoLaw>(drives, robot.servo_period, robot.mechanics);
  std::vector<motion::PulseDriveData> pulses;
  for (const motion::Axis& axis : robot.axes) pulses.push_back(axis.pulses);
  return std::make_unique<motion::PulseServo>(drives, pulses, robot.servo, robot.servo_period);
}

JointVector counts_of(const motion::RobotModel& robot) {
  JointVector counts(robot.axis_count());
  for (int i = 0; i < robot.axis_count(); ++i)
    counts[i] = robot.axes[static_cast<std::size_t>(i)].drive.encoder_resolution;
  return counts;
}

constexpr double kNoisyWire = 0.05;  // [choice] fault 25: 1 % is repeated, 10 % is reported

}  // namespace

ServoTask::ServoTask(const motion::RobotModel& robot, motion::ServoBackend& backend,
                     Channels& channels)
    : backend_(backend),
      channels_(channels),
      interpolator_(robot.reference_period, axis_values(robot, &motion::Axis::v_max),
                    axis_values(robot, &motion::Axis::a_max),
                    axis_values(robot, &motion::Axis::j_max)),
      servo_(servo_of(robot)),
      supervisor_(drives_of(robot), axis_values(robot, &motion::Axis::v_max),
                  axis_values(robot, &motion::Axis::a_max), robot.servo_period),
      lateness_(robot),
      touch_(robot),
      still_(counts_of(robot)) {
  const JointVector zero = JointVector::Zero(robot.axis_count());
  state_.measured = {0, robot.start, zero};
  command_.reference = {0, robot.start, zero, zero};
  command_.drive = zero;
}

/// Without an answer nothing is known of its speed.
DriverStatus ServoTask::read_machine(double now) noexcept {
  const DriverStatus status = backend_.read(now, state_);
  const bool answers = status == DriverStatus::Ok || status == DriverStatus::Alarm;
  answers_ = status != DriverStatus::Silent && status != DriverStatus::Lost;
  if (!answers) state_.measured.qd.setZero();
  if (answers) still_.look(state_.measured.q, state_.seen);
  return status;
}

void ServoTask::learn_stand(double now) noexcept {
  now_ = now;
  followed_ = now;
  read_machine(now);
  take_as_it_stands(now);
  channels_.inputs.store(state_.inputs, std::memory_order_relaxed);
  channels_.analog_inputs.store(state_.analog_inputs);
}

void ServoTask::enable(double now) noexcept {
  learn_stand(now);
  written_ = backend_.enable(now);
  enabled_ = true;
}

/// What follows starts from the measured position and joins the references slowly, wherever they
/// are.
void ServoTask::take_as_it_stands(double now) noexcept {
  const JointVector zero = JointVector::Zero(state_.measured.q.size());
  command_.reference = {now, state_.measured.q, zero, zero};
  interpolator_.rejoin(command_.reference);
  servo_->reset(now);
  supervisor_.reset(command_.reference, state_.measured);
  history_.reset(command_.reference);
}

motion::FollowingFinding ServoTask::judge(DriverStatus status) noexcept {
  using motion::FollowingFinding;
  const FollowingFinding found =
      supervisor_.check(status, history_.at(state_.measured.time), command_.reference.q,
                        state_.measured, state_.spread);
  if (found.verdict != FollowingFinding::Verdict::None || state_.wire_errors <= kNoisyWire)
    return found;
  return {FollowingFinding::Verdict::Warn, FollowingFinding::Cause::Noisy, -1, state_.wire_errors,
          kNoisyWire};
}

/// This computer was late, whatever the machine says.
motion::FollowingFinding ServoTask::overrun() const noexcept {
  using motion::FollowingFinding;
  return {FollowingFinding::Verdict::Stop, FollowingFinding::Cause::Overrun, -1, touch_.gap(),
          lateness_.longest_gap()};
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

void ServoTask::take_references() noexcept {
  motion::JointReference newest;
  while (channels_.references.take(newest)) {
    interpolator_.push(newest);
    lateness_.take(newest.time);
  }
}

/// A position that the machine reported after the gap: there the axes are braked from the velocity
/// that they have. Drives that have braked by themselves thus stay where they are.
bool ServoTask::find_machine(double instant, DriverStatus read) noexcept {
  if (read != DriverStatus::Ok || !touch_.finds(state_)) return false;
  take_as_it_stands(instant);
  touch_.brake(command_.reference, state_.measured.qd);
  return true;
}

void ServoTask::run(double now, double due) noexcept {
  const double instant = backend_.follows_references() ? due : now;
  const double gap = now - followed_;
  now_ = now;
  const DriverStatus read = read_machine(now);
  const DriverStatus status = read == DriverStatus::Ok ? written_ : read;
  if (guided_) {
    followed_ = now;
    return tell(status == DriverStatus::Ok ? motion::FollowingFinding{} : judge(status));
  }
  if (enabled_ && channels_.drives_off.load(std::memory_order_relaxed)) disable();
  if (gap > lateness_.longest_gap()) touch_.lose(now, gap);
  if (read == DriverStatus::Late && touch_.kept()) touch_.lose(now, state_.late);
  if (touch_.kept() && lateness_.references_are_coming(now, gap)) return tell({});
  followed_ = now;
  if (touch_.lost() && !find_machine(instant, read)) return tell(overrun());
  if (touch_.kept() && !lateness_.bridged(gap) && read == DriverStatus::Ok)
    interpolator_.join_from(found_at(instant));
  command_.reference = touch_.braked() ? touch_.at(instant) : interpolator_.at(instant);
  if (touch_.kept() && interpolator_.behind() > lateness_.most_behind()) {
    touch_.lose(now, interpolator_.behind());
    return tell(overrun());
  }
  history_.push(command_.reference);
  const motion::FollowingFinding finding = touch_.braked() ? overrun() : judge(status);
  follow(now, read);
  tell(finding);
}

/// Sends what the reference asks for.
void ServoTask::follow(double now, DriverStatus read) noexcept {
  const bool follows = backend_.follows_references();
  command_.outputs = channels_.outputs.load(std::memory_order_relaxed);
  command_.analog_outputs = channels_.analog_outputs.load();
  if (!enabled_ || (follows ? read == DriverStatus::Lost : read != DriverStatus::Ok)) return;
  if (const auto* const carried = channels_.carried.load(std::memory_order_acquire);
      carried != carried_) {
    servo_->carry(carried->all());
    command_.carried = carried_ = carried;
  }
  if (!follows) command_.drive = servo_->update(now, command_.reference, state_.measured);
  written_ = backend_.write(now, command_);
  still_.send(command_.reference.q, now);
}

void ServoTask::tell(const motion::FollowingFinding& finding) noexcept {
  const double saturation = servo_->take_saturation();
  ServoSample* const sample = channels_.samples.slot();
  if (sample == nullptr) return;  // a motion that is so late ends the run
  sample->finding = finding;
  sample->measured = state_.measured;
  sample->time = now_;
  if (!backend_.follows_references()) sample->measured.time = now_;
  sample->drive = command_.drive;
  sample->inputs = state_.inputs;
  sample->analog_inputs = state_.analog_inputs;
  sample->saturation = saturation;
  sample->felt.time = state_.wrench_time;
  if (state_.wrench_time != 0) sample->felt.wrench = state_.wrench;
  sample->reference = command_.reference;
  sample->braked = touch_.braked();
  sample->joining = touch_.kept() && interpolator_.joining();
  sample->settled = !backend_.follows_references() || !answers_ || still_.still();
  channels_.samples.push();
}

}  // namespace rob::runtime
