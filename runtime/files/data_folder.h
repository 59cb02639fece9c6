#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>

#include "runtime/words/words.h"

namespace rob::runtime {

/// The folder of the files that a program may read and write. No name leads out of it, also not
/// through a link; a link to another file in it is followed. Only regular files count, and none
/// that Rob keeps itself (objection_to_file).
class DataFolder {
 public:
  /// Empty: the current one. A folder that is not there has no files.
  explicit DataFolder(const std::string& path);
  ~DataFolder();
  DataFolder(const DataFolder&) = delete;
  DataFolder& operator=(const DataFolder&) = delete;

  /// The largest file that is read. [choice] a million lines
  static constexpr std::size_t kMostRead = std::size_t{64} << 20U;

  /// Whether such a file is there; false also for one that the program may not use.
  bool exists(const std::string& name) const;
  /// Why the program may not append to the file; it need not be there.
  std::optional<Words> objection(const std::string& name) const;
  /// Opens it for appending, and makes it where it is not there: a descriptor, or -1 and why.
  int append_to(const std::string& name, std::optional<Words>& why) const;
  /// All of it, or why it cannot be read.
  std::optional<std::string> read(const std::string& name, std::optional<Words>& why) const;

 private:
  struct Opened {
    int fd = -1;    ///< -1: it may not be used
    int error = 0;  ///< of the system
    Words why;
  };
  Opened open(const std::string& name, int flags) const;

  int folder_;
};

}  // namespace rob::runtime
