#pragma once

#include "lang/robot_signature.h"

namespace rob::test {

/// The gantry as the language sees it. Its signals' numbers are their order here.
inline lang::RobotSignature gantry_signature() {
  return {.name = "gantry",
          .coordinates = {{.name = "x", .dimension = lang::kLength},
                          {.name = "y", .dimension = lang::kLength},
                          {.name = "theta", .dimension = lang::kAngle}},
          .signals = {{.name = "lift", .output = true},
                      {.name = "gripper", .output = true},
                      {.name = "lift_up", .output = false},
                      {.name = "lift_down", .output = false},
                      {.name = "gripper_open", .output = false},
                      {.name = "gripper_closed", .output = false}}};
}

}  // namespace rob::test
