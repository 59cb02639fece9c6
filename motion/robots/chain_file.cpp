#include "motion/robots/chain_file.h"

#include <memory>
#include <utility>

#include "base/unit_factors.h"
#include "motion/kinematics/chain_kinematics.h"

namespace rob::motion {

namespace {

constexpr Range kStep{-10, 10};  // [choice] as the steps of an arm
constexpr Range kTurn{-kFullTurn, kFullTurn};
constexpr std::size_t kOfPose = 6;  // axes that it takes to place and turn a tool freely

Pose read_pose(const TableReader& table) {
  const std::vector<double> place = table.quantities("place", Quantity::Length, kStep, 3);
  const std::vector<double> turn = table.quantities("turn", Quantity::Angle, kTurn, 3);
  return {{place[0], place[1], place[2]}, orientation_from({turn[0], turn[1], turn[2]})};
}

std::vector<ChainJoint> read_joints(const TableReader& file, const std::vector<TableReader>& axes,
                                    const RobotModel& robot) {
  std::vector<ChainJoint> joints;
  for (std::size_t i = 0; i < axes.size(); ++i) {
    if (!axes[i].has("joint")) continue;
    if (joints.size() < i) axes[i].fail("joint", "the axes before it have none; they come first");
    const Axis& axis = robot.axes[i];
    joints.push_back({read_pose(axes[i].table("joint", {"place", "turn"})),
                      axis.kind == AxisKind::Linear, axis.min, axis.max});
  }
  if (joints.empty()) file.fail("kinematics", "a chain has [axis.joint] at its axes");
  return joints;
}

/// Which of x, y, z, a, b, c a target says; none where the axes cannot place the tool.
std::vector<int> read_coordinates(const TableReader& file, std::size_t joints) {
  if (!file.has("free"))
    return joints < kOfPose ? std::vector<int>{} : std::vector{0, 1, 2, 3, 4, 5};
  const bool c = file.choice("free", {"c", "ab"}) == 0;
  if (c && joints != 5) file.fail("free", "\"c\" is of five axes, where the place decides c");
  if (!c && joints != 4)
    file.fail("free", "\"ab\" is of four axes, which turn the tool about z alone");
  return c ? std::vector{0, 1, 2, 3, 4} : std::vector{0, 1, 2, 5};
}

/// The last axis, off the chain.
int gripper_axis(const TableReader& file, const std::vector<TableReader>& axes,
                 const RobotModel& robot) {
  if (!file.has("gripper")) return -1;
  const TableReader gripper = file.table("gripper", {"axis"});
  const std::string name = gripper.name("axis");
  const int last = robot.axis_count() - 1;
  if (robot.axes.back().name != name)
    gripper.fail("axis", "must be the last axis, which is " + robot.axes.back().name);
  if (axes.back().has("joint"))
    gripper.fail("axis", "has [axis.joint]: a gripper does not move the tool");
  return last;
}

}  // namespace

void read_chain(const TableReader& file, const std::vector<TableReader>& axes, RobotModel& robot) {
  std::vector<ChainJoint> joints = read_joints(file, axes, robot);
  const Pose flange = read_pose(file.table("chain", {"place", "turn"}));
  robot.coordinates = read_coordinates(file, joints.size());
  robot.tool_coordinates = !robot.coordinates.empty();
  robot.gripper = gripper_axis(file, axes, robot);
  robot.kinematics = std::make_shared<const ChainKinematics>(
      JointChain(std::move(joints), flange), robot.axis_count(), robot.coordinates,
      robot.coordinates.size() == 5 ? Freedom::C : Freedom::None);
}

}  // namespace rob::motion
