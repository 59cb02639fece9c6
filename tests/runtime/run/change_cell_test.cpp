#include <doctest/doctest.h>

#include <variant>
#include <vector>

#include "runtime/cli/options.h"
#include "runtime/run/load.h"
#include "runtime/run/simulation.h"

namespace rob::runtime {
namespace {

Options parsed(std::vector<const char*> words) {
  const auto options = parse_command_line(static_cast<int>(words.size()), words.data());
  REQUIRE(std::holds_alternative<Options>(options));
  return std::get<Options>(options);
}

}  // namespace

TEST_CASE("the simulated cell is another one only where --seed is written") {
  CHECK_FALSE(parsed({"rob", "run", "a.rob"}).cell);
  CHECK(parsed({"rob", "run", "a.rob"}).seed == lang::Random::kDefaultSeed);
  for (const char* command : {"run", "check", "test"}) {
    const Options options = parsed({"rob", command, "a.rob", "--seed", "1"});
    CHECK(options.seed == 1);
    CHECK(options.cell == 1);
  }
}

TEST_CASE("another cell leaves what the robot file says of forces") {
  const motion::RobotModel nominal = load_robot("lwa4p");
  motion::RobotModel robot = nominal;
  change_cell(robot, 1);
  CHECK(robot.cell->contact.stiffness != nominal.cell->contact.stiffness);
  CHECK(robot.force.stiffness == nominal.force.stiffness);
  CHECK(robot.force.delay == nominal.force.delay);
  motion::RobotModel gantry = load_robot("gantry");
  change_cell(gantry, 1);
  CHECK_FALSE(gantry.cell);
}

}  // namespace rob::runtime
