#include <doctest/doctest.h>

#include <string>
#include <vector>

#include "lang/compile/compile.h"
#include "lang/vm/printing_machine.h"
#include "lang/vm/vm.h"

using namespace rob::lang;

namespace {

/// Six axes that are those of the tool itself.
RobotSignature six_axes() {
  RobotSignature robot;
  robot.name = "six";
  for (const char* name : {"x", "y", "z"}) robot.coordinates.push_back({name, kLength});
  for (const char* name : {"a", "b", "c"}) robot.coordinates.push_back({name, kAngle});
  for (const char* name : {"q1", "q2", "q3", "q4", "q5", "q6"})
    robot.axes.push_back({name, kAngle});
  robot.signals = {{.name = "", .output = true, .channel = 3},
                   {.name = "", .output = false, .channel = 5},
                   {.name = "", .output = true, .channel = 1, .analog = true}};
  return robot;
}

/// Upside down, at a place in mm.
PointTable::Point point(const char* name, double x, double y, double z) {
  return {name, "", {{x / 1000, y / 1000, z / 1000}, {0, 1, 0, 0}}};
}

}  // namespace

TEST_CASE(
    "a seam of an arm: a path with a line, an arc and a spline, and what is done on its way") {
  const std::string seam =
      "ROBOT \"six\"\n"
      "POINT  w0, w1, mid, w2, w3\n"
      "SIGNAL torch   = DOUT[3]  SAFE OFF\n"
      "SIGNAL arc_ok  = DIN[5]\n"
      "SIGNAL wire: SPEED = AOUT[1] SCALE 0mm/s TO 300mm/s SAFE 0mm/s\n"
      "CONST  up = (0mm, 0mm, 50mm)\n"
      "MOVE  w0 + up ZONE 15mm\n"
      "MOVEL w0 AT 100mm/s FINE\n"
      "PATH AT 8mm/s ZONE 1mm DO\n"
      "  AFTER  2mm            : torch = ON\n"
      "  AFTER  2mm LEAD 120ms : wire = 90mm/s\n"
      "  MOVEL  w1\n"
      "  MOVEC  VIA mid TO w2\n"
      "  MOVES  VIA (510mm, 40mm, 80mm), (520mm, 46mm, 80mm) TO w3\n"
      "  BEFORE 6mm            : wire = 0mm/s\n"
      "  BEFORE 3mm            : torch = OFF\n"
      "ENDPATH\n"
      "MOVEL BY up AT 100mm/s\n"
      "STOP\n"
      "IF NOT arc_ok THEN PRINT \"check the seam\"\n"
      "END\n";
  const RobotSignature robot = six_axes();
  const Compilation compilation =
      compile(seam, robot,
              {{point("w0", 400, 0, 80), point("w1", 450, 0, 80), point("mid", 480, 10, 80),
                point("w2", 500, 30, 80), point("w3", 540, 50, 80)}});
  CHECK_FALSE(compilation.diagnostics.has_errors());  // a warning: mid hides MID
  REQUIRE(compilation.chunk.has_value());
  PrintingMachine machine(robot);
  Vm vm(*compilation.chunk, machine);
  CHECK(vm.run(1000) == Vm::State::Done);
  CHECK(machine.texts() ==
        std::vector<std::string>{"move pose 400 0 130 180 0 0 zone 15mm",
                                 "movel pose 400 0 80 180 0 0 at 100mm/s fine",
                                 "path",
                                 "after 2mm",
                                 "DOUT[3] on",
                                 "after 2mm lead 0.12s",
                                 "AOUT[1] 3V",
                                 "movel pose 450 0 80 180 0 0 at 8mm/s zone 1mm",
                                 "via pose 480 10 80 180 0 0",
                                 "movec pose 500 30 80 180 0 0 at 8mm/s zone 1mm",
                                 "via 510 40 80 - - -",
                                 "via 520 46 80 - - -",
                                 "moves pose 540 50 80 180 0 0 at 8mm/s zone 1mm",
                                 "before 6mm",
                                 "AOUT[1] 0V",
                                 "before 3mm",
                                 "DOUT[3] off",
                                 "end path",
                                 "movel by pose 0 0 50 at 100mm/s",
                                 "stop",
                                 "print check the seam",
                                 "end"});
}

TEST_CASE(
    "three of six components keep the orientation, in a frame, with a tool and in a JOG too") {
  const RobotSignature robot = six_axes();
  const Compilation compilation = compile(
      "FRAME pallet = POSE(200mm, 100mm, 50mm, 0deg, 0deg, 90deg)\n"
      "TOOL cup = POSE(0mm, 0mm, 120mm) MASS 0.8kg\n"
      "MOVE(400, 0, 300, 180, 0, 0)\n"
      "MOVE(10, 20, 5) IN pallet WITH cup\n"
      "ASSERT DIST(TARGET, POSE(180mm, 110mm, 175mm)) < 1um\n"  // the flange, above its tip
      "ASSERT TURN(TARGET, POSE(0mm, 0mm, 0mm, 180deg, 0deg, 0deg)) < 0.001deg\n"
      "MOVEL BY (0mm, 0mm, 5mm, 0deg, 0deg, 0deg) IN TOOL\n"
      "ASSERT DIST(TARGET, POSE(180mm, 110mm, 170mm)) < 1um\n"  // the tool's z points down
      "JOG TOOL (1mm/s, 0mm/s, 0mm/s) FOR 20ms\n",
      robot);
  REQUIRE(compilation.chunk.has_value());
  PrintingMachine machine(robot);
  Vm vm(*compilation.chunk, machine);
  CHECK(vm.run(1000) == Vm::State::Done);
  CHECK(machine.texts()[machine.texts().size() - 2] == "jog tool 1 0 0 - - - for 0.02s");
}
