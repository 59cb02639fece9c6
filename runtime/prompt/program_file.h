#pragma once

#include <string>
#include <string_view>

#include "runtime/files/archive.h"

namespace rob::runtime {

/// The file of the program in memory. All throw FileError, and leave everything as it was then.
class ProgramFile {
 public:
  explicit ProgramFile(const std::string& archive) : archive_(archive) {}

  /// Empty as long as nothing was loaded or saved.
  const std::string& name() const { return name_; }
  const Archive& archive() const { return archive_; }

  /// Its text; it is the program's file from now on.
  std::string load(const std::string& file);
  /// `text` replaces what the file holds, which is kept in the archive; it is the program's file
  /// from now on. Without `replace` only what was loaded or saved here before, and has not been
  /// changed by others since, is overwritten.
  void save(const std::string& file, std::string_view text, bool replace);
  /// The next program has no file yet.
  void close();

 private:
  void refuse_overwriting(const std::string& file) const;

  Archive archive_;
  std::string name_;
  std::string content_;  ///< of the file, as it was loaded or saved
};

}  // namespace rob::runtime
