#include "runtime/run/machine.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "motion/robots/time_scaling.h"
#include "runtime/files/points_file.h"
#include "runtime/run/interruption.h"
#include "runtime/run/simulation.h"
#include "runtime/time/real_time.h"
#include "runtime/words/units.h"

namespace rob::runtime {

namespace {

constexpr double kPeriod = 0.01;  // s [choice] 100 Hz: six servos at 1 Mbit/s take 5 ms
constexpr double kBack = 0.1;  // of its speed [choice] what a hand at the emergency stop can follow

[[noreturn]] void fail(const std::string& text) { throw motion::DriverError(text); }

std::vector<drivers::WiredAxis> axes_of(const motion::RobotModel& robot) {
  std::vector<drivers::WiredAxis> axes;
  for (const motion::Axis& axis : robot.axes)
    axes.push_back({axis.name, axis.kind == motion::AxisKind::Linear, axis.v_max, axis.wire.id,
                    axis.wire.letter, axis.wire.travel, axis.wire.offset, axis.wire.direction});
  return axes;
}

drivers::WireSettings settings_of(const BackendName& name, const motion::RobotModel& robot,
                                  bool home) {
  drivers::WireSettings settings;
  settings.port = name.port;
  settings.baud = robot.wire.baud != 0 ? robot.wire.baud : name.driver->default_baud;
  const double asked = std::max(robot.servo_period, kPeriod);
  settings.period = robot.wire.period != 0 ? robot.wire.period : asked;
  settings.home = home;
  settings.begin_thread = [] { enter_real_time(kServoPriority); };
  settings.given_up = [] { return Interruption::requested() || Interruption::ctrl_c_pressed(); };
  return settings;
}

/// A cycle that the wire cannot do is longer, and the user gets a note.
void tell_period(const drivers::WireBackend& machine, const drivers::WireSettings& settings,
                 std::vector<std::string>& notes) {
  if (machine.period() <= machine.asked_period()) return;
  notes.push_back(fmt::format(
      "a cycle of this machine takes {} ms, not {} ms: shorter ones do not fit the machine and its "
      "line ({} axes at {} baud)",
      shown(1e3 * machine.period(), 1), shown(1e3 * machine.asked_period(), 1), machine.axes(),
      settings.baud));
}

/// The tighter one; a note where it is not the file's.
void tighten(double& value, double machines, bool most, const motion::Axis& axis, const char* what,
             std::vector<std::string>& notes) {
  if (!std::isfinite(machines) || (most ? machines >= value : machines <= value)) return;
  notes.push_back(fmt::format("the machine allows {} {} of {} of axis {}; the robot file says {}",
                              most ? "no more than" : "no less than", shown(machines, axis.kind),
                              what, axis.name, shown(value, axis.kind)));
  value = machines;
}

void take_limits(const drivers::WireBackend& machine, motion::RobotModel& robot,
                 std::vector<std::string>& notes) {
  for (int i = 0; i < robot.axis_count(); ++i) {
    motion::Axis& axis = robot.axes[static_cast<std::size_t>(i)];
    tighten(axis.min, machine.least(i), false, axis, "place", notes);
    tighten(axis.max, machine.most(i), true, axis, "place", notes);
    tighten(axis.v_max, machine.most_speed(i), true, axis, "speed (per s)", notes);
    tighten(axis.a_max, machine.most_acceleration(i), true, axis, "acceleration (per s^2)", notes);
    if (axis.min >= axis.max)
      fail(
          fmt::format("axis {} has no way left between the limits of the machine and those of the"
                      " robot file; is offset in [axis.wire] right?",
                      axis.name));
    // Paul's law needs 1.5·v_max/t_acc <= a_max.
    if (robot.t_acc > 0) axis.v_max = std::min(axis.v_max, axis.a_max * robot.t_acc / 1.5);
  }
  if (robot.t_acc > 0 && !motion::leaves_room_to_stop(motion::axis_reserve(robot), robot.t_acc))
    fail("the machine's accelerations are too small for t_acc of the robot file; raise t_acc");
}

/// An axis beyond its limits goes no further, and comes back slowly.
void let_back(double place, motion::Axis& axis) {
  axis.min = std::min(axis.min, place);
  axis.max = std::max(axis.max, place);
  axis.v_max *= kBack;
}

/// Where the axes stand is where the run begins.
void take_place(const motion::JointVector& place, bool back, motion::RobotModel& robot,
                std::vector<std::string>& notes) {
  for (int i = 0; i < robot.axis_count(); ++i) {
    motion::Axis& axis = robot.axes[static_cast<std::size_t>(i)];
    const double within = std::clamp(place[i], axis.min, axis.max);
    robot.start[i] = within;
    if (std::abs(place[i] - within) <= axis.drive.following_warn) continue;
    const std::string found = fmt::format("axis {} stands at {}, outside of {} … {}", axis.name,
                                          shown(place[i], axis.kind), shown(axis.min, axis.kind),
                                          shown(axis.max, axis.kind));
    if (!back)
      fail(found +
           ": nothing is enabled; bring it back by hand, or by a jog at the prompt, or correct "
           "offset in [axis.wire] of the robot file");
    notes.push_back(found + ": it can go back only, at a tenth of its speed; then :reset");
    let_back(place[i], axis);
    robot.start[i] = place[i];
  }
}

/// The user of a program that counts on signals gets a note where the wire does not carry them.
void tell_of_signals(const LoadedProgram& program, std::vector<std::string>& notes) {
  const auto& used = program.compilation.chunk->first_signal;
  if (!used) return;
  const std::string file = used->file == 0 ? program.file : used_names(program)[used->file - 1];
  notes.push_back(
      fmt::format("{}:{}: the wire of this machine carries no signals: outputs do nothing, and "
                  "inputs are OFF where no --signals sets them",
                  file, used->line));
}

class AbsentMachine final : public motion::ServoBackend {
 public:
  AbsentMachine(int axes, std::string trouble) : axes_(axes), trouble_(std::move(trouble)) {}

