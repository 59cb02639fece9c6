#pragma once

#include <memory>
#include <vector>

#include "lang/values/setting.h"
#include "motion/collision/clearance.h"
#include "motion/robots/robot_model.h"

namespace rob::runtime {

/// All that the robot can hit at a place of the program: itself and what stands around it, with the
/// SHAPE of the tool in use, but for what ALLOW lets touch.
class Touching {
 public:
  using Shared = std::shared_ptr<const motion::Clearance>;

  explicit Touching(const motion::RobotModel& robot) : robot_(robot), data_(robot.collision) {}

  /// These stand there, too, in place of earlier ones of their names.
  void add(const std::vector<motion::Obstacle>& obstacles);
  /// The same one as long as nothing changes.
  Shared in(const lang::Setting& setting);

 private:
  /// The part of a Setting that counts here.
  struct Known {
    decltype(lang::ToolValue::shape) shape;
    std::vector<std::string> allowed;
    Shared clearance;
  };

  Shared made(const Known& what) const;

  const motion::RobotModel& robot_;
  motion::CollisionData data_;
  std::vector<Known> known_;  ///< the last ones, the newest at the end
};

}  // namespace rob::runtime
