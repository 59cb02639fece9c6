#include "runtime/files/data_folder.h"

#include <fcntl.h>
#include <linux/openat2.h>
#include <sys/stat.h>
#include <sys/syscall.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <climits>
#include <cstring>
#include <filesystem>
#include <utility>

#include <fmt/format.h>

#include "lang/text/ascii.h"
#include "lang/text/codes.h"
#include "lang/values/file_name.h"

namespace rob::runtime {

namespace {

constexpr unsigned kNewDataFile = S_IRUSR | S_IWUSR | S_IRGRP | S_IROTH;

/// Below the folder, whatever links say.
int open_beneath(int folder, const std::string& name, int flags) {
  open_how how{};
  // Nothing waits for a file that is not regular.
  how.flags = static_cast<unsigned>(flags | O_CLOEXEC | ((flags & O_PATH) != 0 ? 0 : O_NONBLOCK));
  if ((flags & O_CREAT) != 0) how.mode = kNewDataFile;
  how.resolve = RESOLVE_BENEATH | RESOLVE_NO_MAGICLINKS;
  return static_cast<int>(::syscall(SYS_openat2, folder, name.c_str(), &how, sizeof how));
}

Words refused_file(const std::string& name, std::string_view why) {
  return {std::string(lang::code::kFileRefused),
          fmt::format("'{}' cannot be used: {}", lang::shortened(name), why),
          "a program has the files of its own folder, or of the one after --data"};
}

Words failed_file(const std::string& name, std::string_view doing, int error) {
  const char* const remedy = error == ENOENT   ? "check the name and the folder"
                             : error == EACCES ? "check the permissions"
                             : error == ENOSYS ? "the system is too old: it has no openat2"
                                               : "";
  return {std::string(lang::code::kFileFailed),
          fmt::format("cannot {} '{}': {}", doing, lang::shortened(name), std::strerror(error)),
          remedy};
}

/// The message of an open that has failed with this error.
Words words_of(const std::string& name, std::string_view doing, int error) {
  if (error == EXDEV || error == ELOOP || error == EEXIST)
    return refused_file(name, "it leads out of the program's folder");
  if (error == EISDIR || error == ENXIO) return refused_file(name, "it is no regular file");
  return failed_file(name, doing, error);
}

/// The name of an open file where all links are followed; the name of a file that is gone.
std::string true_name(int fd, const std::string& name) {
  std::array<char, PATH_MAX> path{};
  const std::string link = fmt::format("/proc/self/fd/{}", fd);
  const ssize_t length = ::readlink(link.c_str(), path.data(), path.size());
  if (length <= 0) return name;
  return std::filesystem::path(std::string(path.data(), static_cast<std::size_t>(length)))
      .filename();
}

/// Empty if it may be used.
std::string objection_to_open(int fd, const std::string& name) {
  struct stat status {};
  if (::fstat(fd, &status) != 0 || !S_ISREG(status.st_mode)) return "it is no regular file";
  return lang::objection_to_file(true_name(fd, name));
}

}  // namespace

DataFolder::DataFolder(const std::string& path)
    : folder_(::open(path.empty() ? "." : path.c_str(), O_PATH | O_DIRECTORY | O_CLOEXEC)) {}

DataFolder::~DataFolder() {
  if (folder_ >= 0) ::close(folder_);
}

DataFolder::Opened DataFolder::open(const std::string& name, int flags) const {
  if (const std::string objection = lang::objection_to_file(name); !objection.empty())
    return {-1, 0, refused_file(name, objection)};
  const int fd = open_beneath(folder_, name, flags);
  if (fd < 0) {
    const int error = errno;
    const bool reads = (flags & O_ACCMODE) == O_RDONLY;
    return {-1, error, words_of(name, reads ? "read" : "write", error)};
  }
  if (const std::string objection = objection_to_open(fd, name); !objection.empty()) {
    ::close(fd);
    return {-1, 0, refused_file(name, objection)};
  }
  return {fd, 0, {}};
}

bool DataFolder::exists(const std::string& name) const {
  const Opened file = open(name, O_RDONLY);
  if (file.fd >= 0) ::close(file.fd);
  return file.fd >= 0;
}

/// A new file's folder must be there, and below.
std::optional<Words> DataFolder::objection(const std::string& name) const {
  const Opened file = open(name, O_WRONLY | O_APPEND);
  if (file.fd >= 0) ::close(file.fd);
  if (file.fd >= 0) return std::nullopt;
  if (file.error != ENOENT) return file.why;
  if (const int link = open_beneath(folder_, name, O_PATH | O_NOFOLLOW); link >= 0) {
    ::close(link);
    return refused_file(name, "it is a link that leads nowhere");
  }
  const std::size_t slash = name.rfind('/');
  const std::string parent = slash == std::string::npos ? "." : name.substr(0, slash);
  const int fd = open_beneath(folder_, parent, O_PATH | O_DIRECTORY);
  if (fd < 0) return words_of(name, "write", errno);
  ::close(fd);
  return std::nullopt;
}

/// One that is not there is made, but never through a link.
int DataFolder::append_to(const std::string& name, std::optional<Words>& why) const {
  constexpr int kAppend = O_WRONLY | O_APPEND;
  Opened file = open(name, kAppend);
  if (file.error == ENOENT) file = open(name, kAppend | O_CREAT | O_EXCL);
  if (file.fd < 0) why = std::move(file.why);
  return file.fd;
}

std::optional<std::string> DataFolder::read(const std::string& name,
                                            std::optional<Words>& why) const {
  Opened file = open(name, O_RDONLY);
  const int fd = file.fd;
  if (fd < 0) why = std::move(file.why);
  if (fd < 0) return std::nullopt;
  std::string text;
  std::array<char, 65536> piece{};
  for (;;) {
    const ssize_t count = ::read(fd, piece.data(), piece.size());
    if (count < 0 && errno == EINTR) continue;
    if (count < 0) why = failed_file(name, "read", errno);
    if (count <= 0) break;
    text.append(piece.data(), static_cast<std::size_t>(count));
    if (text.size() <= kMostRead) continue;
    why = refused_file(name, "it is larger than 64 MiB");
    break;
  }
  ::close(fd);
  return why ? std::nullopt : std::optional(std::move(text));
}

}  // namespace rob::runtime
