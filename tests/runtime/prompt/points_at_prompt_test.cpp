// Teaching at the prompt.

#include <fstream>

#include "runtime/files/files.h"
#include "tests/runtime/prompt/piped_prompt.h"

using namespace rob::runtime;
using rob::test::PipedPrompt;
using rob::test::ScratchFolder;

namespace {

std::string kept(const ScratchFolder& folder) {
  return read_file(folder.file("prompt.gantry.points"), 1'000'000);
}

}  // namespace

TEST_CASE(":teach declares the point and keeps it; MOVE goes there, also in the next session") {
  const ScratchFolder folder;
  {
    PipedPrompt prompt(folder);
    prompt.enter({"MOVE(40,20,90)", ":teach pick", "MOVE(0,0,0)", "MOVE pick"});
    CHECK(prompt.session.worst() == ExitCode::Done);
    CHECK(prompt.session.state_text() == "gantry idle (40, 20, 90)");
  }
  PipedPrompt next(folder);
  next.enter({"MOVE pick"});
  CHECK(next.session.worst() == ExitCode::Done);
  CHECK(next.session.state_text() == "gantry idle (40, 20, 90)");
}

TEST_CASE("teaching again moves the point for all that comes, programs included") {
  const ScratchFolder folder;
  PipedPrompt prompt(folder);
  prompt.enter({"MOVE(40,20,0)", ":teach pick", "VAR n = 7", "MOVE(60,20,0)", ":teach pick",
                "MOVE(0,0,0)", "MOVE pick"});
  CHECK(prompt.session.state_text() == "gantry idle (60, 20, 0)");
  prompt.enter({"MOVE(0,0,0)", ":insert 1 POINT pick", ":insert 2 MOVE pick", ":run"});
  CHECK(prompt.session.state_text() == "gantry idle (60, 20, 0)");
  CHECK(prompt.enter({"PRINT n"}) == "7\n");
}

TEST_CASE(":points lists pose, joints and the distance from here") {
  const ScratchFolder folder;
  PipedPrompt prompt(folder);
  prompt.enter({"MOVE(30,40,0)", ":teach pick", "MOVE(0,0,0)"});
  CHECK(prompt.enter({":points"}) ==
        "pick = POSE(30mm, 40mm, 0mm, 0deg, 0deg, 0deg) JOINTS(30mm, 40mm, 0deg) IN world TOOL "
        "none  50 mm from here\n");  // 3-4-5
}

TEST_CASE("a point is renamed and forgotten, and the old name means nothing any more") {
  const ScratchFolder folder;
  PipedPrompt prompt(folder);
  prompt.enter({"MOVE(30,40,0)", ":teach pick", ":teach other", "VAR n = 7", ":rename pick place",
                "MOVE(0,0,0)", "MOVE place"});
  CHECK(prompt.session.state_text() == "gantry idle (30, 40, 0)");
  CHECK(kept(folder).find("pick") == std::string::npos);
  prompt.said();
  prompt.enter({"MOVE pick"});
  CHECK(prompt.said().find("unknown name pick") != std::string::npos);
  prompt.enter({":forget place"});
  CHECK(kept(folder).find("place") == std::string::npos);
  prompt.enter({"MOVE place"});
  CHECK(prompt.said().find("unknown name place") != std::string::npos);
  CHECK(prompt.enter({"PRINT n"}) == "7\n");
  prompt.enter({"MOVE(0,0,0)", "MOVE other"});
  CHECK(prompt.session.state_text() == "gantry idle (30, 40, 0)");
  prompt.said();
  prompt.enter({":forget nobody"});
  CHECK(prompt.said() == "error: there is no point nobody\nhelp: :points lists them\n");
}

TEST_CASE(":points undo takes back what was taught, renamed or forgotten last") {
  const ScratchFolder folder;
  PipedPrompt prompt(folder);
  prompt.enter({"MOVE(40,20,0)", ":teach pick"});
  const std::string first = kept(folder);
  prompt.enter({"MOVE(60,20,0)", ":teach pick"});
  const std::string second = kept(folder);
  prompt.enter({":forget pick", ":points undo"});
  CHECK(kept(folder) == second);
  prompt.enter({":points undo"});
  CHECK(kept(folder) == first);
  prompt.enter({"MOVE(0,0,0)", "MOVE pick"});
  CHECK(prompt.session.state_text() == "gantry idle (40, 20, 0)");
  prompt.enter({":points undo", ":points undo"});
  CHECK(prompt.said().ends_with("error: no change of a point is left to take back\n"));
}

TEST_CASE("what others have written into the points file since is not undone") {
  const ScratchFolder folder;
  PipedPrompt prompt(folder);
  prompt.enter({"MOVE(40,20,0)", ":teach pick"});
  std::ofstream(folder.file("prompt.gantry.points"), std::ios::app) << "// by hand\n";
  prompt.enter({":points undo"});
  CHECK(prompt.said().find("has been changed by others since") != std::string::npos);
  CHECK(kept(folder).ends_with("// by hand\n"));
}

