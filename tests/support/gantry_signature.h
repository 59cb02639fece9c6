#pragma once

#include "lang/machine/robot_signature.h"

namespace rob::test {

/// The gantry as the language sees it. Its signals' numbers are their order here.
inline lang::RobotSignature gantry_signature() {
  return {.name = "gantry",
          .coordinates = {{.name = "x", .dimension = lang::kLength},
                          {.name = "y", .dimension = lang::kLength},
                          {.name = "theta", .dimension = lang::kAngle}},
          .axes = {{.name = "x", .dimension = lang::kLength},
                   {.name = "y", .dimension = lang::kLength},
                   {.name = "theta", .dimension = lang::kAngle}},
          .signals = {{.name = "lift", .output = true, .channel = 9},
                      {.name = "gripper", .output = true, .channel = 10},
                      {.name = "lift_up", .output = false, .channel = 10},
                      {.name = "lift_down", .output = false, .channel = 9},
                      {.name = "gripper_open", .output = false, .channel = 11},
                      {.name = "gripper_closed", .output = false, .channel = 12},
                      {.name = "", .output = true, .channel = 1},
                      {.name = "", .output = false, .channel = 1},
                      {.name = "", .output = true, .channel = 1, .analog = true},
                      {.name = "", .output = false, .channel = 1, .analog = true}}};
}

}  // namespace rob::test
