#include "runtime/files/atomic_file.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <sys/statvfs.h>
#include <unistd.h>

#include <cerrno>
#include <climits>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <optional>

#include "runtime/files/files.h"

namespace rob::runtime {

namespace {

using Status = struct stat;

std::string folder_of(const std::string& path) {
  const std::size_t slash = path.rfind('/');
  return slash == std::string::npos ? "." : path.substr(0, slash + 1);
}

/// Beside the file, so that the renaming stays on one disk; always the same, so that the next save
/// finds the file that a crash left.
std::string temporary_name(const std::string& path) {
  const std::size_t slash = path.rfind('/');
  const std::size_t name = slash == std::string::npos ? 0 : slash + 1;
  return path.substr(0, name) + "." + path.substr(name) + ".saving";
}

std::string remedy(int error, const std::string& path) {
  if (error == ENOSPC || error == EDQUOT) {
    struct statvfs disk {};
    if (::statvfs(folder_of(path).c_str(), &disk) != 0) return "";
    return fmt::format(" ({} kB free)", disk.f_bavail * disk.f_frsize / 1024);
  }
  if (error == ENOENT) return "; check the name and the folder";
  if (error == EACCES || error == EPERM || error == EROFS) return "; check the permissions";
  return "";
}

[[noreturn]] void fail(const std::string& path, int error) {
  throw FileError(
      fmt::format("cannot save '{}': {}{}", path, std::strerror(error), remedy(error, path)));
}

/// One save; what it has begun is taken back unless it came to its end.
class Save {
 public:
  Save(const std::string& path, FileCalls& calls) : shown_(path), calls_(calls) {
    char real[PATH_MAX];
    path_ = ::realpath(path.c_str(), real) != nullptr ? real : path;
    temporary_ = temporary_name(path_);
  }
  ~Save() {
    if (fd_ < 0) return;
    if (ours_) calls_.remove(temporary_.c_str());
    ::close(fd_);  // also unlocks it
  }
  Save(const Save&) = delete;
  Save& operator=(const Save&) = delete;

  void look_at_old() {
    Status status{};
    if (::stat(path_.c_str(), &status) != 0) {
      if (errno != ENOENT) fail(shown_, errno);
      return;
    }
    if (!S_ISREG(status.st_mode)) {
      throw FileError(fmt::format("cannot save '{}': it is no regular file; name a file", shown_));
    }
    if (::access(path_.c_str(), W_OK) != 0) fail(shown_, errno);
    old_ = status;
  }

  /// A new file, and never one that was there: nothing is written through a link of its name. Two
  /// programs that save the same file must not mix their texts: it belongs to who has locked it.
  void open_temporary() {
    constexpr unsigned kNewFile = S_IRUSR | S_IWUSR | S_IRGRP | S_IROTH;
    constexpr int kFlags = O_RDWR | O_CREAT | O_EXCL | O_CLOEXEC;
    constexpr int kMostLeftovers = 3;  // [choice] others may save the same file meanwhile
    for (int i = 0; fd_ < 0; ++i) {
      fd_ = calls_.open(temporary_.c_str(), kFlags, kNewFile);
      if (fd_ < 0 && (errno != EEXIST || i == kMostLeftovers)) fail(shown_, errno);
      if (fd_ < 0) remove_leftover();
    }
    ours_ = true;
    if (calls_.lock(fd_) == 0) return;
    ours_ = errno != EWOULDBLOCK;  // another program has taken it for a leftover, and removes it
    if (ours_) fail(shown_, errno);
    fail_for_another();
  }

  void write(std::string_view text) {
    if (old_) take_over_owner();
    while (!text.empty()) {
      const long n = calls_.write(fd_, text.data(), text.size());
      if (n < 0 && errno == EINTR) continue;
      check(n);
      text.remove_prefix(static_cast<std::size_t>(n));
    }
    check(calls_.sync(fd_));
  }

  void rename() {
    check(calls_.rename(temporary_.c_str(), path_.c_str()));
    ours_ = false;
    // The new name reaches the disk with the folder; the file is whole whether or not it does now.
    const int folder = ::open(folder_of(path_).c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
    if (folder < 0) return;
    calls_.sync(folder);
    ::close(folder);
  }

 private:
  /// Removes a file that a crash left, or that somebody else gave this name; its content stays
  /// where it has another name. A file that another program is writing stays: it is locked.
  void remove_leftover() {
    const int fd = ::open(temporary_.c_str(), O_RDONLY | O_NOFOLLOW | O_NONBLOCK | O_CLOEXEC);
    if (fd < 0 && errno == ENOENT) return;  // it has gone meanwhile
    const bool link = fd < 0 && errno == ELOOP;
    const bool busy = fd >= 0 && calls_.lock(fd) != 0 && errno == EWOULDBLOCK;
    const bool gone = fd >= 0 && !busy && !is_temporary(fd);
    const bool removed =
        !busy && (gone || ((link || fd >= 0) && calls_.remove(temporary_.c_str()) == 0));
    if (fd >= 0) ::close(fd);
    if (busy) fail_for_another();
    if (removed) return;
    throw FileError(fmt::format("cannot save '{}': '{}' is in the way", shown_, temporary_));
  }

  /// The temporary file's name still belongs to this open file.
  bool is_temporary(int fd) const {
    Status opened{};
    Status named{};
    return ::fstat(fd, &opened) == 0 && ::lstat(temporary_.c_str(), &named) == 0 &&
           named.st_dev == opened.st_dev && named.st_ino == opened.st_ino;
  }

  [[noreturn]] void fail_for_another() const {
    throw FileError(
        fmt::format("cannot save '{}': another program is just saving it; try again", shown_));
  }

  void take_over_owner() {
    Status status{};
    check(::fstat(fd_, &status));
    if (status.st_uid != old_->st_uid || status.st_gid != old_->st_gid) {
      check(calls_.own(fd_, old_->st_uid, old_->st_gid));
    }
    constexpr unsigned kPermissions = 07777;
    check(calls_.permit(fd_, old_->st_mode & kPermissions));
  }

  void check(long result) const {
    if (result < 0) fail(shown_, errno);
  }

  const std::string& shown_;  ///< as the user named it
  FileCalls& calls_;
  std::string path_;  ///< with symbolic links followed
  std::string temporary_;
  std::optional<Status> old_;
  int fd_ = -1;
  bool ours_ = false;  ///< the temporary file is there and is ours
};

}  // namespace

int FileCalls::open(const char* path, int flags, unsigned mode) {
  return ::open(path, flags, mode);
}
int FileCalls::lock(int fd) { return ::flock(fd, LOCK_EX | LOCK_NB); }
int FileCalls::own(int fd, unsigned user, unsigned group) { return ::fchown(fd, user, group); }
int FileCalls::permit(int fd, unsigned mode) { return ::fchmod(fd, mode); }
long FileCalls::write(int fd, const char* data, std::size_t size) {
  return ::write(fd, data, size);
}
int FileCalls::sync(int fd) { return ::fsync(fd); }
int FileCalls::rename(const char* from, const char* to) { return std::rename(from, to); }
int FileCalls::remove(const char* path) { return ::unlink(path); }

void save_file(const std::string& path, std::string_view text) {
  FileCalls calls;
  save_file(path, text, calls);
}

void save_file(const std::string& path, std::string_view text, FileCalls& calls) {
  Save save(path, calls);
  save.look_at_old();
  save.open_temporary();
  save.write(text);
  save.rename();
}

void try_saving(const std::string& path) {
  FileCalls calls;
  Save save(path, calls);
  save.look_at_old();
  save.open_temporary();
}

}  // namespace rob::runtime