TEST_CASE("points of another robot leave the prompt usable, without points") {
  const ScratchFolder folder;
  std::ofstream(folder.file("prompt.gantry.points")) << "ROBOT \"ums7\"\n";
  PipedPrompt prompt(folder);
  CHECK(prompt.said().find("points are not kept at this prompt") != std::string::npos);
  CHECK(prompt.enter({"PRINT 1"}) == "1\n");
}

TEST_CASE("a taught and recorded program is saved with its points, and runs in the next session") {
  const ScratchFolder folder;
  const std::string file = folder.file("cell.rob");
  {
    PipedPrompt prompt(folder);
    prompt.enter({"MOVE(40,20,0)", ":teach pick", "MOVE(0,0,0)", ":record on", "MOVE pick", "STOP",
                  "PRINT HERE", ":record off", ":save " + file});
    CHECK(read_file(file, 1000) == "POINT pick\nMOVE pick\nSTOP\nPRINT HERE\n");
    CHECK(prompt.session.points_file() == folder.file("cell.points"));
  }
  PipedPrompt next(folder);
  CHECK(next.enter({":load " + file, ":run"}) == "POSE(40mm, 20mm, 0mm, 0deg, 0deg, 0deg)\n");
  CHECK(next.session.worst() == ExitCode::Done);
}

TEST_CASE("a points file that has become empty is any robot's") {
  const ScratchFolder folder;
  {
    PipedPrompt arm(folder, "irb120");
    arm.enter({":teach a", ":points undo", ":teach b", ":forget b"});
    CHECK(arm.session.worst() == ExitCode::Done);
  }
  PipedPrompt gantry(folder);
  gantry.enter({":teach c"});
  CHECK(gantry.said().empty());
  CHECK(gantry.enter({":points"}).starts_with("c = "));
}

TEST_CASE("each robot has its own points in a folder, and :robot brings them") {
  const ScratchFolder folder;
  {
    PipedPrompt prompt(folder);
    prompt.enter({"MOVE(40,20,0)", ":teach pick", ":robot irb120", ":teach home", ":robot gantry",
                  "MOVE pick"});
    CHECK(prompt.session.worst() == ExitCode::Done);
    CHECK(prompt.session.state_text() == "gantry idle (40, 20, 0)");
    CHECK(prompt.session.points_file() == folder.file("prompt.gantry.points"));
    prompt.enter({":robot irb120"});
    CHECK(prompt.enter({":points"}).starts_with("home = "));
  }
  PipedPrompt arm(folder, "irb120");
  CHECK(arm.enter({":points"}).starts_with("home = "));
}

TEST_CASE("an old points file belongs to the robot that its first line names") {
  const ScratchFolder folder;
  const std::string old =
      "// by hand\nROBOT \"gantry\"\n"
      "pick = POSE(30mm, 40mm, 0mm, 0deg, 0deg, 0deg) IN world TAUGHT \"by hand\"\n";
  std::ofstream(folder.file("prompt.points")) << old;
  PipedPrompt arm(folder, "irb120");
  CHECK(arm.said() == "");
  CHECK(arm.session.points_file() == folder.file("prompt.irb120.points"));
  PipedPrompt gantry(folder);
  gantry.enter({"MOVE pick"});
  CHECK(gantry.session.state_text() == "gantry idle (30, 40, 0)");
  CHECK(gantry.session.points_file() == folder.file("prompt.points"));
}

TEST_CASE(":rename renames in the program in memory, too, and :undo takes both back") {
  const ScratchFolder folder;
  PipedPrompt prompt(folder);
  prompt.enter({"MOVE(40,20,0)", ":teach pick", "MOVE(0,0,0)", ":insert 1 POINT pick",
                ":insert 2 MOVE pick // pick", ":rename pick place"});
  CHECK(prompt.said().ends_with("pick is place now; :undo takes it back\n"));
  CHECK(prompt.session.workshop().program.text() == "POINT place\nMOVE place // pick\n");
  prompt.enter({":run"});
  CHECK(prompt.session.state_text() == "gantry idle (40, 20, 0)");
  prompt.said();
  prompt.enter({":undo"});
  CHECK(prompt.said() == "undone: pick renamed to place\n");
  CHECK(prompt.session.workshop().program.text() == "POINT pick\nMOVE pick // pick\n");
  CHECK(kept(folder).find("place = ") == std::string::npos);
  CHECK(kept(folder).find("pick = ") != std::string::npos);
  prompt.enter({":redo"});
  CHECK(kept(folder).find("place = ") != std::string::npos);
  prompt.enter({":insert 1 VAR bin = 1", ":rename place bin"});
  CHECK(prompt.said().ends_with("error: the program in memory has the name bin already\n"));
}
