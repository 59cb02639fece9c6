#include "runtime/program/machine.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include "drivers/link/grbl_link.h"
#include "drivers/link/rob_link.h"
#include "drivers/link/servo_link.h"
#include "drivers/link/wire_backend.h"
#include "motion/robots/time_scaling.h"
#include "runtime/control/units.h"
#include "runtime/program/interruption.h"
#include "runtime/program/points_file.h"
#include "runtime/program/simulation.h"
#include "runtime/time/real_time.h"

namespace rob::runtime {

namespace {

using drivers::WireAxis;
using Kind = BackendName::Kind;

constexpr double kTicks = 4096;     // a turn of a servo, of both makers
constexpr double kScsTicks = 1024;  // the way of a servo of Feetech's SCS series
constexpr double kPeriod = 0.01;    // s [choice] 100 Hz: six servos at 1 Mbit/s take 5 ms
constexpr double kFineUnits = 1e6;  // of Rob's own protocol, per mm or deg
constexpr int kLetters = 6;
constexpr double kBack = 0.1;  // of its speed [choice] what a hand at the emergency stop can follow

struct Protocol {
  const char* name;
  Kind kind;
  int baud;
};
constexpr Protocol kProtocols[] = {{"grbl", Kind::Grbl, 115200},
                                   {"dynamixel", Kind::Dynamixel, 1000000},
                                   {"feetech", Kind::Feetech, 1000000},
                                   {"feetech-scs", Kind::FeetechScs, 1000000},
                                   {"rob", Kind::Rob, 115200}};

const Protocol& protocol_of(Kind kind) {
  return *std::ranges::find(kProtocols, kind, &Protocol::kind);
}

[[noreturn]] void fail(const std::string& text) { throw motion::DriverError(text); }

/// mm or deg: what a millimetre of grbl is.
double per_shown(const motion::Axis& axis) { return 1 / shown_per_si(axis.kind); }

/// An axis of the machine: the units per m or rad, and where its zero is.
WireAxis axis_on(const motion::Axis& axis, double units, double travel, double zero) {
  WireAxis wire;
  wire.name = axis.name;
  wire.scale = axis.wire.direction * units / travel;
  wire.offset = axis.wire.offset - zero / wire.scale;
  wire.most_step = axis.v_max * std::abs(wire.scale);
  return wire;
}

WireAxis servo_axis(const motion::Axis& axis, int number, double ticks) {
  double travel = axis.wire.travel;
  if (travel == 0 && axis.kind == motion::AxisKind::Rotary && ticks == kTicks)
    travel = 2 * std::numbers::pi;
  if (travel == 0)
    fail(
        fmt::format("the robot file does not say how far axis {} goes in a turn of its servo (SCS:"
                    " over its 1024 places); write [axis.wire] travel = \"{}\" there",
                    axis.name, axis.kind == motion::AxisKind::Linear ? "40 mm" : "300 deg"));
  WireAxis wire = axis_on(axis, ticks, travel, ticks / 2);
  wire.address = axis.wire.id >= 0 ? axis.wire.id : number;
  return wire;
}

WireAxis rob_axis(const motion::Axis& axis) {
  return axis_on(axis, shown_per_si(axis.kind) * kFineUnits, 1, 0);
}

/// The letter that the file says, that of the axis' name, or the next that is free.
std::vector<int> letters_of(const motion::RobotModel& robot) {
  std::vector<int> letters;
  for (const motion::Axis& axis : robot.axes) {
    const std::size_t named = std::string("xyzabc").find(axis.name);
    const bool has_name = axis.name.size() == 1 && named != std::string::npos;
    letters.push_back(axis.wire.letter >= 0 ? axis.wire.letter
                      : has_name            ? static_cast<int>(named)
                                            : -1);
  }
  for (int& letter : letters)
    for (int free = 0; letter < 0 && free < kLetters; ++free)
      if (std::ranges::find(letters, free) == letters.end()) letter = free;
  return letters;
}

std::vector<WireAxis> axes_of(Kind kind, const motion::RobotModel& robot) {
  std::vector<WireAxis> axes;
  const std::vector<int> letters = letters_of(robot);
  for (std::size_t i = 0; i < robot.axes.size(); ++i) {
    const motion::Axis& axis = robot.axes[i];
    if (kind == Kind::Grbl) {
      if (letters[i] < 0) fail("grbl has no letter for axis " + axis.name);
      const double travel = axis.wire.travel != 0 ? axis.wire.travel : per_shown(axis);
      axes.push_back(axis_on(axis, 1, travel, 0));
      axes.back().address = letters[i];
    } else if (kind == Kind::Rob) {
      axes.push_back(rob_axis(axis));
    } else {
      const double ticks = kind == Kind::FeetechScs ? kScsTicks : kTicks;
      axes.push_back(servo_axis(axis, static_cast<int>(i) + 1, ticks));
    }
  }
  for (std::size_t i = 0; i < axes.size(); ++i)
    for (std::size_t k = 0; kind != Kind::Rob && k < i; ++k)
      if (axes[i].address == axes[k].address)
        fail(
            fmt::format("axes {} and {} have the same {} on the wire; write [axis.wire] in the "
                        "robot file",
                        axes[k].name, axes[i].name, kind == Kind::Grbl ? "letter" : "id"));
  return axes;
}

std::unique_ptr<drivers::WireLink> link_of(Kind kind, const drivers::WireSettings& settings) {
  switch (kind) {
    case Kind::Grbl:
      return drivers::grbl_link(settings.axes);
    case Kind::Dynamixel:
      return drivers::dynamixel_link(settings.axes, settings.baud);
    case Kind::Feetech:
      return drivers::feetech_link(settings.axes, settings.baud);
    case Kind::FeetechScs:
      return drivers::feetech_scs_link(settings.axes, settings.baud);
    default:
      return drivers::rob_link(settings.axes, settings.period);
  }
}

drivers::WireSettings settings_of(const BackendName& name, const motion::RobotModel& robot,
                                  bool home) {
  drivers::WireSettings settings;
  settings.port = name.port;
  settings.baud = robot.wire.baud != 0 ? robot.wire.baud : protocol_of(name.kind).baud;
  const double asked = std::max(robot.servo_period, kPeriod);
  settings.period = robot.wire.period != 0 ? robot.wire.period : asked;
  if (name.kind == Kind::Grbl) settings.period = drivers::GrblLink::kPeriod;
  settings.axes = axes_of(name.kind, robot);
  settings.home = home;
  settings.begin_thread = [] { enter_real_time(kServoPriority); };
  settings.given_up = [] { return Interruption::requested() || Interruption::ctrl_c_pressed(); };
  return settings;
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

/// No wire carries signals: a program that counts on them is told.
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
  for (const Protocol& protocol : kProtocols)
    if (text.substr(0, colon) == protocol.name)
      return BackendName{protocol.kind, text.substr(colon + 1)};
  return std::nullopt;
}

OpenMachine open_machine(const BackendName& name, motion::RobotModel& robot, bool home, bool back) {
  if (name.simulated()) return {simulation_of(robot), robot.servo_period, {}};
  const drivers::WireSettings settings = settings_of(name, robot, home);
  auto machine = std::make_unique<drivers::WireBackend>(settings, link_of(name.kind, settings));
  machine->open();
  OpenMachine opened;
  take_limits(*machine, robot, opened.notes);
  take_place(machine->position(), back, robot, opened.notes);
  opened.period = machine->period();
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
  if (program.runnable()) tell_of_signals(program, machine.notes);
  return machine;
}

}  // namespace rob::runtime
