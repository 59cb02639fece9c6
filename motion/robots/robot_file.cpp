#include "motion/robots/robot_file.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <limits>

#include "motion/kinematics/arm_kinematics.h"
#include "motion/kinematics/gantry_kinematics.h"
#include "motion/robots/arm_file.h"
#include "motion/robots/cell_file.h"
#include "motion/robots/chain_file.h"
#include "motion/robots/mechanics_file.h"
#include "motion/robots/pulse_file.h"
#include "motion/robots/shapes_file.h"
#include "motion/robots/signal_channel.h"
#include "motion/robots/table_reader.h"
#include "motion/robots/time_scaling.h"
#include "motion/robots/wire_file.h"

namespace rob::motion {

namespace {

// Bounds on what a robot file may say. [choice] They leave room for every machine that is a robot,
// from a microscope's stage to a port crane, and catch a slip in a unit or an exponent.
constexpr Range kPeriod{1e-4, 1};
constexpr Range kServoPeriod{5e-5, 1};
constexpr int kMostServoCycles = 100;  // a reference; above, samples pile up between the tasks
constexpr Range kHalfTransition{1e-3, 60};
constexpr Range kZone{1e-6, 1};
constexpr Range kZoneAngle{1e-6, 1};
constexpr Range kSettleDistance{1e-6, 1};
constexpr Range kSettleAngle{1e-6, 1};
constexpr double kLongestSettling = 60;  // s
constexpr int kLookAheadMin = 2;
constexpr int kLookAheadMax = 16384;
constexpr int kChannels = 64;  // bits of ServoCommand::outputs, ServoState::inputs
constexpr Range kTravelTime{1e-3, 60};
constexpr Range kResolution{1e-10, 1e-2};
constexpr Range kBandwidth{0.1, 1e4};
constexpr Range kFollowing{1e-6, 1};
constexpr Range kViscous{0, 1e6};
constexpr Range kCoulomb{0, 1e5};
constexpr Range kForce{1e-6, 1e7};
constexpr Range kInertia{1e-9, 1e6};

/// Units and bounds of one kind of axis.
struct KindRules {
  Quantity position, speed, acceleration, jerk, inertia, viscous, force;
  Range position_range, speed_range, acceleration_range, jerk_range;
};

constexpr KindRules kLinear{Quantity::Length, Quantity::Speed, Quantity::Acceleration,
                            Quantity::Jerk,   Quantity::Mass,  Quantity::LinearFriction,
                            Quantity::Force,  {-100, 100},     {1e-6, 10},
                            {1e-6, 1e3},      {1e-6, 1e6}};
constexpr KindRules kRotary{Quantity::Angle,
                            Quantity::AngularSpeed,
                            Quantity::AngularAcceleration,
                            Quantity::AngularJerk,
                            Quantity::Inertia,
                            Quantity::RotaryFriction,
                            Quantity::Torque,
                            {-1e3, 1e3},
                            {1e-6, 100},
                            {1e-6, 1e4},
                            {1e-6, 1e7}};

std::string short_number(double value) {
  char text[32];
  std::snprintf(text, sizeof text, "%.4g", value);
  return text;
}

template <typename T>
bool has_name(const std::vector<T>& entries, std::string_view name) {
  return std::any_of(entries.begin(), entries.end(),
                     [&](const T& entry) { return entry.name == name; });
}

/// A count that no axis can move in a period is a jump of the encoder, however slow the axis.
void check_count(const TableReader& file, const KindRules& rules, const Axis& axis, double count,
                 double servo_period) {
  const double most = kJumpMargin * axis.v_max * servo_period;
  if (count <= most) return;
  file.fail("encoder_resolution",
            short_number(count) + " " + std::string(si_unit(rules.position)) +
                " a count is more than the axis can move in a servo_period (" + short_number(most) +
                " " + std::string(si_unit(rules.position)) +
                "): every run would end in E504; write a finer one, or raise v_max or"
                " servo_period");
}

DriveData read_drive(const TableReader& file, const KindRules& rules, const Axis& axis,
                     double servo_period) {
  DriveData drive;
  drive.inertia = file.quantity("inertia", rules.inertia, kInertia);
  drive.viscous_friction = file.quantity("viscous_friction", rules.viscous, kViscous);
  drive.coulomb_friction = file.quantity("coulomb_friction", rules.force, kCoulomb);
  drive.force_max = file.quantity("force_max", rules.force, kForce);
  drive.encoder_resolution = file.quantity("encoder_resolution", rules.position, kResolution);
  check_count(file, rules, axis, drive.encoder_resolution, servo_period);
  drive.bandwidth = file.quantity("bandwidth", Quantity::Bandwidth, kBandwidth);
  drive.following_warn = file.quantity("following_warn", rules.position, kFollowing);
  drive.following_limit = file.quantity("following_limit", rules.position, kFollowing);
  if (drive.following_warn > drive.following_limit)
    file.fail("following_warn", "is more than following_limit");
  const double needed =
      drive.inertia * axis.a_max + drive.viscous_friction * axis.v_max + drive.coulomb_friction;
  if (drive.force_max < needed) {
    file.fail("force_max", "a_max at v_max takes " + short_number(needed) + " " +
                               std::string(si_unit(rules.force)) + "; allow more, or lower a_max");
  }
  return drive;
}

/// Reads one [[axis]]; `start` is where the simulated axis stands.
Axis read_axis(TableReader& file, double servo_period, double& start) {
  Axis axis;
  axis.name = file.name("name");
  file.rename("axis " + axis.name);
  axis.kind = file.choice("kind", {"linear", "rotary"}) == 0 ? AxisKind::Linear : AxisKind::Rotary;
  const KindRules& rules = axis.kind == AxisKind::Linear ? kLinear : kRotary;
  axis.min = file.quantity("min", rules.position, rules.position_range);
  axis.max = file.quantity("max", rules.position, rules.position_range);
  if (axis.min >= axis.max) file.fail("min", "must be less than max");
  start = file.quantity("start", rules.position, rules.position_range);
  if (start < axis.min || start > axis.max) file.fail("start", "must lie from min to max");
  axis.v_max = file.quantity("v_max", rules.speed, rules.speed_range);
  axis.a_max = file.quantity("a_max", rules.acceleration, rules.acceleration_range);
  axis.j_max = file.has("j_max") ? file.quantity("j_max", rules.jerk, rules.jerk_range)
                                 : std::numeric_limits<double>::infinity();
  const TableReader drive =
      file.table("drive", {"inertia", "viscous_friction", "coulomb_friction", "force_max",
                           "encoder_resolution", "bandwidth", "following_warn", "following_limit"});
  axis.drive = read_drive(drive, rules, axis, servo_period);
  return axis;
}

void read_timing(const TableReader& file, RobotModel& robot) {
  robot.law = file.choice("law", {"paul", "lookahead"}) == 0 ? Law::Paul : Law::LookAhead;
  robot.reference_period = file.quantity("reference_period", Quantity::Time, kPeriod);
  robot.servo_period = file.quantity("servo_period", Quantity::Time, kServoPeriod);
  if (robot.servo_period > robot.reference_period)
    file.fail("servo_period", "must not be longer than reference_period");
  if (robot.reference_period > (kMostServoCycles + 0.5) * robot.servo_period)
    file.fail("servo_period", "reference_period must not be more than " +
                                  std::to_string(kMostServoCycles) + " times as long");
  if (file.has("t_acc")) {
    robot.t_acc = file.quantity("t_acc", Quantity::Time, kHalfTransition);
    // A segment lasts at least 2·t_acc: no more than one transition begins in a period.
    if (robot.t_acc < robot.reference_period)
      file.fail("t_acc", "must not be less than reference_period");
  } else if (robot.law == Law::Paul) {
    file.fail("t_acc", "is missing: Paul's law needs it; law = \"lookahead\" does not");
  }
  if (file.has("zone")) robot.zone.distance = file.quantity("zone", Quantity::Length, kZone);
  if (file.has("zone_angle"))
    robot.zone.angle = file.quantity("zone_angle", Quantity::Angle, kZoneAngle);
  robot.look_ahead = file.integer("look_ahead", kLookAheadMin, kLookAheadMax);
}

void read_settling(const TableReader& file, RobotModel& robot) {
  SettleWindow& window = robot.settle;
  if (file.has("settle_distance"))
    window.distance = file.quantity("settle_distance", Quantity::Length, kSettleDistance);
  if (file.has("settle_angle"))
    window.angle = file.quantity("settle_angle", Quantity::Angle, kSettleAngle);
  if (file.has("settle_time"))
    window.time =
        file.quantity("settle_time", Quantity::Time, {robot.reference_period, kLongestSettling});
}

/// A deviation finer than an encoder counts is never seen.
void check_settling(const TableReader& file, const RobotModel& robot) {
  for (const Axis& axis : robot.axes) {
    const bool linear = axis.kind == AxisKind::Linear;
    const KindRules& rules = linear ? kLinear : kRotary;
    const double window = linear ? robot.settle.distance : robot.settle.angle;
    if (window >= axis.drive.encoder_resolution) continue;
    file.fail(linear ? "settle_distance" : "settle_angle",
              "is less than a count of axis " + axis.name + " (" +
                  short_number(axis.drive.encoder_resolution) + " " +
                  std::string(si_unit(rules.position)) + "); allow more");
  }
}

/// Returns the readers, for the checks that need the whole robot.
std::vector<TableReader> read_axes(const TableReader& file, RobotModel& robot) {
  std::vector<TableReader> tables =
      file.tables("axis", {"name", "kind", "min", "max", "start", "v_max", "a_max", "j_max",
                           "drive", "motor", "pulse_drive", "wire", "joint", "link", "shape"});
  if (tables.empty()) file.fail("axis", "is missing; write a table [[axis]] for each");
  if (tables.size() > static_cast<std::size_t>(kMaxJoints))
    file.fail("axis", "more than " + std::to_string(kMaxJoints) + " axes");
  robot.start.resize(static_cast<Eigen::Index>(tables.size()));
  for (TableReader& table : tables) {
    double start = 0;
    Axis axis = read_axis(table, robot.servo_period, start);
    if (has_name(robot.axes, axis.name)) table.fail("name", "there is another axis of this name");
    robot.start[robot.axis_count()] = start;
    robot.axes.push_back(std::move(axis));
  }
  return tables;
}

void read_signals(const TableReader& file, RobotModel& robot) {
  for (const TableReader& table : file.tables("signal", {"name", "direction", "channel"})) {
    RobotSignal signal;
    signal.name = table.name("name");
    signal.output = table.choice("direction", {"input", "output"}) == 1;
    signal.channel = table.integer("channel", 0, kChannels - 1);
    if (has_name(robot.signals, signal.name) || has_name(robot.axes, signal.name))
      table.fail("name", "there is another signal or axis of this name");
    for (const RobotSignal& other : robot.signals)
      if (other.output == signal.output && other.channel == signal.channel)
        table.fail("channel", "is that of signal " + other.name);
    robot.signals.push_back(std::move(signal));
  }
}

/// How many channels there are: at least those that have names.
int count_of_channels(const TableReader& file, std::string_view key, bool output,
                      const RobotModel& robot) {
  int named = 0;
  for (const RobotSignal& signal : robot.signals)
    if (signal.output == output) named = std::max(named, signal.channel + 1);
  const int count = file.integer_or(key, 0, kChannels, named);
  if (count < named)
    file.fail(key, "a signal has channel " + std::to_string(named - 1) + "; count it, from 0");
  return count;
}

void read_actuators(const TableReader& file, RobotModel& robot) {
  for (const TableReader& table :
       file.tables("actuator", {"output", "off_input", "on_input", "travel_time"})) {
    TwoPositionActuator actuator;
    actuator.output = signal_channel(table, "output", true, robot);
    actuator.input_off = signal_channel(table, "off_input", false, robot);
    actuator.input_on = signal_channel(table, "on_input", false, robot);
    actuator.travel_time = table.quantity("travel_time", Quantity::Time, kTravelTime);
    if (actuator.input_on == actuator.input_off)
      table.fail("on_input", "must be another input than off_input");
    for (const TwoPositionActuator& other : robot.actuators)
      if (other.output == actuator.output) table.fail("output", "drives another actuator already");
    robot.actuators.push_back(actuator);
  }
}

/// ISO 841 calls axes a and b that turn about x and y; any other turns about z.
GantryKinematics::Turn turn_of(std::string_view name) {
  using Turn = GantryKinematics::Turn;
  return name == "a" ? Turn::AboutX : name == "b" ? Turn::AboutY : Turn::AboutZ;
}

void choose_kinematics(const TableReader& file, const std::vector<TableReader>& axes,
                       RobotModel& robot) {
  const auto rotary = [](const Axis& axis) { return axis.kind == AxisKind::Rotary; };
  const int kind = file.choice("kinematics", {"gantry", "arm", "chain"});
  if (kind == 2) return read_chain(file, axes, robot);
  if (file.has("free")) file.fail("free", "belongs to kinematics = \"chain\"");
  if (file.has("gripper")) file.fail("gripper", "belongs to kinematics = \"chain\"");
  if (file.has("chain")) file.fail("chain", "belongs to kinematics = \"chain\"");
  for (const TableReader& axis : axes)
    if (axis.has("joint")) axis.fail("joint", "belongs to kinematics = \"chain\"");
  if (kind == 1) {
    if (robot.axis_count() != ArmParameters::kAxes || !std::ranges::all_of(robot.axes, rotary))
      file.fail("kinematics", "an arm has six rotary axes");
    robot.tool_coordinates = true;
    robot.coordinates = {0, 1, 2, 3, 4, 5};
    robot.kinematics = read_arm(file, robot.axes);
    return;
  }
  const auto first_rotary = std::ranges::find_if(robot.axes, rotary);
  const auto linear = static_cast<int>(first_rotary - robot.axes.begin());
  const int turning = robot.axis_count() - linear;
  const bool fits = (linear == 2 || linear == 3) && turning <= 1;
  if (!fits)
    file.fail("kinematics", "a gantry has two or three linear axes, then at most a rotary one");
  if (file.has("arm")) file.fail("arm", "a gantry has none");
  robot.kinematics = std::make_shared<GantryKinematics>(
      linear, turning == 0 ? GantryKinematics::Turn::None : turn_of(first_rotary->name));
}

void choose_mechanics(const TableReader& file, const std::vector<TableReader>& axes,
                      RobotModel& robot) {
  if (file.has("dynamics")) {
    const auto* const kinematics = dynamic_cast<const ArmKinematics*>(robot.kinematics.get());
    if (kinematics == nullptr)
      file.fail("dynamics", "belongs to kinematics = \"arm\": its table is of such an arm");
    robot.mechanics = read_mechanics(file, axes);
    const ArmParameters& arm = kinematics->parameters();
    robot.mechanics->lengths = {arm.c2, arm.c3, arm.c4};
    robot.deviation = read_deviation(file);
    return;
  }
  if (file.has("simulation")) file.fail("simulation", "needs a table [dynamics], which is missing");
  for (const TableReader& axis : axes)
    if (axis.has("motor")) axis.fail("motor", "belongs to a table [dynamics], which is missing");
}

/// Paul's corners, and a stop anywhere on the path, must leave every axis within its limits.
void check_paul(const TableReader& file, const std::vector<TableReader>& axes,
                const RobotModel& robot) {
  const double t = robot.t_acc;
  for (std::size_t i = 0; i < axes.size(); ++i) {
    const Axis& axis = robot.axes[i];
    const KindRules& rules = axis.kind == AxisKind::Linear ? kLinear : kRotary;
    const double acceleration = 1.5 * axis.v_max / t;
    if (acceleration > axis.a_max) {
      axes[i].fail("a_max", "Paul's law needs 1.5*v_max/t_acc = " + short_number(acceleration) +
                                " " + std::string(si_unit(rules.acceleration)) +
                                "; allow more, lower v_max or raise t_acc");
    }
    const double jerk = 3 * axis.v_max / (t * t);
    if (jerk > axis.j_max) {
      axes[i].fail("j_max", "Paul's law needs 3*v_max/t_acc^2 = " + short_number(jerk) + " " +
                                std::string(si_unit(rules.jerk)) +
                                "; allow more, lower v_max or raise t_acc");
    }
  }
  if (leaves_room_to_stop(axis_reserve(robot), t)) return;
  file.fail("t_acc",
            "Paul's corners leave too little of a_max and j_max to stop on the path within " +
                short_number(kLongestStop) + " s; raise t_acc, a_max or j_max, or lower v_max");
}

}  // namespace

RobotModel parse_robot_file(std::string_view text, std::string_view file_name) {
  const toml::table table = parsed_toml(text, file_name);
  const TableReader file(table, file_name, "", {"name",         "description",   "kinematics",
                                                "law",          "t_acc",         "reference_period",
                                                "servo_period", "look_ahead",    "zone",
                                                "zone_angle",   "servo",         "inputs",
                                                "outputs",      "analog_inputs", "analog_outputs",
                                                "force_sensor", "arm",           "dynamics",
                                                "simulation",   "axis",          "signal",
                                                "actuator",     "wire",          "force",
                                                "cell",         "chain",         "settle_distance",
                                                "settle_angle", "settle_time",   "base",
                                                "flange",       "obstacle",      "apart",
                                                "clearance",    "free",          "gripper"});
  RobotModel robot;
  robot.name = file.name("name");
  robot.description = file.text("description");
  read_timing(file, robot);
  read_settling(file, robot);
  const std::vector<TableReader> axes = read_axes(file, robot);
  check_settling(file, robot);
  read_signals(file, robot);
  robot.inputs = count_of_channels(file, "inputs", false, robot);
  robot.outputs = count_of_channels(file, "outputs", true, robot);
  robot.analog_inputs = file.integer_or("analog_inputs", 0, kMostAnalog, 0);
  robot.analog_outputs = file.integer_or("analog_outputs", 0, kMostAnalog, 0);
  read_actuators(file, robot);
  robot.force_sensor = file.flag_or("force_sensor", false);
  choose_kinematics(file, axes, robot);
  choose_mechanics(file, axes, robot);
  read_servo(file, axes, robot);
  read_wire(file, axes, robot);
  read_force(file, robot);
  read_cell(file, robot);
  read_shapes(file, axes, robot);
  if (robot.t_acc > 0) check_paul(file, axes, robot);
  return robot;
}

}  // namespace rob::motion
