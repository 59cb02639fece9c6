#include <doctest/doctest.h>

#include <string>
#include <vector>

#include "lang/compile/compile.h"
#include "motion/robots/robot_library.h"
#include "runtime/command/program_task.h"
#include "runtime/command/robot_machine.h"
#include "runtime/words/signature.h"

using namespace rob;
using motion::SegmentDescriptor;

namespace {

/// A program on the gantry under the look-ahead law, up to the buffer: what comes out there, taken
/// whenever the program waits.
struct PathRun {
  motion::RobotModel robot = motion::embedded_robot("gantry");
  std::vector<SegmentDescriptor> queued;
  std::size_t most_at_once = 0;
  std::optional<lang::RuntimeError> failure;

  explicit PathRun(const std::string& text, int look_ahead = 64,
                   motion::Law law = motion::Law::LookAhead) {
    robot.law = law;
    robot.look_ahead = look_ahead;
    motion::LookAheadBuffer buffer(static_cast<std::size_t>(look_ahead));
    motion::MotionPlanner planner(robot, robot.start);
    runtime::Channels channels;
    runtime::ProgramLog log;
    runtime::RobotMachine machine(robot, planner, buffer, channels, channels.program, log);
    const lang::Compilation compilation = lang::compile(text, runtime::signature_of(robot));
    REQUIRE(compilation.chunk.has_value());
    runtime::ProgramTask task(*compilation.chunk, machine);
    for (int i = 0; i < 1000; ++i) {
      const bool over = task.step(1'000'000) == runtime::ProgramTask::State::Over;
      take(buffer, channels);
      if (over) break;
      REQUIRE(i < 999);
    }
    failure = task.failure();
  }

  std::vector<std::uint32_t> numbers() const {
    std::vector<std::uint32_t> all;
    for (const SegmentDescriptor& one : queued) all.push_back(one.number);
    return all;
  }

 private:
  /// All that was commanded has been done.
  void take(motion::LookAheadBuffer& buffer, runtime::Channels& channels) {
    std::size_t count = 0;
    while (const SegmentDescriptor* const next = buffer.next_segment()) {
      queued.push_back(*next);
      buffer.pop_segment();
      ++count;
    }
    most_at_once = std::max(most_at_once, count);
    std::int64_t effects = channels.program.effects_done;
    while (buffer.next_effect() != nullptr) {
      buffer.pop_effect();
      ++effects;
    }
    channels.program.effects_done = effects;
    if (!queued.empty()) {
      channels.program.decidable = queued.back().number;
      channels.program.settled = queued.back().number;
    }
    ++channels.cycle;
  }
};

using Numbers = std::vector<std::uint32_t>;

}  // namespace

TEST_CASE("the places of a PATH count along all of it") {
  const PathRun run(
      "MOVE(40, 0, 0)\n"
      "PATH AT 8mm/s ZONE 1mm DO\n"
      "  AFTER 15mm LEAD 120ms : lift = ON\n"
      "  MOVEL(50, 0, 0)\n"
      "  MOVEL(50, 20, 0) FINE\n"
      "  BEFORE 5mm : gripper = ON\n"
      "  MOVEL(80, 20, 0)\n"
      "ENDPATH\n"
      "MOVE(80, 40, 0)\n");
  CHECK_FALSE(run.failure);
  REQUIRE(run.numbers() == Numbers{1, 2, 3, 4, 5, 6, 7});  // with FINE, and the end
  CHECK(run.queued[1].on_the_way.size() == 0);
  const SegmentDescriptor& second = run.queued[2];  // 10 mm to 30 mm of the path
  REQUIRE(second.on_the_way.size() == 1);
  CHECK(second.on_the_way[0].share == doctest::Approx(0.25));
  CHECK(second.on_the_way[0].lead == doctest::Approx(0.12));
  CHECK(second.on_the_way[0].effect.after == 3);
  CHECK(run.queued[3].no_length);
  const SegmentDescriptor& third = run.queued[4];  // 30 mm to 60 mm
  REQUIRE(third.on_the_way.size() == 1);
  CHECK(third.on_the_way[0].share == doctest::Approx(25 / 30.0));
  CHECK(third.on_the_way[0].lead == 0);
  CHECK(third.ahead.speed == doctest::Approx(0.008));
  CHECK(third.ahead.miss == doctest::Approx(0.001));
}

TEST_CASE(
    "a place at a border of two motions of a PATH belongs to the first, at the ends to the ends") {
  const PathRun run(
      "PATH DO\n"
      "  MOVEL(10, 0, 0)\n"
      "  MOVEL(10, 20, 0)\n"
      "  AFTER 0mm : lift = ON\n"
      "  AFTER 10mm : gripper = ON\n"
      "  BEFORE 0mm : lift = OFF\n"
      "ENDPATH\n");
  REQUIRE(run.queued.size() == 3);
  REQUIRE(run.queued[0].on_the_way.size() == 2);
  CHECK(run.queued[0].on_the_way[0].share == 0);
  CHECK(run.queued[0].on_the_way[1].share == doctest::Approx(1));
  REQUIRE(run.queued[1].on_the_way.size() == 1);
  CHECK(run.queued[1].on_the_way[0].share == doctest::Approx(1));
}

