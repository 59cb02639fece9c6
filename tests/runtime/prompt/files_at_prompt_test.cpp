// :save, :load and the archive.

#include <fmt/format.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <filesystem>
#include <fstream>
#include <thread>

#include "runtime/files/files.h"
#include "runtime/files/points_file.h"
#include "runtime/run/load.h"
#include "tests/runtime/prompt/piped_prompt.h"
#include "tests/support/some_of.h"

using namespace rob::runtime;
using namespace std::chrono_literals;
using rob::test::PipedPrompt;
using rob::test::ScratchFolder;

namespace {

void write(const std::string& file, const std::string& text) { std::ofstream(file) << text; }
std::string content(const std::string& file) { return read_file(file, 1'000'000); }

/// A process that does this, which does not end, is killed so long after it has begun.
template <typename Work>
void kill_after(std::chrono::microseconds time, Work work) {
  int begun[2];
  REQUIRE(::pipe(begun) == 0);
  const pid_t child = ::fork();
  REQUIRE(child >= 0);
  if (child == 0) {
    if (::write(begun[1], "b", 1) != 1) ::_exit(1);
    work();
  }
  ::close(begun[1]);
  char byte = 0;
  REQUIRE(::read(begun[0], &byte, 1) == 1);
  ::close(begun[0]);
  std::this_thread::sleep_for(time);
  ::kill(child, SIGKILL);
  int status = 0;
  REQUIRE(::waitpid(child, &status, 0) == child);
  REQUIRE(WIFSIGNALED(status));
}

/// Between the kills of 200 rounds: so long that the last come far behind one change, however slow
/// this computer is.
template <typename Change>
std::chrono::microseconds between_kills(const Change& change) {
  const auto begin = std::chrono::steady_clock::now();
  change();
  const auto took = std::chrono::steady_clock::now() - begin;
  return std::max(50us, std::chrono::duration_cast<std::chrono::microseconds>(took) / 20);
}

}  // namespace

TEST_CASE("what is loaded and saved again is the same, comments, layout and all") {
  const ScratchFolder folder;
  const std::string text = "// pick\n\n  MOVE( 40,40 , 0)   // there\n\tSTOP\n";
  write(folder.file("a.rob"), text);
  PipedPrompt prompt(folder);
  prompt.enter({":load " + folder.file("a.rob"), ":save " + folder.file("b with blanks.rob")});
  CHECK(prompt.session.worst() == ExitCode::Done);
  CHECK(content(folder.file("b with blanks.rob")) == text);
  prompt.enter({":edit 3   MOVE(1,2,3)", ":save"});
  CHECK(content(folder.file("b with blanks.rob")) == "// pick\n\n  MOVE(1,2,3)\n\tSTOP\n");
  CHECK(content(folder.file("a.rob")) == text);
}

TEST_CASE("a file that was not loaded here is overwritten by :save! alone") {
  const ScratchFolder folder;
  const std::string file = folder.file("a.rob");
  write(file, "STOP\n");
  PipedPrompt prompt(folder);
  prompt.enter({":insert 1 PRINT 1", ":save " + file});
  CHECK(prompt.said().ends_with("error: '" + file + "' is there already; :save! " + file +
                                " replaces it, its content goes into the archive\n"));
  CHECK(content(file) == "STOP\n");
  prompt.enter({":save! " + file});
  CHECK(content(file) == "PRINT 1\n");
  write(file, "PRINT 2\n");
  prompt.said();
  prompt.enter({":save"});
  CHECK(prompt.said().find("has been changed by another program") != std::string::npos);
  CHECK(content(file) == "PRINT 2\n");
}

