#include "runtime/run/output_file.h"

#include <fmt/format.h>
#include <sys/stat.h>

#include <algorithm>
#include <filesystem>
#include <system_error>

#include "runtime/files/archive.h"
#include "runtime/files/files.h"
#include "runtime/files/kept_values.h"
#include "runtime/files/points_file.h"
#include "runtime/files/state_folder.h"

namespace rob::runtime {

namespace {

namespace fs = std::filesystem;

/// Where a file of this name is, or would be made: a link may lead to what is not there yet.
fs::path place_of(fs::path path) {
  constexpr int kMostLinks = 40;  // as the system follows
  std::error_code error;
  for (int i = 0; i < kMostLinks && fs::is_symlink(path, error); ++i)
    path = path.parent_path() / fs::read_symlink(path, error);
  return fs::weakly_canonical(fs::absolute(path, error), error);
}

bool lies_in(const std::string& file, const fs::path& folder) {
  if (folder.empty()) return false;
  const fs::path place = place_of(file);
  const fs::path inside = place_of(folder);
  return std::mismatch(inside.begin(), inside.end(), place.begin(), place.end()).first ==
         inside.end();
}

}  // namespace

/// One name may be a hard link of the other.
bool same_file(const std::string& a, const std::string& b) {
  struct stat first {};
  struct stat second {};
  if (::stat(a.c_str(), &first) == 0 && ::stat(b.c_str(), &second) == 0)
    return first.st_dev == second.st_dev && first.st_ino == second.st_ino;
  return place_of(a) == place_of(b);
}

std::vector<InputFile> inputs_of(const LoadedProgram& program) {
  std::vector<InputFile> inputs{{program.file, "the program"},
                                {points_file_of(program.file), "where its points are kept"},
                                {values_file_of(program.file), "where its values are kept"}};
  for (const std::string& used : used_names(program))
    inputs.push_back({used, "a file that the program USEs"});
  return inputs;
}

void refuse_overwriting(std::string_view option, const std::string& output,
                        const std::vector<InputFile>& inputs) {
  const auto refuse = [&](const std::string& what) {
    throw UsageError(fmt::format("{}: '{}' is {}; name another file", option, output, what));
  };
  for (const InputFile& input : inputs)
    if (same_file(output, input.path)) refuse(input.what);
  if (lies_in(output, Archive::default_folder()))
    refuse("where Rob keeps earlier versions of programs");
  if (lies_in(output, state_folder())) refuse("where Rob keeps its state");
}

}  // namespace rob::runtime
