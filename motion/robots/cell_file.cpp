#include "motion/robots/cell_file.h"

#include "motion/robots/signal_channel.h"

namespace rob::motion {

namespace {

// [choice] What a bench with tubes, or with engines, may have; a slip in a unit is out of it.
constexpr Range kDelay{0, 0.1};
constexpr Range kSamplePeriod{1e-4, 0.1};
constexpr Range kMostForce{1e-3, 1e6};
constexpr Range kStiffness{1, 1e9};
constexpr Range kForceError{-1e3, 1e3};
constexpr Range kTorqueError{-1e2, 1e2};
constexpr Range kForceNoise{0, 100};
constexpr Range kTorqueNoise{0, 10};
constexpr Range kDampingTime{0, 0.1};
constexpr Range kFriction{0, 2};
constexpr Range kTorsion{1e-2, 1e6};
constexpr Range kFallSpeed{1e-5, 10};
constexpr Range kFallResistance{1, 1e6};
constexpr Range kPlace{-100, 100};
constexpr Range kMeasure{1e-5, 10};
constexpr Range kGap{1e-7, 0.1};
constexpr Range kTurns{1e-2, 1e3};
constexpr Range kTorque{1e-6, 1e3};
constexpr int kMostHoles = 1000;     // in a row or a column
constexpr double kRemembered = 100;  // samples of the sensor, while they are on their way

Eigen::Vector3d three(const TableReader& table, std::string_view key, Quantity quantity,
                      Range range) {
  if (!table.has(key)) return Eigen::Vector3d::Zero();
  const std::vector<double> values = table.quantities(key, quantity, range, 3);
  return {values[0], values[1], values[2]};
}

SensorErrors read_errors(const TableReader& table) {
  SensorErrors errors;
  errors.period = table.quantity("period", Quantity::Time, kSamplePeriod);
  errors.force_noise = table.quantity("force_noise", Quantity::Force, kForceNoise);
  errors.torque_noise = table.quantity("torque_noise", Quantity::Torque, kTorqueNoise);
  errors.force_bias = three(table, "force_bias", Quantity::Force, kForceError);
  errors.torque_bias = three(table, "torque_bias", Quantity::Torque, kTorqueError);
  return errors;
}

ContactData read_contact(const TableReader& table) {
  ContactData contact;
  contact.stiffness = table.quantity("stiffness", Quantity::Stiffness, kStiffness);
  contact.damping_time = table.quantity("damping_time", Quantity::Time, kDampingTime);
  contact.friction = table.number("friction", kFriction);
  contact.torsion = table.quantity("torsion", Quantity::TorsionStiffness, kTorsion);
  contact.fall_speed = table.quantity("fall_speed", Quantity::Speed, kFallSpeed);
  contact.fall_resistance =
      table.quantity("fall_resistance", Quantity::LinearFriction, kFallResistance);
  return contact;
}

GripperData read_gripper(const TableReader& table, const RobotModel& robot) {
  GripperData gripper;
  gripper.closed_input = signal_channel(table, "closed_input", false, robot);
  gripper.held_input = signal_channel(table, "held_input", false, robot);
  if (gripper.held_input == gripper.closed_input)
    table.fail("held_input", "must be another input than closed_input");
  gripper.tip = table.quantity("tip", Quantity::Length, kMeasure);
  gripper.fingers = table.quantity("fingers", Quantity::Length, kMeasure);
  gripper.palm = table.quantity("palm", Quantity::Length, kMeasure);
  gripper.reach = table.quantity("reach", Quantity::Length, kMeasure);
  return gripper;
}

CapData read_cap(const TableReader& table) {
  CapData cap;
  cap.height = table.quantity("height", Quantity::Length, kMeasure);
  cap.overlap = table.quantity("overlap", Quantity::Length, kMeasure);
  cap.pitch = table.quantity("pitch", Quantity::Length, kMeasure);
  cap.turns = table.quantity("turns", Quantity::Angle, kTurns);
  cap.running_torque = table.quantity("running_torque", Quantity::Torque, kTorque);
  cap.rise = table.quantity("rise", Quantity::Angle, kTurns);
  cap.slip_torque = table.quantity("slip_torque", Quantity::Torque, kTorque);
  if (cap.overlap > cap.height) table.fail("overlap", "is more than height");
  if (cap.rise > cap.turns) table.fail("rise", "is more than turns");
  if (cap.slip_torque <= cap.running_torque)
    table.fail("slip_torque", "must be more than running_torque, or the cap never turns");
  return cap;
}

RackData read_rack(const TableReader& table, const RobotModel& robot) {
  RackData rack;
  rack.x = table.quantity("x", Quantity::Length, kPlace);
  rack.y = table.quantity("y", Quantity::Length, kPlace);
  rack.face = table.quantity("face", Quantity::Length, kPlace);
  rack.depth = table.quantity("depth", Quantity::Length, kMeasure);
  rack.pitch = table.quantity("pitch", Quantity::Length, kMeasure);
  rack.clearance = table.quantity("clearance", Quantity::Length, kGap);
  rack.chamfer = table.quantity("chamfer", Quantity::Length, kGap);
  rack.columns = table.integer_or("columns", 1, kMostHoles, 1);
  rack.rows = table.integer_or("rows", 1, kMostHoles, 1);
  rack.fill = static_cast<RackData::Fill>(table.choice("fill", {"empty", "tubes", "capped_tubes"}));
  if (table.has("error")) {
    const std::vector<double> error = table.quantities("error", Quantity::Length, kPlace, 2);
    rack.error = {error[0], error[1]};
    if (rack.error.norm() > rack.pitch / 2)
      table.fail("error", "is more than half of pitch: the hole would be its neighbour's");
  }
  if (rack.face - rack.depth < robot.cell->table)
    table.fail("depth", "its holes would end below the table; lower depth, or raise face");
  return rack;
}

CapSupplyData read_supply(const TableReader& table) {
  CapSupplyData supply;
  supply.place = three(table, "place", Quantity::Length, kPlace);
  return supply;
}

/// [low, high]
Between read_between(const TableReader& table, std::string_view key,
                     const std::vector<double>& values) {
  if (values[0] > values[1]) table.fail(key, "must have its lower value first");
  return {values[0], values[1]};
}

CellSpread read_spread(const TableReader& table, const RobotModel& robot) {
  const auto between = [&](std::string_view key, Quantity quantity, Range range) {
    return read_between(table, key, table.quantities(key, quantity, range, 2));
  };
  CellSpread spread;
  spread.stiffness = between("stiffness", Quantity::Stiffness, kStiffness);
  spread.damping_time = between("damping_time", Quantity::Time, kDampingTime);
  spread.friction = read_between(table, "friction", table.numbers("friction", kFriction, 2));
  spread.force_noise = between("force_noise", Quantity::Force, kForceNoise);
  spread.torque_noise = between("torque_noise", Quantity::Torque, kTorqueNoise);
  spread.force_bias = between("force_bias", Quantity::Force, kForceError);
  spread.torque_bias = between("torque_bias", Quantity::Torque, kTorqueError);
  spread.delay = between("delay", Quantity::Time, kDelay);
  spread.running_torque = between("running_torque", Quantity::Torque, kTorque);
  spread.slip_torque = between("slip_torque", Quantity::Torque, kTorque);
  spread.hole_error = table.quantity("hole_error", Quantity::Length, kMeasure);
  if (spread.stiffness.high > robot.force.stiffness)
    table.fail("stiffness", "is more than [force] says to be the greatest");
  if (spread.delay.high > robot.force.delay)
    table.fail("delay", "is more than [force] says to be the greatest");
  if (spread.slip_torque.low <= spread.running_torque.high)
    table.fail("slip_torque", "must be more than running_torque, or the cap never turns");
  for (const RackData& rack : robot.cell->racks)
    if (!rack.error.isZero(0) && spread.hole_error > rack.pitch / 2)
      table.fail("hole_error", "is more than half of pitch: the hole would be its neighbour's");
  return spread;
}

}  // namespace

void read_force(const TableReader& file, RobotModel& robot) {
  if (!file.has("force")) return;
  if (!robot.force_sensor) file.fail("force", "needs force_sensor = true");
  const TableReader table = file.table("force", {"delay", "limit", "stiffness"});
  robot.force.delay = table.quantity("delay", Quantity::Time, kDelay);
  if (table.has("limit")) robot.force.limit = table.quantity("limit", Quantity::Force, kMostForce);
  robot.force.stiffness = table.quantity("stiffness", Quantity::Stiffness, kStiffness);
}

void read_cell(const TableReader& file, RobotModel& robot) {
  if (!file.has("cell")) return;
  if (!file.has("force")) file.fail("cell", "needs a table [force], which is missing");
  const TableReader table = file.table("cell", {"table", "sensor", "contact", "gripper", "tube",
                                                "cap", "rack", "cap_supply", "spread"});
  CellData& cell = robot.cell.emplace();
  cell.table = table.quantity("table", Quantity::Length, kPlace);
  const TableReader sensor =
      table.table("sensor", {"period", "force_noise", "torque_noise", "force_bias", "torque_bias"});
  cell.sensor = read_errors(sensor);
  cell.sensor.delay = robot.force.delay;
  robot.force.noise = cell.sensor.force_noise;
  if (robot.force.delay > kRemembered * cell.sensor.period)
    sensor.fail("period", "is too short for the delay: at most 100 samples may be on their way");
  const TableReader contact = table.table("contact", {"stiffness", "damping_time", "friction",
                                                      "torsion", "fall_speed", "fall_resistance"});
  cell.contact = read_contact(contact);
  if (cell.contact.stiffness > robot.force.stiffness)
    contact.fail("stiffness", "is more than [force] says to be the greatest");
  cell.gripper = read_gripper(
      table.table("gripper", {"closed_input", "held_input", "tip", "fingers", "palm", "reach"}),
      robot);
  const TableReader tube = table.table("tube", {"length", "radius"});
  cell.tube.length = tube.quantity("length", Quantity::Length, kMeasure);
  cell.tube.radius = tube.quantity("radius", Quantity::Length, kMeasure);
  cell.cap = read_cap(table.table(
      "cap", {"height", "overlap", "pitch", "turns", "running_torque", "rise", "slip_torque"}));
  for (const TableReader& rack :
       table.tables("rack", {"x", "y", "face", "depth", "pitch", "clearance", "chamfer", "columns",
                             "rows", "fill", "error"}))
    cell.racks.push_back(read_rack(rack, robot));
  for (const TableReader& supply : table.tables("cap_supply", {"place"}))
    cell.cap_supplies.push_back(read_supply(supply));
  if (!table.has("spread")) return;
  cell.spread =
      read_spread(table.table("spread", {"stiffness", "damping_time", "friction", "force_noise",
                                         "torque_noise", "force_bias", "torque_bias", "delay",
                                         "running_torque", "slip_torque", "hole_error"}),
                  robot);
}

}  // namespace rob::motion