TEST_CASE("each save keeps the version before; it can be compared and restored") {
  const ScratchFolder folder;
  const std::string file = folder.file("a.rob");
  PipedPrompt prompt(folder);
  prompt.enter({":insert 1 PRINT 1", ":insert 2 STOP", ":save " + file});
  CHECK(prompt.enter({":archive"}).empty());
  prompt.enter({":edit 1 PRINT 2", ":save", ":insert 3 PRINT 3", ":save", ":save"});
  const std::string list = prompt.enter({":archive"});
  CHECK(list.find("   1  20") == 0);
  CHECK(list.find(" UTC  2 lines\n   2  20") != std::string::npos);
  CHECK(prompt.enter({":compare 1"}) == "- PRINT 1\n+ PRINT 2\n  STOP\n+ PRINT 3\n");
  prompt.enter({":restore 1"});
  CHECK(prompt.enter({":list"}) == "   1  PRINT 1\n   2  STOP\n");
  CHECK(prompt.enter({":undo", ":list 3"}) == "   3  PRINT 3\n");
  prompt.said();
  prompt.enter({":restore 9"});
  CHECK(prompt.said().find("there is no version 9") != std::string::npos);
}

TEST_CASE("a file or its points that cannot be read leave everything as it was") {
  const ScratchFolder folder;
  write(folder.file("a.rob"), "STOP\n");
  write(folder.file("a.points"), "nonsense\n");
  PipedPrompt prompt(folder);
  prompt.enter({":insert 1 PRINT 1", ":load " + folder.file("none.rob"), ":load /dev/zero",
                ":load " + folder.file("a.rob")});
  CHECK(prompt.session.worst() == ExitCode::InputOutput);
  CHECK(prompt.enter({":list"}) == "   1  PRINT 1\n");
  CHECK(prompt.session.workshop().file.name().empty());
  CHECK(prompt.session.points_file() == folder.file("prompt.gantry.points"));
}

TEST_CASE("kill -9 in the middle of saving leaves the old file or the new one, whole") {
  const ScratchFolder folder;
  const std::string file = folder.file("a.rob");
  std::string texts[2];
  for (int i = 0; i < 2'000; ++i) {
    texts[0] += "MOVE(1,2,3) // old\n";
    texts[1] += "PRINT 1     // new\n";
  }
  write(file, texts[0]);
  const auto step = between_kills([&] {
    ProgramFile own(folder.file("archive"));
    own.save(file, texts[0], true);
  });
  int saves = 0;
  for (int round = 0; round < 200; round += rob::test::kEach) {
    kill_after(step * round, [&] {
      ProgramFile own(folder.file("archive"));
      for (int i = 0;; ++i) own.save(file, texts[(i + round) % 2], true);
    });
    const std::string left = content(file);
    CHECK((left == texts[0] || left == texts[1]));
    saves += left == texts[1] ? 1 : 0;
    std::filesystem::remove_all(folder.file("archive"));
  }
  CHECK(saves > 0);  // it was not always too early
  CHECK(saves < 200 / rob::test::kEach);
  ProgramFile own(folder.file("archive"));
  own.save(file, "STOP\n", true);  // what the kills have left behind is in nobody's way
  CHECK(content(file) == "STOP\n");
  CHECK(!std::filesystem::exists(folder.file(".a.rob.saving")));
}

TEST_CASE("kill -9 in the middle of a change of a point leaves all points, before it or behind") {
  const ScratchFolder folder;
  const std::string file = folder.file("a.points");
  const auto robot = load_robot("gantry");
  std::string text = "ROBOT \"gantry\"\n";
  for (int i = 0; i < 200; ++i)
    text += fmt::format("p{} = POSE(40mm, {}mm, 0mm, 0deg, 0deg, 0deg) IN world TAUGHT \"now\"\n",
                        i, i);
  write(file, text);
  const auto step = between_kills([&] {
    PointsFile points(file, robot);
    points.rename("p7", "seven");
    points.rename("seven", "p7");
  });
  int renamed = 0;
  for (int round = 0; round < 200; round += rob::test::kEach) {
    kill_after(step * round, [&] {
      for (PointsFile points(file, robot);;) {
        if (!points.rename("p7", "seven")) points.rename("seven", "p7");
      }
    });
    const auto table = load_points(file, robot).table();
    CHECK(table.points.size() == 200);
    const auto has = [&](const char* name) {
      return std::ranges::count(table.points, name, &rob::lang::PointTable::Point::name);
    };
    CHECK(has("p7") + has("seven") == 1);
    renamed += has("seven") == 1 ? 1 : 0;
  }
  CHECK(renamed > 0);
  CHECK(renamed < 200 / rob::test::kEach);
}
