// Holds docs/architecture.md to the repository: the files and folders that it names are there, and
// it names each folder of the product.

#include <doctest/doctest.h>

#include <algorithm>
#include <array>
#include <filesystem>
#include <regex>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "tests/support/source_files.h"

namespace {

using rob::test::prose_of;

constexpr const char* kPage = "docs/architecture.md";

std::vector<std::string> in_backticks(const std::string& line) {
  static const std::regex span("`([^`]+)`");
  std::vector<std::string> found;
  for (std::sregex_iterator at(line.begin(), line.end(), span), end; at != end; ++at) {
    found.push_back((*at)[1]);
  }
  return found;
}

/// A command has a space, and a name of C++ neither '/' nor such an end.
bool looks_like_path(std::string_view span) {
  constexpr std::array<std::string_view, 5> kEnds{".h", ".cpp", ".def", ".inc", ".md"};
  if (span.find(' ') != std::string_view::npos) return false;
  return span.find('/') != std::string_view::npos ||
         std::ranges::any_of(kEnds, [&](std::string_view end) { return span.ends_with(end); });
}

std::set<std::string> paths_on(const std::string& page) {
  std::set<std::string> paths;
  for (const std::string& line : prose_of(page)) {
    for (const std::string& span : in_backticks(line)) {
      if (looks_like_path(span)) paths.insert(span);
    }
  }
  return paths;
}

/// Sources that stand on a page without backticks, links aside.
std::vector<std::string> bare_paths_on(const std::string& page) {
  static const std::regex held("`[^`]*`|\\]\\([^)]*\\)");
  static const std::regex source(R"([\w/]+\.(h|cpp|def|inc)\b)");
  std::vector<std::string> found;
  for (const std::string& line : prose_of(page)) {
    const std::string bare = std::regex_replace(line, held, " ");
    for (std::sregex_iterator at(bare.begin(), bare.end(), source), end; at != end; ++at) {
      found.push_back(at->str());
    }
  }
  return found;
}

/// The folders in the first column of the table that begins with "| folder |", without a '/' at
/// their ends.
std::set<std::string> folders_of_table(const std::string& page) {
  std::set<std::string> folders;
  bool inside = false;
  for (const std::string& line : prose_of(page)) {
    inside = line.starts_with("| folder |") || (inside && line.starts_with("|"));
    if (!inside) continue;
    for (std::string folder : in_backticks(line.substr(0, line.find('|', 1)))) {
      if (folder.ends_with('/')) folder.pop_back();
      folders.insert(folder);
    }
  }
  return folders;
}

std::set<std::string> folders_of_sources() {
  std::set<std::string> folders;
  for (const rob::test::SourceFile& file : rob::test::layers()) {
    folders.insert(file.path.substr(0, file.path.rfind('/')));
  }
  return folders;
}

}  // namespace

TEST_CASE("the architecture names paths that are there") {
  const std::string page = rob::test::text_of(kPage);
  const std::set<std::string> paths = paths_on(page);
  CHECK(paths.size() >= 20);
  for (const std::string& path : paths) {
    CHECK_MESSAGE(std::filesystem::exists(std::filesystem::path(ROB_SOURCE_DIR) / path),
                  kPage << " names " << path);
  }
  for (const std::string& path : bare_paths_on(page)) {
    FAIL_CHECK(kPage << " names " << path << " without backticks");
  }
}

TEST_CASE("the architecture says what is in each folder of the product, and in no other") {
  const std::set<std::string> named = folders_of_table(rob::test::text_of(kPage));
  const std::set<std::string> there = folders_of_sources();
  CHECK(there.size() > 20);
  for (const std::string& folder : there) {
    CHECK_MESSAGE(named.contains(folder), "the table does not name " << folder);
  }
  for (const std::string& folder : named) {
    CHECK_MESSAGE(there.contains(folder), "the table names " << folder);
  }
}

TEST_CASE("paths are found in the prose of a page") {
  const std::string page =
      "`a/b.h` and `c.cpp` `D::e(f)` `./test --seed S`\n"
      "  ```console\n$ `not/this.h` nor.this.h\n  ```\n"
      "[`g/h`](../i/j.h) k.md, in l/m.def\n";
  CHECK(paths_on(page) == std::set<std::string>{"a/b.h", "c.cpp", "g/h"});
  CHECK(bare_paths_on(page) == std::vector<std::string>{"l/m.def"});
}

TEST_CASE("folders are found in the first column of their table") {
  const std::string page =
      "| target | folder |\n|---|---|\n| `a` | `b/` |\n\n"
      "| folder | what is in it |\n|---|---|\n| `c/`, `d/e` | `f/g` |\n| `h` | i |\n\n| `j` | k "
      "|\n";
  CHECK(folders_of_table(page) == std::set<std::string>{"c", "d/e", "h"});
}

TEST_CASE("every source of the product is listed, so that it is compiled") {
  std::string lists;
  for (const std::string layer : {"lang", "motion", "drivers", "runtime"})
    lists += rob::test::text_of(layer + "/sources.cmake");
  int sources = 0;
  for (const rob::test::SourceFile& file :
       rob::test::sources_in({"lang", "motion", "drivers", "runtime"})) {
    const bool of_a_program =
        file.path.starts_with("runtime/cli/main") || file.path == "runtime/cli/import_files.cpp";
    if (!file.path.ends_with(".cpp") || of_a_program) continue;
    ++sources;
    CHECK_MESSAGE(lists.find("  " + file.path + "\n") != std::string::npos,
                  file.path << " is in no sources.cmake");
  }
  CHECK(sources > 200);
}
