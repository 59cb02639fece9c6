// `--cell FILE.toml`: what stands around the robot of any program.
#include <doctest/doctest.h>

#include <fstream>

#include "tests/support/rob_command.h"

using nlohmann::json;
using rob::test::contains;
using rob::test::ProcessResult;
using rob::test::RobCommand;

namespace {

const std::string kAcross =
    "TOOL pen = POSE(0mm, 0mm, 80mm) SHAPE CAPSULE((0mm, 0mm, 0mm), (0mm, 0mm, 80mm), 5mm)\n"
    "WITH pen DO\nMOVE(40, 40, 0) FINE\nMOVE(140, 40, 0)\nENDWITH\n";

const std::string kBall =
    "[[obstacle]]\nname = \"ball\"\nkind = \"sphere\"\nradius = \"10 mm\"\n"
    "place = [\"100 mm\", \"40 mm\", \"50 mm\"]\n";

std::string cell_of(const RobCommand& rob, const std::string& text) {
  std::ofstream(rob.file("cell.toml")) << text;
  return rob.file("cell.toml");
}

}  // namespace

TEST_CASE("what stands in a cell's file is hit, by check and by run") {
  const RobCommand rob(kAcross);
  const std::string cell = cell_of(rob, kBall);
  CHECK(rob("check").exit_code == 0);
  const ProcessResult checked = rob("check", {"--cell", cell, "--json"});
  CHECK(checked.exit_code == 65);
  const json report = json::parse(checked.out);
  const json& hit = report["findings"].back();
  CHECK(hit["code"] == "E580");
  CHECK(hit["line"] == 4);
  CHECK(hit["link"] == "gripper");
  CHECK(hit["obstacle"] == "ball");
  CHECK(hit["at_s"].get<double>() == doctest::Approx(3.6).epsilon(0.01));
  CHECK(rob("run", {"--cell", cell, "--fast"}).exit_code == 70);
}

TEST_CASE("a program may ALLOW what the cell's file names") {
  const RobCommand rob("ALLOW ball DO\n" + std::string("MOVE(40, 40, 0)\nENDALLOW\n"));
  CHECK(contains(rob("check").err, "E592"));
  CHECK(rob("check", {"--cell", cell_of(rob, kBall)}).exit_code == 0);
  CHECK(rob("run", {"--cell", rob.file("cell.toml"), "--fast"}).exit_code == 0);
}

TEST_CASE("a mesh of a cell's file stands beside it") {
  const RobCommand rob(kAcross);
  const std::string cell =
      cell_of(rob,
              "[[obstacle]]\nname = \"tip\"\nkind = \"mesh\"\nfile = \"tip.obj\"\n"
              "place = [\"100 mm\", \"40 mm\", \"40 mm\"]\n");
  const ProcessResult missing = rob("check", {"--cell", cell});
  CHECK(missing.exit_code != 0);
  CHECK(contains(missing.err, "cell.toml:4:"));
  CHECK(contains(missing.err, "tip.obj"));
  std::ofstream(rob.file("tip.obj")) << "v 0 0 0\nv 0.1 0.05 0\nv 0.1 -0.05 0\nv 0.1 0 0.05\n"
                                        "f 1 2 3\nf 1 2 4\nf 1 3 4\nf 2 3 4\n";
  const ProcessResult hit = rob("check", {"--cell", cell});
  CHECK(hit.exit_code == 65);
  CHECK(contains(hit.err, "gripper hits tip"));
}

TEST_CASE("a cell's file has obstacles and nothing else") {
  const RobCommand rob(kAcross);
  const auto refused = [&](const std::string& text) {
    return rob("check", {"--cell", cell_of(rob, text)}).err;
  };
  CHECK(contains(refused("name = \"cell\"\n"), "cell.toml:1:1: unknown key \"name\""));
  CHECK(contains(refused(kBall + kBall), "another obstacle of this name"));
  CHECK(contains(refused("[[obstacle]\n"), "cell.toml:1:"));
  CHECK(rob("check", {"--cell", rob.file("none.toml")}).exit_code != 0);
  CHECK(rob("check", {"--cell", rob.file("cell.txt")}).exit_code == 64);
}
