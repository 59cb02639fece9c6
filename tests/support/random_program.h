#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "tests/support/paul_model.h"

namespace rob::test {

/// A program for the gantry, and what it must do.
struct RandomProgram {
  std::string text;
  std::vector<PaulStep> steps;      ///< every MOVE, STOP and END in the order they are executed
  std::vector<std::string> output;  ///< what PRINT must write
};

/// The random gantry program number `seed`: always the same for the same number, on every machine.
/// It is valid, stays within the robot's limits, and makes use of left-out and named components,
/// all units of length, angle and time, sums and products, AT, OVER, STOP, repeated MOVEs, PRINT
/// and FOR loops; its motions are short and long and go up to the limits.
RandomProgram random_gantry_program(std::uint64_t seed);

}  // namespace rob::test
