#include "lang/syntax/robot_name.h"

#include <doctest/doctest.h>

#include <string_view>

using rob::lang::declared_robot;

TEST_CASE("the robot of a text is the string after ROBOT at the beginning of a line") {
  const auto name = [](std::string_view source) {
    const auto found = declared_robot(source);
    return found ? found->name : "none";
  };
  CHECK(name("ROBOT \"ums7\"\n") == "ums7");
  CHECK(name("// ROBOT \"gantry\"\nrobot \"ums7\"\nMOVE(1, 2, 3)\n") == "ums7");
  CHECK(name("VAR t = \"gantry\"\nROBOT \"ums7\"\n") == "ums7");  // another string
  CHECK(name("USE \"tools.rob\"\nROBOT \"ums7\"\n") == "ums7");   // after another word
  CHECK(name("PRINT ROBOT \"gantry\"\n") == "none");              // not at the beginning
  CHECK(name("ROBOT\n\"ums7\"\n") == "none");                     // a statement is one line
  CHECK(name("MOVE(1, 2, 3)\nROBOT \"ums7\"\n") == "none");       // too late
  CHECK(name("") == "none");
  const auto placed = declared_robot("STOP\nROBOT \"ums7\"\n");
  REQUIRE(placed.has_value());
  CHECK(placed->place.line == 2);
  CHECK(placed->place.column == 7);
}
