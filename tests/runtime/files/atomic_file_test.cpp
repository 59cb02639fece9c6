#include "runtime/files/atomic_file.h"

#include <doctest/doctest.h>
#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

#include "runtime/files/files.h"
#include "tests/support/file_error.h"
#include "tests/support/scratch_folder.h"
#include "tests/support/without_privileges.h"

namespace fs = std::filesystem;
using rob::runtime::FileCalls;
using rob::runtime::FileError;
using rob::runtime::read_file;
using rob::runtime::save_file;
using rob::test::message_of;
using rob::test::ScratchFolder;
using rob::test::true_without_privileges;

namespace {

/// A folder with one file in it, which is to be saved.
struct Scratch {
  ScratchFolder folder;
  fs::path path = folder.path();
  Scratch() { std::ofstream(file()) << "old"; }
  std::string file() const { return folder.file("a.rob"); }
  std::string temporary() const { return (path / ".a.rob.saving").string(); }
  std::string content() const { return read_file(file(), 1000); }
  /// Only the file itself is there.
  bool tidy() const {
    return std::distance(fs::directory_iterator(path), fs::directory_iterator()) == 1;
  }
};

enum class Call { None, Open, Lock, Permit, Write, Sync, Rename };

/// Lets one call fail, or the whole process die there.
class FaultyCalls : public FileCalls {
 public:
  FaultyCalls(Call at, int error) : at_(at), error_(error) {}

  int open(const char* path, int flags, unsigned mode) override {
    return fails(Call::Open) ? -1 : FileCalls::open(path, flags, mode);
  }
  int lock(int fd) override { return fails(Call::Lock) ? -1 : FileCalls::lock(fd); }
  int permit(int fd, unsigned mode) override {
    return fails(Call::Permit) ? -1 : FileCalls::permit(fd, mode);
  }
  /// Two bytes at a time, so that there is something half written.
  long write(int fd, const char* data, std::size_t size) override {
    if (written_ && fails(Call::Write)) return -1;
    written_ = true;
    return FileCalls::write(fd, data, std::min<std::size_t>(size, 2));
  }
  int sync(int fd) override { return fails(Call::Sync) ? -1 : FileCalls::sync(fd); }
  int rename(const char* from, const char* to) override {
    return fails(Call::Rename) ? -1 : FileCalls::rename(from, to);
  }

  static constexpr int kDies = -1;

 private:
  bool fails(Call call) const {
    if (call != at_) return false;
    if (error_ == kDies) _exit(0);
    errno = error_;
    return true;
  }

  Call at_;
  int error_;
  bool written_ = false;
};

/// Notes the names of the files that are brought to the disk, and when the file gets its name.
class SyncedNames : public FileCalls {
 public:
  int sync(int fd) override {
    steps.push_back(fs::read_symlink("/proc/self/fd/" + std::to_string(fd)).string());
    return FileCalls::sync(fd);
  }
  int rename(const char* from, const char* to) override {
    steps.emplace_back("rename");
    return FileCalls::rename(from, to);
  }

  std::vector<std::string> steps;
};

/// Counts how often an owner is given.
class OwnCalls : public FileCalls {
 public:
  int own(int fd, unsigned user, unsigned group) override {
    ++count;
    return FileCalls::own(fd, user, group);
  }

  int count = 0;
};

/// Tries to save the file; whether the message advises to check the permissions.
bool names_permissions(const std::string& file) {
  return message_of([&] { save_file(file, "new"); }).find("check the permissions") !=
         std::string::npos;
}

constexpr Call kAll[] = {Call::Open,  Call::Lock, Call::Permit,
                         Call::Write, Call::Sync, Call::Rename};

}  // namespace

TEST_CASE("a file is replaced; its permissions stay") {
  const Scratch scratch;
  fs::permissions(scratch.file(), fs::perms(0640));
  save_file(scratch.file(), "new text");
  CHECK(scratch.content() == "new text");
  CHECK(fs::status(scratch.file()).permissions() == fs::perms(0640));
  CHECK(scratch.tidy());
  save_file(scratch.file(), "");
  CHECK(scratch.content().empty());
}

TEST_CASE("another owner stays; one's own is not asked for, since not everybody may give any") {
  const Scratch scratch;
  OwnCalls calls;
  save_file(scratch.file(), "new text", calls);
  CHECK(calls.count == 0);
  if (::geteuid() != 0) return;  // nobody else may give a file away
  REQUIRE(::chown(scratch.file().c_str(), 1, 2) == 0);
  save_file(scratch.file(), "newer text", calls);
  CHECK(calls.count == 1);
  struct stat status {};
  REQUIRE(::stat(scratch.file().c_str(), &status) == 0);
  CHECK(status.st_uid == 1);
  CHECK(status.st_gid == 2);
}

TEST_CASE("a file that is not there is made") {
  const Scratch scratch;
  fs::remove(scratch.file());
  save_file(scratch.file(), "new");
  CHECK(scratch.content() == "new");
}

TEST_CASE("a symbolic link stays one, and leads to the new text") {
  const Scratch scratch;
  const fs::path link = scratch.path / "link.rob";
  fs::create_symlink("a.rob", link);
  save_file(link.string(), "new");
  CHECK(fs::is_symlink(link));
  CHECK(scratch.content() == "new");
}

TEST_CASE("faults 39, 41: whichever call fails, the old file is intact and nothing else is left") {
  for (const Call call : kAll) {
    for (const int error : {ENOSPC, EIO, EACCES}) {
      const Scratch scratch;
      FaultyCalls calls(call, error);
      CHECK_THROWS_AS(save_file(scratch.file(), "new text", calls), FileError);
      CHECK(scratch.content() == "old");
      CHECK(scratch.tidy());
    }
  }
}

