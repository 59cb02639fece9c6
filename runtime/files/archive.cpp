#include "runtime/files/archive.h"

#include <fmt/chrono.h>
#include <fmt/format.h>
#include <sys/stat.h>

#include <algorithm>
#include <charconv>
#include <cstdlib>
#include <ctime>
#include <filesystem>
#include <optional>
#include <system_error>

#include "lang/text/source_text.h"
#include "runtime/files/atomic_file.h"
#include "runtime/files/files.h"

namespace rob::runtime {

namespace {

namespace fs = std::filesystem;

/// A version as a file: "00007_20261122-213005.rob".
struct Entry {
  int number = 0;
  fs::path path;
};

std::optional<int> number_of(const fs::path& path) {
  const std::string name = path.filename().string();
  int number = 0;
  const auto [end, error] = std::from_chars(name.data(), name.data() + name.size(), number);
  const bool version = error == std::errc() && *end == '_' && path.extension() == ".rob";
  return version ? std::optional(number) : std::nullopt;
}

std::vector<Entry> entries_in(const std::string& folder) {
  std::vector<Entry> entries;
  std::error_code missing;  // a file without any version has no folder
  for (const auto& one : fs::directory_iterator(folder, missing)) {
    if (const auto number = number_of(one.path())) entries.push_back({*number, one.path()});
  }
  std::ranges::sort(entries, {}, &Entry::number);
  return entries;
}

/// "20261122-213005" → "2026-11-22 21:30:05 UTC".
std::string time_in(const fs::path& path) {
  const std::string name = path.stem().string();
  const std::string digits = name.substr(name.find('_') + 1);
  constexpr std::size_t kDigits = 15;
  if (digits.size() != kDigits) return "";
  const auto part = [&](std::size_t at, std::size_t n) { return digits.substr(at, n); };
  return fmt::format("{}-{}-{} {}:{}:{} UTC", part(0, 4), part(4, 2), part(6, 2), part(9, 2),
                     part(11, 2), part(13, 2));
}

}  // namespace

std::string Archive::default_folder() {
  const char* const data = std::getenv("XDG_DATA_HOME");
  if (data != nullptr && *data == '/') return std::string(data) + "/rob/archive";
  const char* const home = std::getenv("HOME");
  return home != nullptr && *home == '/' ? std::string(home) + "/.local/share/rob/archive" : "";
}

std::string Archive::folder_of(const std::string& file) const {
  if (folder_.empty())
    throw FileError("there is no place for the archive: set HOME or XDG_DATA_HOME");
  std::error_code error;
  const fs::path full = fs::weakly_canonical(file, error);
  if (error) throw FileError(fmt::format("cannot find '{}': {}", file, error.message()));
  return folder_ + full.string();
}

void Archive::keep(const std::string& file) const {
  struct stat status {};
  if (::stat(file.c_str(), &status) != 0) return;
  const std::string text = read_file(file, lang::kMaxSourceBytes);
  const std::string folder = folder_of(file);
  const std::vector<Entry> entries = entries_in(folder);
  if (!entries.empty() && read_file(entries.back().path, lang::kMaxSourceBytes) == text) return;
  std::error_code error;
  fs::create_directories(folder, error);
  if (error)
    throw FileError(fmt::format("cannot keep the version before of '{}' in '{}': {}", file, folder,
                                error.message()));
  save_file(
      fmt::format("{}/{:05}_{:%Y%m%d-%H%M%S}.rob", folder,
                  entries.empty() ? 1 : entries.back().number + 1, fmt::gmtime(status.st_mtime)),
      text);
}

std::vector<Archive::Version> Archive::versions(const std::string& file) const {
  std::vector<Version> versions;
  for (const Entry& entry : entries_in(folder_of(file))) {
    const std::string text = read_file(entry.path, lang::kMaxSourceBytes);
    versions.push_back({entry.number, time_in(entry.path),
                        static_cast<std::size_t>(std::ranges::count(text, '\n'))});
  }
  return versions;
}

std::string Archive::text(const std::string& file, int number) const {
  for (const Entry& entry : entries_in(folder_of(file))) {
    if (entry.number == number) return read_file(entry.path, lang::kMaxSourceBytes);
  }
  throw FileError(fmt::format("there is no version {} of '{}'; :archive lists them", number, file));
}

}  // namespace rob::runtime
