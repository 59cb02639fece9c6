#pragma once

#include <sys/types.h>

#include <chrono>
#include <filesystem>
#include <string>
#include <vector>

#include "tests/support/child.h"
#include "tests/support/scratch_folder.h"

namespace rob::test {

/// What became of a program that was started: its exit code, or 128 + the signal that ended it.
struct ProcessResult {
  int exit_code = -1;
  std::string out;
  std::string err;
};

/// The whole of a file, byte by byte; throws std::runtime_error if it cannot be read.
std::string read_whole_file(const std::filesystem::path& file);

/// A program that runs beside the test: `arguments[0]` with the others, standard input empty.
/// The constructor throws std::system_error if it cannot be started. The destructor kills what has
/// not ended, with all that it has started.
class Process {
 public:
  explicit Process(const std::vector<std::string>& arguments);
  ~Process();
  Process(const Process&) = delete;
  Process& operator=(const Process&) = delete;

  void send(int signal) const;
  /// What it has written to standard error until now.
  std::string err_so_far() const;
  /// Waits for its end, once, and returns all that it wrote. If it takes longer than `patience`, it
  /// is killed with all that it has started, and std::runtime_error names it.
  ProcessResult wait(std::chrono::milliseconds patience = kLongestRun);

 private:
  std::filesystem::path out() const { return scratch_.path() / "out"; }
  std::filesystem::path err() const { return scratch_.path() / "err"; }

  ScratchFolder scratch_;
  std::string name_;
  pid_t child_ = 0;
  bool ended_ = false;
};

/// Starts, waits, and returns what it wrote.
ProcessResult run_process(const std::vector<std::string>& arguments);

}  // namespace rob::test
