#include "runtime/files/folder_sources.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <filesystem>
#include <system_error>
#include <utility>
#include <vector>

#include "lang/text/source_text.h"
#include "lang/text/suggest.h"
#include "runtime/files/files.h"

namespace rob::runtime {

namespace {

namespace fs = std::filesystem;

constexpr const char* kEnding = ".rob";

fs::path parent_of(const std::string& file) {
  const fs::path folder = fs::path(file).parent_path();
  return folder.empty() ? "." : folder;
}

/// The same for all ways to write it; what does not exist is as it is written.
std::string identity_of(const fs::path& path) {
  std::error_code none;
  const fs::path canonical = fs::canonical(path, none);
  return none ? path.lexically_normal().string() : canonical.string();
}

/// The names that USE could have in a folder; none where it cannot be read.
void add_names_in(const fs::path& folder, std::vector<std::string>& names) {
  std::error_code none;
  for (fs::directory_iterator entry(folder, none), end; !none && entry != end;
       entry.increment(none)) {
    if (entry->path().extension() == kEnding) names.push_back(entry->path().stem().string());
  }
}

}  // namespace

FolderSources::FolderSources(const std::string& program)
    : program_{program, identity_of(program), ""} {}

std::variant<lang::SourceFile, lang::NoSource> FolderSources::find(std::string_view name,
                                                                   const std::string& by) const {
  const std::array folders{parent_of(by), parent_of(program_.name) / "lib"};
  for (const fs::path& folder : folders) {
    const fs::path path = (folder / fmt::format("{}{}", name, kEnding)).lexically_normal();
    std::error_code none;
    if (!fs::exists(path, none)) continue;
    try {
      return lang::SourceFile{path.string(), identity_of(path),
                              read_file(path.string(), lang::kMaxSourceBytes)};
    } catch (const FileError& error) {
      return lang::NoSource{error.what(), ""};
    }
  }
  std::vector<std::string> names;
  for (const fs::path& folder : folders) add_names_in(folder, names);
  std::ranges::sort(names);  // a folder has no order of its own
  const std::vector<std::string_view> candidates(names.begin(), names.end());
  const std::string meant = lang::did_you_mean(lang::suggest(name, candidates));
  const std::string beside = folders[0].lexically_normal().string();
  const std::string library = folders[1].lexically_normal().string();
  std::string message = fmt::format("there is no {}{} in '{}'", name, kEnding, beside);
  if (library != beside) message += fmt::format(" or '{}'", library);
  if (!meant.empty()) return lang::NoSource{std::move(message), meant};
  return lang::NoSource{std::move(message),
                        "USE tools reads tools.rob from the folder of its file, or from lib"};
}

}  // namespace rob::runtime
