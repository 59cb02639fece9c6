#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <vector>

#include "lang/machine/robot_signature.h"
#include "lang/syntax/plain_motion.h"

namespace rob::lang {

/// What a robot's coordinates make of such motions.
class PlainTargets {
 public:
  struct Target {
    std::uint8_t given = 0;                        ///< as in MoveCommand
    std::array<double, kMaxCoordinates> values{};  ///< SI; what is not given is 0
  };

  explicit PlainTargets(const RobotSignature& robot) : robot_(robot) {}
  /// Nothing where components do not fit the robot: then the checker tells. `file`: the number of
  /// the file that it stands in.
  std::optional<Target> of(const PlainMotion& motion, std::uint32_t file);

 private:
  const RobotSignature& robot_;
  std::uint32_t file_ = 0;   ///< that units_ are of
  std::vector<Unit> units_;  ///< of bare numbers, by coordinate
};

}  // namespace rob::lang
