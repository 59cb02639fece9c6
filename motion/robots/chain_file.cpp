#include "motion/robots/chain_file.h"

#include <utility>

#include "base/unit_factors.h"

namespace rob::motion {

namespace {

constexpr Range kStep{-10, 10};  // [choice] as the steps of an arm
constexpr Range kTurn{-kFullTurn, kFullTurn};

Pose read_pose(const TableReader& table) {
  const std::vector<double> place = table.quantities("place", Quantity::Length, kStep, 3);
  const std::vector<double> turn = table.quantities("turn", Quantity::Angle, kTurn, 3);
  return {{place[0], place[1], place[2]}, orientation_from({turn[0], turn[1], turn[2]})};
}

}  // namespace

std::shared_ptr<const ChainKinematics> read_chain(const TableReader& file,
                                                  const std::vector<TableReader>& axes) {
  std::vector<Pose> joints;
  for (std::size_t i = 0; i < axes.size(); ++i) {
    if (!axes[i].has("joint")) continue;
    if (joints.size() < i) axes[i].fail("joint", "the axes before it have none; they come first");
    joints.push_back(read_pose(axes[i].table("joint", {"place", "turn"})));
  }
  if (joints.empty()) file.fail("kinematics", "a chain has [axis.joint] at its axes");
  const Pose flange = read_pose(file.table("chain", {"place", "turn"}));
  return std::make_shared<const ChainKinematics>(std::move(joints), flange,
                                                 static_cast<int>(axes.size()));
}

}  // namespace rob::motion