  int axes() const noexcept override { return axes_; }
  void open() override {}
  void close() noexcept override {}
  motion::DriverStatus enable(double) noexcept override { return motion::DriverStatus::Lost; }
  void disable(double) noexcept override {}
  motion::DriverStatus read(double, motion::ServoState&) noexcept override {
    return motion::DriverStatus::Lost;
  }
  motion::DriverStatus write(double, const motion::ServoCommand&) noexcept override {
    return motion::DriverStatus::Lost;
  }
  std::string trouble() const override { return trouble_; }

 private:
  int axes_;
  std::string trouble_;
};

}  // namespace

std::optional<BackendName> backend_of(const std::string& text) {
  if (text == "sim") return BackendName{};
  const std::size_t colon = text.find(':');
  if (colon == std::string::npos || colon + 1 == text.size()) return std::nullopt;
  const drivers::Driver* const driver = drivers::find_driver(text.substr(0, colon));
  if (driver == nullptr) return std::nullopt;
  return BackendName{driver, text.substr(colon + 1)};
}

std::string backend_names() {
  std::string names = "sim";
  for (const drivers::Driver& driver : drivers::drivers())
    names += fmt::format(", {}:PORT", driver.name);
  return names;
}

OpenMachine open_machine(const BackendName& name, motion::RobotModel& robot, bool home, bool back) {
  if (name.simulated()) return {simulation_of(robot), robot.servo_period, {}};
  const drivers::WireSettings settings = settings_of(name, robot, home);
  auto machine = name.driver->make(settings, axes_of(robot));
  machine->open();
  OpenMachine opened;
  tell_period(*machine, settings, opened.notes);
  take_limits(*machine, robot, opened.notes);
  take_place(machine->position(), back, robot, opened.notes);
  opened.period = machine->period();
  opened.carries_signals = machine->carries_signals();
  opened.backend = std::move(machine);
  return opened;
}

OpenMachine absent_machine(const motion::RobotModel& robot, const std::string& trouble) {
  return {std::make_unique<AbsentMachine>(robot.axis_count(), trouble), robot.servo_period, {}};
}

OpenMachine open_machine(const BackendName& name, LoadedProgram& program,
                         std::optional<motion::Law> law, bool home) {
  if (!program.runnable()) return {};
  motion::RobotModel robot = program.robot;
  StopRequests requests;
  const Interruption interruption(requests);  // of homing
  OpenMachine machine = open_machine(name, robot, home);
  if (Interruption::requested()) fail("stopped before anything has moved");
  if (name.simulated()) return machine;
  program = compile_program(program.file, program.source, robot, points_file_of(program.file), law);
  if (program.runnable() && !machine.carries_signals) tell_of_signals(program, machine.notes);
  return machine;
}

}  // namespace rob::runtime
