#include "runtime/files/data_files.h"

#include <doctest/doctest.h>
#include <sys/stat.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>

#include "tests/support/scratch_folder.h"

using rob::runtime::DataFiles;
using rob::test::ScratchFolder;

namespace {

std::string text_in(const std::string& file) {
  std::ostringstream text;
  text << std::ifstream(file).rdbuf();
  return text.str();
}

/// The code that a file is refused with; empty where it is not.
std::string refused(DataFiles& files, const std::string& name) {
  const auto why = files.admit(name);
  return why ? why->code : "";
}

/// A folder in a folder, with all kinds of things in it.
struct Things {
  ScratchFolder outer;
  std::string inside = outer.file("inside");

  Things() {
    std::filesystem::create_directories(inside + "/below");
    std::ofstream(outer.file("secret")) << "secret\n";
    std::ofstream(inside + "/cell.rob") << "STOP\n";
    std::ofstream(inside + "/there.csv") << "old\n";
    std::filesystem::create_symlink("../secret", inside + "/out.csv");
    std::filesystem::create_symlink(outer.file("secret"), inside + "/absolute.csv");
    std::filesystem::create_symlink("cell.rob", inside + "/program.csv");
    std::filesystem::create_symlink("nowhere", inside + "/nowhere.csv");
    std::filesystem::create_symlink("..", inside + "/up");
    std::filesystem::create_symlink("there.csv", inside + "/link.csv");
    REQUIRE(::mkfifo((inside + "/pipe.csv").c_str(), 0600) == 0);
  }
};

}  // namespace

TEST_CASE("a program has the files of its folder, and none that a link leads to elsewhere") {
  const Things things;
  DataFiles files(things.inside, DataFiles::Keeps::OnDisk, true);
  for (const char* const name : {"../secret", "/etc/passwd", "out.csv", "absolute.csv", "up/secret",
                                 "program.csv", "nowhere.csv", "pipe.csv", "below", "cell.rob",
                                 "a.points", "b.VALUES", "c.toml", "", "below/"}) {
    CAPTURE(name);
    CHECK(refused(files, name) == "E358");
    CHECK_FALSE(files.exists(name));
    std::optional<rob::runtime::Words> why;
    CHECK_FALSE(files.read(name, why));
    CHECK(why);
  }
  for (const char* const name : {"new.csv", "below/new.csv", "there.csv", "link.csv"}) {
    CAPTURE(name);
    CHECK(refused(files, name).empty());
  }
  CHECK(refused(files, "no/new.csv") == "E359");
  CHECK_FALSE(files.exists("new.csv"));
  CHECK(files.exists("link.csv"));
  CHECK(text_in(things.outer.file("secret")) == "secret\n");
}

TEST_CASE("lines are appended in their order, and are there when the files are finished") {
  const Things things;
  {
    DataFiles files(things.inside, DataFiles::Keeps::OnDisk, true);
    REQUIRE(refused(files, "link.csv").empty());
    for (int i = 0; i < 1000; ++i) files.append("link.csv", std::to_string(i));
    files.append("below/a.csv", "x");
    std::optional<rob::runtime::Words> why;
    CHECK(files.read("below/a.csv", why) == "x\n");
    CHECK(files.exists("below/a.csv"));
  }
  std::string expected = "old\n";
  for (int i = 0; i < 1000; ++i) expected += std::to_string(i) + "\n";
  CHECK(text_in(things.inside + "/there.csv") == expected);
}

TEST_CASE("in memory nothing is written, and what was written is read behind the file") {
  const Things things;
  DataFiles files(things.inside, DataFiles::Keeps::InMemory, true);
  files.append("there.csv", "new");
  files.append("fresh.csv", "x");
  std::optional<rob::runtime::Words> why;
  CHECK(files.read("there.csv", why) == "old\nnew\n");
  CHECK(files.read("fresh.csv", why) == "x\n");
  CHECK(files.exists("fresh.csv"));
  CHECK(text_in(things.inside + "/there.csv") == "old\n");
  CHECK_FALSE(std::filesystem::exists(things.inside + "/fresh.csv"));
}

TEST_CASE("what cannot be written is told once, at the next WRITE or at the end") {
  const Things things;
  DataFiles files(things.inside, DataFiles::Keeps::OnDisk, true);
  REQUIRE(refused(files, "below/a.csv").empty());
  std::filesystem::remove(things.inside + "/below");
  files.append("below/a.csv", "x");
  std::optional<rob::runtime::Words> why;
  files.read("there.csv", why);  // waits for the lines before
  CHECK(refused(files, "there.csv") == "E359");
  CHECK(refused(files, "there.csv").empty());
  files.append("below/a.csv", "y");
  const auto failure = files.finish();
  REQUIRE(failure);
  CHECK(failure->code == "E359");
}

TEST_CASE("a program writes 16 files at most") {
  const ScratchFolder folder;
  DataFiles files(folder.file(""), DataFiles::Keeps::OnDisk, true);
  for (int i = 0; i < 16; ++i) CHECK(refused(files, std::to_string(i)).empty());
  CHECK(refused(files, "16") == "E358");
  CHECK(refused(files, "3").empty());
}

TEST_CASE("in real time the report must have looked twice before lines count as handed over") {
  const ScratchFolder folder;
  DataFiles files(folder.file(""), DataFiles::Keeps::OnDisk, false);
  CHECK(files.reported());  // nothing was written
  REQUIRE(refused(files, "a").empty());
  CHECK_FALSE(files.reported());
  files.drained();
  CHECK_FALSE(files.reported());
  files.drained();
  CHECK(files.reported());
  CHECK_FALSE(files.reported());
}
