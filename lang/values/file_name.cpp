#include "lang/values/file_name.h"

#include <algorithm>
#include <array>

#include <fmt/core.h>

#include "lang/text/ascii.h"

namespace rob::lang {
namespace {

/// Files that programs are made of, or that Rob keeps for them.
constexpr std::array<std::string_view, 4> kOwnEndings{".ROB", ".POINTS", ".VALUES", ".TOML"};

bool leaves_folder(std::string_view name) {
  if (name.starts_with('/')) return true;
  int depth = 0;
  while (!name.empty()) {
    const std::size_t end = std::min(name.find('/'), name.size());
    const std::string_view part = name.substr(0, end);
    if (part == "..") --depth;
    if (part != ".." && part != "." && !part.empty()) ++depth;
    if (depth < 0) return true;
    name.remove_prefix(std::min(end + 1, name.size()));
  }
  return false;
}

}  // namespace

std::string objection_to_file(std::string_view name) {
  if (name.empty() || name.ends_with('/') || name.find('\0') != std::string_view::npos) {
    return "it is no name of a file";
  }
  if (leaves_folder(name)) return "it leads out of the program's folder";
  const std::string upper = to_upper(name);
  const auto own = std::ranges::find_if(
      kOwnEndings, [&](std::string_view ending) { return upper.ends_with(ending); });
  if (own == kOwnEndings.end()) return "";
  return fmt::format("files that end in {} belong to Rob", name.substr(name.size() - own->size()));
}

}  // namespace rob::lang
