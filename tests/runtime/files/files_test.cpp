#include <doctest/doctest.h>
#include <sys/stat.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <string>

#include "runtime/files/files.h"
#include "tests/support/file_error.h"
#include "tests/support/scratch_folder.h"

namespace fs = std::filesystem;
using rob::runtime::FileError;
using rob::runtime::open_log;
using rob::runtime::read_file;
using rob::test::message_of;
using rob::test::ScratchFolder;

TEST_CASE("a file is read whole, bytes as they are") {
  const ScratchFolder scratch;
  const std::string text("MOVE(1,2,3)\r\n\0\xff end", 19);
  std::ofstream(scratch.file("a.rob"), std::ios::binary) << text;
  CHECK(read_file(scratch.file("a.rob"), 100) == text);
  std::ofstream(scratch.file("empty.rob"));
  CHECK(read_file(scratch.file("empty.rob"), 100).empty());
}

TEST_CASE("fault 41: a folder, a pipe, a device or a missing file is refused at once, by name") {
  const ScratchFolder scratch;
  mkfifo(scratch.file("pipe").c_str(), 0600);
  CHECK(message_of([&] { read_file(scratch.path().string(), 100); }) ==
        "cannot read '" + scratch.path().string() + "': it is a folder; name a file");
  CHECK(message_of([&] { read_file(scratch.file("pipe"), 100); }) ==
        "cannot read '" + scratch.file("pipe") + "': it is a pipe; name a file");
  CHECK(message_of([&] { read_file("/dev/zero", 100); }) ==
        "cannot read '/dev/zero': it is a device; name a file");
  CHECK(message_of([&] { read_file(scratch.file("none"), 100); }) ==
        "cannot read '" + scratch.file("none") +
            "': No such file or directory; check the name and the folder");
}

TEST_CASE("fault 4: a file beyond the stated limit is refused without being read") {
  const ScratchFolder scratch;
  std::ofstream(scratch.file("long.rob")) << "STOP";
  fs::resize_file(scratch.file("long.rob"), std::uintmax_t{100} << 20U);  // sparse
  CHECK(message_of([&] { read_file(scratch.file("long.rob"), std::size_t{32} << 20U); }) ==
        "cannot read '" + scratch.file("long.rob") + "': 100 MiB; at most 32 MiB are read");
}

TEST_CASE("fault 41: a log is a regular file; what cannot be one is refused at once") {
  const ScratchFolder scratch;
  mkfifo(scratch.file("pipe").c_str(), 0600);
  CHECK(message_of([&] { open_log(scratch.file("pipe")); }).find("it is a pipe") !=
        std::string::npos);
  CHECK(message_of([&] { open_log(scratch.path().string()); }).find("Is a directory") !=
        std::string::npos);
  CHECK(message_of([&] { open_log("/dev/zero"); }).find("it is a device") != std::string::npos);
  CHECK(message_of([&] {
          open_log(scratch.file("no/such/folder"));
        }).find("check the name and the folder") != std::string::npos);
  CHECK(message_of([&] { open_log("/dev/full"); }) == "no error");
}

TEST_CASE("a log starts empty whatever the file held") {
  const ScratchFolder scratch;
  std::ofstream(scratch.file("t.csv")) << "old";
  std::fputs("new", open_log(scratch.file("t.csv")).get());
  CHECK(read_file(scratch.file("t.csv"), 100) == "new");
}