TEST_CASE("on an arc in a PATH a place counts along the arc") {
  // 30 mm, then half a circle of 50 mm radius, 157.08 mm.
  const PathRun run(
      "PATH DO\n"
      "  MOVEL(30, 0, 0)\n"
      "  MOVEC VIA (80, 50, 0) TO (130, 0, 0)\n"
      "  AFTER 69.26990817mm : lift = ON\n"
      "ENDPATH\n");
  REQUIRE(run.queued.size() == 3);
  REQUIRE(run.queued[1].path != nullptr);
  REQUIRE(run.queued[1].on_the_way.size() == 1);
  CHECK(run.queued[1].on_the_way[0].share == doctest::Approx(0.25));
}

TEST_CASE(
    "of a PATH that cannot be gone nothing is queued, and the motion before it becomes exact") {
  const char* const paths[] = {
      "VAR x = 900\nMOVE(10, 0, 0)\nPATH DO\nMOVEL(20, 0, 0)\nMOVEL(x, 0, 0)\nENDPATH\n",
      "MOVE(10, 0, 0)\nPATH DO\nAFTER 31mm : lift = ON\nMOVEL(20, 0, 0)\nMOVEL(40, 0, "
      "0)\nENDPATH\n",
      "MOVE(10, 0, 0)\nPATH DO\nBEFORE 31mm : lift = ON\nMOVEL(20, 0, 0)\nMOVEL(40, 0, "
      "0)\nENDPATH\n",
      "MOVE(10, 0, 0)\nPATH DO\nAFTER 0mm : lift = ON\nMOVEL(10, 0, 0)\nENDPATH\n"};
  const char* const codes[] = {"E401", "E530", "E530", "E530"};
  for (std::size_t i = 0; i < 4; ++i) {
    CAPTURE(i);
    const PathRun run(paths[i]);
    REQUIRE(run.failure);
    CHECK(run.failure->code == codes[i]);
    CAPTURE(run.queued.size());
    REQUIRE(run.numbers() == Numbers{1, 2});
    CHECK(run.queued[1].no_length);
    CHECK(run.queued[1].target[0] == doctest::Approx(0.01));
  }
}

TEST_CASE("behind a PATH that could not be gone the program can go on from before it") {
  const PathRun run(
      "VAR x = 900\n"
      "MOVE(10, 0, 0)\n"
      "TRY\n"
      "  PATH DO\n"
      "    MOVEL(20, 30, 0)\n"
      "    MOVEL(x, 0, 0)\n"
      "  ENDPATH\n"
      "RESCUE\n"
      "  MOVE BY (5, , )\n"
      "ENDTRY\n");
  CHECK_FALSE(run.failure);
  REQUIRE(run.numbers() == Numbers{1, 2, 3, 4});
  CHECK(run.queued[2].target[0] == doctest::Approx(0.015));
  CHECK(run.queued[2].target[1] == 0);
}

TEST_CASE(
    "a PATH longer than the buffer is planned before any of it is queued, and then as it fits") {
  const PathRun run(
      "PATH DO\n"
      "  FOR i = 1 TO 20 DO\n"
      "    MOVEL(10 * i, 0, 0)\n"
      "  ENDFOR\n"
      "  BEFORE 195mm : lift = ON\n"
      "ENDPATH\n",
      4);
  CHECK_FALSE(run.failure);
  CHECK(run.most_at_once == 4);
  REQUIRE(run.queued.size() == 21);
  CHECK(run.queued[0].on_the_way.size() == 1);  // known when all of it was
  CHECK(run.queued[19].target[0] == doctest::Approx(0.2));
}

TEST_CASE("a motion of a PATH has eight places at most") {
  std::string text = "PATH DO\nMOVEL(100, 0, 0)\n";
  for (int i = 1; i <= 9; ++i) text += "AFTER " + std::to_string(i) + "mm : lift = ON\n";
  const PathRun run(text + "ENDPATH\n");
  REQUIRE(run.failure);
  CHECK(run.failure->code == "E531");
  CHECK(run.failure->place.line == 11);  // the ninth
  CHECK(run.queued.empty());
}

TEST_CASE("under Paul's law a PATH is refused when the program comes to it") {
  const PathRun run("MOVE(10, 0, 0)\nPATH DO\nMOVEL(20, 0, 0)\nENDPATH\n", 64, motion::Law::Paul);
  REQUIRE(run.failure);
  CHECK(run.failure->code == "E550");
  CHECK(run.queued.size() == 2);
}
