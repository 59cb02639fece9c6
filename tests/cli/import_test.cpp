// `rob robot import` from outside: what it writes, prints and returns.

#include <doctest/doctest.h>

#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

#include "tests/support/rob_command.h"

using rob::test::contains;
using rob::test::ProcessResult;
using rob::test::RobCommand;
using rob::test::run_process;

namespace {

const char* const kTwoAxes =
    "<robot name='two'><link name='base'><collision><geometry><mesh"
    " filename='package://two_description/meshes/base.stl' scale='0.001 0.001 0.001'/></geometry>"
    "</collision></link><link name='upper'/><link name='lower'/>"
    "<joint name='one' type='revolute'><parent link='base'/><child link='upper'/>"
    "<axis xyz='0 1 0'/><limit lower='-1' upper='1' effort='9' velocity='2'/></joint>"
    "<joint name='two' type='continuous'><parent link='upper'/><child link='lower'/>"
    "<origin xyz='0 0 0.5'/><axis xyz='0 1 0'/><limit effort='9' velocity='2'/></joint></robot>\n";

/// A tetrahedron of 100 mm, in mm.
const char* const kStl =
    "solid base\n"
    "facet normal 0 0 -1\nouter loop\nvertex 0 0 0\nvertex 0 100 0\nvertex 100 0 0\nendloop\n"
    "endfacet\nfacet normal 0 -1 0\nouter loop\nvertex 0 0 0\nvertex 100 0 0\nvertex 0 0 100\n"
    "endloop\nendfacet\nfacet normal -1 0 0\nouter loop\nvertex 0 0 0\nvertex 0 0 100\n"
    "vertex 0 100 0\nendloop\nendfacet\nfacet normal 1 1 1\nouter loop\nvertex 100 0 0\n"
    "vertex 0 100 0\nvertex 0 0 100\nendloop\nendfacet\nendsolid base\n";

ProcessResult import_of(const std::vector<std::string>& more) {
  std::vector<std::string> words{ROB_BINARY, "robot", "import"};
  words.insert(words.end(), more.begin(), more.end());
  return run_process(words);
}

}  // namespace

TEST_CASE("an imported arm is a file that runs; what cannot be imported leaves no file") {
  const RobCommand rob("MOVE JOINTS(20deg, 90deg)\nSTOP\n");
  const std::string urdf = rob.file("two.urdf");
  const std::string robot = rob.file("two.toml");
  std::ofstream(urdf) << kTwoAxes;

  const ProcessResult without_mesh = import_of({urdf, "-o", robot});
  CHECK(without_mesh.exit_code == 65);
  CHECK(contains(without_mesh.err, "package://two_description/meshes/base.stl"));
  CHECK(contains(without_mesh.err, "--package DIR"));
  CHECK(!std::filesystem::exists(robot));

  std::filesystem::create_directories(rob.file("two_description/meshes"));
  std::ofstream(rob.file("two_description/meshes/base.stl")) << kStl;
  const ProcessResult made = import_of({urdf, "-o", robot});
  CHECK(made.exit_code == 0);
  CHECK(made.err == "");
  CHECK(made.out.starts_with(robot + ": 2 axes from base to lower\n"));
  CHECK(contains(made.out, "    base "));
  CHECK(contains(made.out, "look up in the data sheet"));
  CHECK(rob("run", {"--robot", robot, "--fast"}).exit_code == 0);

  const ProcessResult shown = run_process({ROB_BINARY, "robots", robot});
  CHECK(shown.exit_code == 0);
  CHECK(shown.out.starts_with("two: 2 axes, imported from two.urdf\n"));
  CHECK(contains(shown.out, "its flange gets up to 500 mm from the origin of its base\n"));

  // A later refusal leaves the file as it is.
  CHECK(import_of({urdf, "--tip", "none", "-o", robot}).exit_code == 65);
  CHECK(std::filesystem::exists(robot));
  CHECK(import_of({rob.file("none.urdf"), "-o", robot}).exit_code == 74);
  CHECK(import_of({urdf, "-o", rob.file("none/two.toml")}).exit_code == 74);
  CHECK(import_of({urdf}).exit_code == 64);
}
