#include "tests/support/source_files.h"

#include <algorithm>
#include <array>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <stdexcept>

namespace fs = std::filesystem;

namespace rob::test {

namespace {

const fs::path& root() {
  static const fs::path path = ROB_SOURCE_DIR;
  return path;
}

bool is_source(const fs::path& path) {
  constexpr std::array<std::string_view, 4> kExtensions{".h", ".cpp", ".def", ".inc"};
  return std::ranges::find(kExtensions, path.extension().string()) != kExtensions.end();
}

}  // namespace

std::string text_of(const std::string& path) {
  std::ostringstream text;
  const std::ifstream file(root() / path, std::ios::binary);
  if (!file) throw std::runtime_error("cannot read " + path);
  text << file.rdbuf();
  return text.str();
}

std::vector<std::string> prose_of(const std::string& page) {
  std::vector<std::string> lines;
  std::istringstream all(page);
  bool shown = false;
  for (std::string line; std::getline(all, line);) {
    const std::size_t text = line.find_first_not_of(' ');
    const bool fence = text != std::string::npos && line.compare(text, 3, "```") == 0;
    if (!fence && !shown) lines.push_back(line);
    shown = shown != fence;
  }
  return lines;
}

std::vector<SourceFile> sources_in(const std::vector<std::string>& folders) {
  std::vector<SourceFile> files;
  for (const std::string& folder : folders) {
    for (const fs::directory_entry& entry : fs::recursive_directory_iterator(root() / folder)) {
      if (!is_source(entry.path())) continue;
      const std::string path = entry.path().lexically_relative(root()).generic_string();
      files.push_back({path, text_of(path)});
    }
  }
  std::ranges::sort(files, {}, &SourceFile::path);
  return files;
}

std::vector<std::string> layer_folders() {
  std::vector<std::string> folders{"base", "lang", "motion", "drivers", "runtime"};
  std::erase_if(folders, [](const std::string& folder) { return !fs::exists(root() / folder); });
  return folders;
}

std::vector<SourceFile> layers() { return sources_in(layer_folders()); }

std::vector<Include> includes_of(std::string_view text) {
  std::vector<Include> includes;
  std::istringstream lines{std::string(text)};
  for (std::string line; std::getline(lines, line);) {
    std::erase_if(line, [](char c) { return c == ' ' || c == '\t'; });
    constexpr std::string_view kDirective = "#include";
    if (!line.starts_with(kDirective) || line.size() <= kDirective.size()) continue;
    const char open = line[kDirective.size()];
    const std::size_t end = line.find(open == '<' ? '>' : '"', kDirective.size() + 1);
    if (end == std::string::npos) continue;
    includes.push_back(
        {line.substr(kDirective.size() + 1, end - kDirective.size() - 1), open == '<'});
  }
  return includes;
}

}  // namespace rob::test