TEST_CASE("fault 39: a full disk is told with the file and the space that is left") {
  const Scratch scratch;
  FaultyCalls calls(Call::Write, ENOSPC);
  const std::string message = message_of([&] { save_file(scratch.file(), "new text", calls); });
  CHECK(message.starts_with("cannot save '" + scratch.file() + "': No space left on device ("));
  CHECK(message.ends_with(" kB free)"));
}

TEST_CASE("fault 41: a folder, a pipe and a device are refused at once") {
  const Scratch scratch;
  const std::string pipe = (scratch.path / "pipe").string();
  mkfifo(pipe.c_str(), 0600);
  for (const std::string& path : {scratch.path.string(), pipe, std::string("/dev/zero")}) {
    CHECK(message_of([&] { save_file(path, "new"); }) ==
          "cannot save '" + path + "': it is no regular file; name a file");
  }
  CHECK(message_of([&] {
          save_file((scratch.path / "no" / "such").string(), "new");
        }).find("check the name and the folder") != std::string::npos);
}

TEST_CASE("fault 41: in a folder that may not be written the old file stays") {
  const Scratch scratch;
  fs::permissions(scratch.path, fs::perms(0500));
  CHECK(true_without_privileges([&] { return names_permissions(scratch.file()); }));
  fs::permissions(scratch.path, fs::perms(0700));
  CHECK(scratch.content() == "old");
  CHECK(scratch.tidy());
}

TEST_CASE("fault 41: a file that may not be written stays, though its folder may be written") {
  const Scratch scratch;
  fs::permissions(scratch.file(), fs::perms(0400));
  CHECK(true_without_privileges([&] { return names_permissions(scratch.file()); }));
  CHECK(scratch.content() == "old");
  CHECK(scratch.tidy());
  fs::permissions(scratch.file(), fs::perms(0600));
  CHECK(true_without_privileges([&] { return !names_permissions(scratch.file()); }));
  CHECK(scratch.content() == "new");
}

TEST_CASE("a save ends when the folder with the new name has reached the disk, too") {
  const Scratch scratch;
  SyncedNames calls;
  save_file(scratch.file(), "new", calls);
  // The text before it gets its name, the name afterwards.
  REQUIRE(calls.steps.size() == 3);
  CHECK(calls.steps[0] == (fs::canonical(scratch.path) / ".a.rob.saving").string());
  CHECK(calls.steps[1] == "rename");
  CHECK(calls.steps[2] == fs::canonical(scratch.path).string());
}

TEST_CASE("fault 42: a crash at any call leaves the old file, and the next save cleans up") {
  for (const Call call : kAll) {
    const Scratch scratch;
    const pid_t child = fork();
    if (child == 0) {
      FaultyCalls calls(call, FaultyCalls::kDies);
      save_file(scratch.file(), "half of it", calls);
      _exit(1);
    }
    int status = 0;
    waitpid(child, &status, 0);
    CHECK(WEXITSTATUS(status) == 0);
    CHECK(scratch.content() == "old");
    save_file(scratch.file(), "new");
    CHECK(scratch.content() == "new");
    CHECK(scratch.tidy());
  }
}

TEST_CASE("two programs that save the same file do not mix their texts") {
  const Scratch scratch;
  const int other = ::open(scratch.temporary().c_str(), O_RDWR | O_CREAT, 0600);
  flock(other, LOCK_EX);
  CHECK(message_of([&] { save_file(scratch.file(), "new"); }).find("another program") !=
        std::string::npos);
  CHECK(scratch.content() == "old");
  CHECK(fs::exists(scratch.temporary()));
  close(other);
}

TEST_CASE("nothing is written through a file that has the name of the temporary one") {
  const auto made_by = [](const Scratch& scratch, const std::string& how) {
    const fs::path other = scratch.path / "other";
    std::ofstream(other) << "theirs";
    if (how == "hard link") fs::create_hard_link(other, scratch.temporary());
    if (how == "symbolic link") fs::create_symlink(other, scratch.temporary());
    if (how == "dangling link") fs::create_symlink(scratch.path / "nowhere", scratch.temporary());
    if (how == "pipe") mkfifo(scratch.temporary().c_str(), 0600);
    return other;
  };
  for (const char* const how : {"hard link", "symbolic link", "dangling link", "pipe"}) {
    CAPTURE(how);
    const Scratch scratch;
    const fs::path other = made_by(scratch, how);
    save_file(scratch.file(), "new");
    CHECK(scratch.content() == "new");
    CHECK(read_file(other.string(), 1000) == "theirs");
    CHECK_FALSE(fs::exists(fs::symlink_status(scratch.temporary())));
    CHECK_FALSE(fs::exists(scratch.path / "nowhere"));
  }
  const Scratch scratch;
  fs::create_directory(scratch.temporary());
  CHECK(message_of([&] { save_file(scratch.file(), "new"); }).ends_with("is in the way"));
  CHECK(scratch.content() == "old");
}

TEST_CASE("whether a file can be saved is found out without changing anything") {
  const Scratch scratch;
  rob::runtime::try_saving(scratch.file());
  CHECK(scratch.content() == "old");
  CHECK(scratch.tidy());
  const std::string missing = (scratch.path / "no" / "such").string();
  CHECK(message_of([&] { rob::runtime::try_saving(missing); }).find("check the name") !=
        std::string::npos);
  fs::remove(scratch.file());
  rob::runtime::try_saving(scratch.file());
  CHECK_FALSE(fs::exists(scratch.file()));
}
