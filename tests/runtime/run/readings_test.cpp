#include <doctest/doctest.h>

#include <array>
#include <atomic>
#include <thread>

#include "lang/values/pose_slots.h"
#include "runtime/tick/latest_values.h"
#include "tests/support/stepped_run.h"

using rob::lang::PoseValue;
using rob::lang::Reading;
using rob::lang::Reply;
using rob::lang::Slot;
using rob::test::SteppedRun;

namespace {

std::vector<std::string> printed_by(const std::string& program) {
  return SteppedRun(program).run().output;
}

}  // namespace

TEST_CASE("CLOCK behind an exact motion is read in the first cycle of standstill") {
  // Every short motion and every stop of the gantry takes 2.75 s.
  CHECK(printed_by("MOVE(40,0,0)\nSTOP\nPRINT CLOCK") == std::vector<std::string>{"5.51s"});
}

TEST_CASE("WAITs for what holds already are answered in one cycle of standstill") {
  CHECK(printed_by("MOVE(40,0,0)\nWAIT NOT DIN[1]\nVAR t = CLOCK\nWAIT NOT DIN[1]\n"
                   "WAIT NOT DIN[2]\nPRINT t, \" \", CLOCK") ==
        std::vector<std::string>{"5.51s 5.51s"});
}

TEST_CASE("CLOCK behind a motion that is not exact is that of its decision point") {
  // The line ends at 2.75 + 5 s; its successor is fetched at 7.75 s, and the world is read in the
  // last cycle that begins a period of 10 ms before.
  CHECK(printed_by("MOVE(40,0,0)\nMOVE(140,0,0)\nPRINT CLOCK\nMOVE(40,0,0)") ==
        std::vector<std::string>{"7.74s"});
}

TEST_CASE("a loop that reads the clock sees it go on") {
  CHECK(printed_by("WHILE CLOCK < 0.5s DO\nENDWHILE\nPRINT CLOCK") ==
        std::vector<std::string>{"0.5s"});
}

TEST_CASE("the time of every cycle is printed as the decimal that it is") {
  const auto lines =
      printed_by("VAR t = CLOCK\nWHILE t < 16s DO\n  PRINT t\n  t = CLOCK\nENDWHILE");
  CHECK(lines.size() >= 800);
  for (const std::string& line : lines) {
    const std::size_t point = std::min(line.find('.'), line.size() - 2);
    CHECK(line.size() - point <= std::string_view(".01s").size());
  }
}

TEST_CASE("the machine tells where the tool is, and where it was told to go") {
  SteppedRun run("MOVE(140,40,90)");
  auto& machine = run.controller.machine();
  std::array<Slot, rob::lang::kPoseSlots> slots{};
  run.run();
  REQUIRE(machine.read(1, Reading::Here, slots.data()) == Reply::Done);
  const PoseValue here = rob::lang::load_pose(slots.data());
  CHECK(here.position.x == doctest::Approx(0.14));
  CHECK(here.position.y == doctest::Approx(0.04));
  REQUIRE(machine.read(1, Reading::Target, slots.data()) == Reply::Done);
  const PoseValue target = rob::lang::load_pose(slots.data());
  CHECK(rob::lang::pose_math::distance(here, target) < 1e-12);
  CHECK(rob::lang::pose_math::turn(here, target) < 1e-12);
  REQUIRE(machine.read(1, Reading::Joints, slots.data()) == Reply::Done);
  CHECK(slots[2].real == doctest::Approx(1.5707963268));
}

TEST_CASE("the machine finds the axes of a pose, or says that there are none") {
  SteppedRun run("MOVE(140,40,90)");
  auto& machine = run.controller.machine();
  const std::array<double, 3> q{0.1, 0.2, 0.3};
  PoseValue pose;
  REQUIRE(machine.forward(1, q, pose) == Reply::Done);
  std::array<double, 3> found{};
  REQUIRE(machine.inverse(1, pose, {}, found) == Reply::Done);
  for (std::size_t i = 0; i < 3; ++i) CHECK(found[i] == doctest::Approx(q[i]));
  pose.position.z = 0.02;
  REQUIRE(machine.inverse(1, pose, q, found) == Reply::Refused);
  CHECK(machine.refusal().message.starts_with(
      "gantry cannot bring its tool to POSE(100mm, 200mm, 20mm"));
  CHECK(machine.refusal().help ==
        "gantry places its tool in the plane z = 0mm and turns it about z alone");
}

TEST_CASE("a reader of the joints never gets parts of two instants") {
  rob::runtime::LatestValues latest;
  std::atomic<bool> over{false};
  latest.store(rob::motion::JointVector::Constant(8, 0));
  std::thread writer([&] {
    for (int i = 1; i <= 100'000; ++i) latest.store(rob::motion::JointVector::Constant(8, i));
    over = true;
  });
  bool whole = true;
  while (!over) {
    const rob::motion::JointVector q = latest.load();
    whole = whole && q.size() == 8 && (q.array() == q[0]).all();
  }
  writer.join();
  CHECK(whole);
  CHECK(latest.load()[7] == 100'000);
}
