#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace rob::test {

/// What became of a program that was started: its exit code, or 128 + the signal that ended it.
struct ProcessResult {
  int exit_code = -1;
  std::string out;
  std::string err;
};

/// Starts `arguments[0]` with the others, waits for its end and returns what it wrote. Standard
/// input is empty. Throws std::system_error if it cannot be started.
ProcessResult run_process(const std::vector<std::string>& arguments);

/// The whole of a file, byte by byte; throws std::runtime_error if it cannot be read.
std::string read_whole_file(const std::filesystem::path& file);

/// A new folder for passing files; it disappears with the object.
class ScratchFolder {
 public:
  ScratchFolder();
  ~ScratchFolder();
  ScratchFolder(const ScratchFolder&) = delete;
  ScratchFolder& operator=(const ScratchFolder&) = delete;

  const std::filesystem::path& path() const { return path_; }

 private:
  std::filesystem::path path_;
};

}  // namespace rob::test
