#include "tests/bench/first_organisation.h"

#include <chrono>
#include <cstdint>
#include <limits>
#include <thread>
#include <vector>

#include "motion/robots/robot_library.h"
#include "tests/bench/busy.h"
#include "tests/support/stepped_run.h"

namespace rob::bench {

namespace {

/// S1 knows one target beyond the one that it is heading for.
constexpr std::size_t kOneAhead = 1;

std::vector<motion::DriveData> drives_of(const motion::RobotModel& robot) {
  std::vector<motion::DriveData> drives;
  for (const motion::Axis& axis : robot.axes) drives.push_back(axis.drive);
  return drives;
}

/// A timer that is started now, whatever time it is.
void wait_from_now(double seconds) {
  std::this_thread::sleep_for(std::chrono::duration<double>(seconds));
}

}  // namespace

FirstOrganisation::FirstOrganisation(double work)
    : work_(work),
      robot_(motion::embedded_robot("gantry")),
      text_(runtime::compile_program("triangle.rob", test::kPublishedProgram, robot_)),
      buffer_(kOneAhead),
      planner_(robot_, robot_.start),
      generator_(robot_, buffer_, robot_.start),
      machine_(robot_, planner_, buffer_, channels_, channels_.program, log_),
      instructions_(text_.compilation.chunk.value(), machine_),
      law_(drives_of(robot_), robot_.servo_period),
      gantry_(test::simulated(robot_)),
      samples_(robot_.reference_period, 0) {
  gantry_->open();
}

FirstOrganisation::~FirstOrganisation() { gantry_->close(); }

Outcome FirstOrganisation::run() {
  fetch();
  clock_ = runtime::SystemClock();
  std::thread servo([this] { servo_loop(); });
  std::thread generator([this] { generator_loop(); });
  generator.join();
  servo.join();
  return samples_.outcome(measured_);
}

void FirstOrganisation::generator_loop() {
  for (std::int64_t number = 0;; ++number) {
    work_for(work_);
    channels_.references.push(generator_.advance(number).reference);
    measured_ = clock_.now();
    samples_.hand_out(number, measured_);
    if (finished()) break;
    wait_from_now(robot_.reference_period);
    fetch();
  }
  over_ = true;
}

/// The servo knows no times: it follows the reference that came last.
void FirstOrganisation::servo_loop() {
  motion::ServoState state;
  motion::ServoCommand command;
  const motion::JointVector zero = motion::JointVector::Zero(robot_.axis_count());
  command.reference = {0, robot_.start, zero, zero};
  gantry_->enable(clock_.now());
  law_.reset(clock_.now());
  while (!over_.load(std::memory_order_relaxed)) {
    work_for(work_);
    const double now = clock_.now();
    gantry_->read(now, state);
    while (channels_.references.take(command.reference)) {
    }
    command.drive = law_.update(now, command.reference, state.measured);
    gantry_->write(now, command);
    const double timer = clock_.now() + robot_.servo_period;
    while (clock_.now() < timer) {
    }
  }
  gantry_->disable(clock_.now());
}

/// The next instruction, as soon as there is room for it.
void FirstOrganisation::fetch() {
  if (program_state_ == runtime::ProgramTask::State::Over || buffer_.full()) return;
  work_for(work_);
  program_state_ = instructions_.step(std::numeric_limits<std::int64_t>::max());
}

bool FirstOrganisation::finished() {
  bool finished = false;
  motion::MotionEvent event;
  while (generator_.take_event(event)) {
    finished = finished || event.kind == motion::MotionEvent::Kind::Finished;
  }
  return finished;
}

}  // namespace rob::bench
