#pragma once

#include <cstdio>
#include <memory>
#include <stdexcept>
#include <string>

namespace rob::runtime {

/// A file that cannot be read or written: which, why, and the remedy. Exit code 74.
class FileError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// A command line that asks for what it cannot mean. Exit code 64.
class UsageError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// The whole of a regular file of at most `most` bytes. Throws FileError, at once also for
/// folders, pipes and devices, which might never end.
std::string read_file(const std::string& path, std::size_t most);

/// Standard input, on a command line.
inline constexpr const char* kStandardInput = "-";
/// Standard input to its end, at most `most` bytes. Throws FileError.
std::string read_input(std::size_t most);

struct CloseFile {
  void operator()(std::FILE* file) const noexcept { std::fclose(file); }
};
using FileHandle = std::unique_ptr<std::FILE, CloseFile>;

/// Opens a log for writing, emptied. Throws FileError for what is no regular file (and neither
/// /dev/null nor /dev/full), without waiting for a reader of a pipe.
FileHandle open_log(const std::string& path);

}  // namespace rob::runtime
