#pragma once

#include <string>
#include <string_view>

namespace rob::runtime {

/// The calls to the system that saving a file takes, so that tests can let each of them fail. They
/// return what the system returns, -1 with errno for a failure.
class FileCalls {
 public:
  virtual ~FileCalls() = default;

  virtual int open(const char* path, int flags, unsigned mode);
  virtual int lock(int fd);  ///< of the whole file, without waiting
  virtual int own(int fd, unsigned user, unsigned group);
  virtual int permit(int fd, unsigned mode);
  virtual long write(int fd, const char* data, std::size_t size);
  virtual int sync(int fd);
  virtual int rename(const char* from, const char* to);
  virtual int remove(const char* path);
};

/// Replaces the content of a regular file, or makes it, so that at every instant the file is either
/// the old or the new one, whole: a temporary file beside it is written, brought to the disk and
/// renamed. Owner and permissions stay; a symbolic link stays one. Throws FileError, with the old
/// file untouched, if the file is a folder, pipe or device, may not be written, is just being saved
/// by another program, or the disk is full. The next save removes what a crash left.
void save_file(const std::string& path, std::string_view text);
void save_file(const std::string& path, std::string_view text, FileCalls& calls);

/// Throws FileError where save_file() would: makes the temporary file and removes it again.
void try_saving(const std::string& path);

}  // namespace rob::runtime
