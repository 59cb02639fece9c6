#include "runtime/files/run_mark.h"

#include <fcntl.h>
#include <fmt/chrono.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <ctime>
#include <filesystem>
#include <system_error>

#include "lang/text/visible.h"
#include "runtime/files/files.h"
#include "runtime/files/state_folder.h"

namespace rob::runtime {
namespace {

namespace fs = std::filesystem;

constexpr std::string_view kMark = "run-";
constexpr std::size_t kLongestMark = 4096;  // [choice] of a line

FileError not_marked(const fs::path& file, int error) {
  return FileError(fmt::format(
      "cannot write '{}': {}; should this run be killed, the next start will not say so",
      file.string(), std::strerror(error)));
}

/// The line of a mark that nobody holds, which is removed; empty of one that lives, or has just
/// been removed by another.
std::string take(const fs::path& file) {
  const int mark = ::open(file.c_str(), O_RDONLY | O_CLOEXEC | O_NONBLOCK);
  if (mark < 0) return "";
  std::string line(kLongestMark, '\0');
  struct stat status {};
  ssize_t length = 0;
  if (::flock(mark, LOCK_EX | LOCK_NB) == 0 && ::fstat(mark, &status) == 0 &&
      S_ISREG(status.st_mode) && status.st_nlink > 0) {
    length = ::read(mark, line.data(), line.size());
    ::unlink(file.c_str());
  }
  ::close(mark);
  line.resize(length > 0 ? static_cast<std::size_t>(length) : 0);
  return line;
}

}  // namespace

/// It gets its name when it is locked: never is there one of a living run without lock.
RunMark::RunMark(const std::string& what, const std::string& robot) {
  const fs::path in = state_folder();
  if (in.empty()) return;
  std::error_code error;
  fs::create_directories(in, error);
  const fs::path hidden = in / fmt::format(".{}{}", kMark, ::getpid());
  const fs::path file = in / fmt::format("{}{}", kMark, ::getpid());
  lock_ = ::open(hidden.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, 0600);
  if (lock_ < 0) throw not_marked(file, errno);
  const std::string line = fmt::format("{} on {} (process {}, begun {:%Y-%m-%d %H:%M:%S} UTC)",
                                       what, robot, ::getpid(), fmt::gmtime(std::time(nullptr)))
                               .substr(0, kLongestMark);
  const bool written =
      ::flock(lock_, LOCK_EX | LOCK_NB) == 0 &&
      ::write(lock_, line.data(), line.size()) == static_cast<ssize_t>(line.size()) &&
      ::rename(hidden.c_str(), file.c_str()) == 0;
  if (!written) {
    const int reason = errno;
    ::unlink(hidden.c_str());
    ::close(lock_);
    throw not_marked(file, reason);
  }
  file_ = file.string();
}

RunMark::~RunMark() {
  if (lock_ < 0) return;
  ::unlink(file_.c_str());
  ::close(lock_);
}

std::vector<std::string> unclean_ends() {
  std::vector<std::string> runs;
  std::error_code error;
  for (const fs::directory_entry& entry : fs::directory_iterator(state_folder(), error)) {
    if (!entry.path().filename().string().starts_with(kMark)) continue;
    if (const std::string run = take(entry.path()); !run.empty())
      runs.push_back(
          fmt::format("rob: unclean end: the run of {} was cut off, by kill -9, a crash or"
                      " the loss of power; look where the robot stands\n",
                      lang::on_one_line(run)));
  }
  return runs;
}

}  // namespace rob::runtime
