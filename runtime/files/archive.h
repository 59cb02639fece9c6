#pragma once

#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace rob::runtime {

/// Keeps the content that files had before they were saved: a folder of numbered versions for each
/// file, named after its full path. Nothing is ever thrown away. All throw FileError.
class Archive {
 public:
  struct Version {
    int number = 0;
    std::string saved;      ///< when, for people: "2026-11-22 21:30:05 UTC"
    std::size_t lines = 0;  ///< that it has
  };

  explicit Archive(std::string folder) : folder_(std::move(folder)) {}
  /// $XDG_DATA_HOME/rob/archive, or ~/.local/share/rob/archive; empty without HOME.
  static std::string default_folder();

  /// Keeps what the file holds now as a version of it, unless the last version is the same. A file
  /// that is not there has none.
  void keep(const std::string& file) const;
  /// The oldest first.
  std::vector<Version> versions(const std::string& file) const;
  /// Throws also if there is no such version.
  std::string text(const std::string& file, int number) const;

 private:
  std::string folder_of(const std::string& file) const;

  std::string folder_;
};

}  // namespace rob::runtime
