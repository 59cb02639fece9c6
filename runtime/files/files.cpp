#include "runtime/files/files.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/stat.h>
#include <sys/sysmacros.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <cstring>

namespace rob::runtime {

namespace {

/// A file descriptor that is closed when it goes out of scope.
class Descriptor {
 public:
  explicit Descriptor(int fd) : fd_(fd) {}
  ~Descriptor() {
    if (fd_ >= 0) ::close(fd_);
  }
  Descriptor(const Descriptor&) = delete;
  Descriptor& operator=(const Descriptor&) = delete;

  int get() const { return fd_; }
  int release() {
    const int fd = fd_;
    fd_ = -1;
    return fd;
  }

 private:
  int fd_;
};

[[noreturn]] void fail(const std::string& path, const char* doing) {
  const int error = errno;
  const char* remedy = error == ENOENT   ? "; check the name and the folder"
                       : error == EACCES ? "; check the permissions"
                                         : "";
  throw FileError(fmt::format("cannot {} '{}': {}{}", doing, path, std::strerror(error), remedy));
}

const char* kind_of(mode_t mode) {
  if (S_ISDIR(mode)) return "a folder";
  if (S_ISFIFO(mode)) return "a pipe";
  if (S_ISSOCK(mode)) return "a socket";
  return "a device";
}

/// /dev/null and /dev/full: the two devices that are of use as a log, the second to try out a
/// full disk.
bool harmless_sink(const struct stat& status) {
  constexpr unsigned kMemoryDevices = 1;
  constexpr unsigned kNull = 3;
  constexpr unsigned kFull = 7;
  return S_ISCHR(status.st_mode) && major(status.st_rdev) == kMemoryDevices &&
         (minor(status.st_rdev) == kNull || minor(status.st_rdev) == kFull);
}

std::string read_all(const Descriptor& file, const std::string& path, std::size_t size) {
  std::string text(size, '\0');
  std::size_t done = 0;
  while (done < size) {
    const ssize_t n = ::read(file.get(), text.data() + done, size - done);
    if (n < 0 && errno == EINTR) continue;
    if (n < 0) fail(path, "read");
    if (n == 0) break;
    done += static_cast<std::size_t>(n);
  }
  text.resize(done);
  return text;
}

}  // namespace

std::string read_file(const std::string& path, std::size_t most) {
  const Descriptor file(::open(path.c_str(), O_RDONLY | O_NONBLOCK | O_CLOEXEC));
  if (file.get() < 0) fail(path, "read");
  struct stat status {};
  if (::fstat(file.get(), &status) != 0) fail(path, "read");
  if (!S_ISREG(status.st_mode)) {
    throw FileError(
        fmt::format("cannot read '{}': it is {}; name a file", path, kind_of(status.st_mode)));
  }
  const auto size = static_cast<std::size_t>(status.st_size);
  if (size > most) {
    throw FileError(fmt::format("cannot read '{}': {} MiB; at most {} MiB are read", path,
                                size >> 20U, most >> 20U));
  }
  return read_all(file, path, size);
}

std::string read_input(std::size_t most) {
  std::string text;
  std::array<char, 65536> bytes;
  for (;;) {
    const ssize_t count = ::read(STDIN_FILENO, bytes.data(), bytes.size());
    if (count < 0 && errno == EINTR) continue;
    if (count < 0)
      throw FileError(fmt::format("standard input cannot be read: {}", std::strerror(errno)));
    if (count == 0) return text;
    text.append(bytes.data(), static_cast<std::size_t>(count));
    if (text.size() > most)
      throw FileError(
          fmt::format("standard input is too long: at most {} MiB are read", most >> 20U));
  }
}

FileHandle open_log(const std::string& path) {
  Descriptor file(::open(path.c_str(), O_WRONLY | O_CREAT | O_NONBLOCK | O_CLOEXEC,
                         S_IRUSR | S_IWUSR | S_IRGRP | S_IROTH));
  if (file.get() < 0 && errno == ENXIO) {  // a pipe that nobody reads
    throw FileError(fmt::format("cannot write '{}': it is a pipe; name a file", path));
  }
  if (file.get() < 0) fail(path, "write");
  struct stat status {};
  if (::fstat(file.get(), &status) != 0) fail(path, "write");
  if (!S_ISREG(status.st_mode) && !harmless_sink(status)) {
    throw FileError(
        fmt::format("cannot write '{}': it is {}; name a file", path, kind_of(status.st_mode)));
  }
  if (S_ISREG(status.st_mode) && ::ftruncate(file.get(), 0) != 0) fail(path, "write");
  std::FILE* stream = ::fdopen(file.get(), "w");
  if (stream == nullptr) fail(path, "write");
  file.release();
  return FileHandle(stream);
}

}  // namespace rob::runtime
