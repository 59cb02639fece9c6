#include "runtime/words/codes.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <regex>
#include <sstream>
#include <string>

namespace fs = std::filesystem;
using rob::runtime::all_codes;
using rob::runtime::CodeText;

TEST_CASE("every code of the runtime has a title and an explanation, and is there once") {
  for (const CodeText& code : all_codes()) {
    CAPTURE(code.code);
    CHECK_FALSE(code.title.empty());
    CHECK_FALSE(code.explanation.empty());
    CHECK(std::ranges::count(all_codes(), code.code, &CodeText::code) == 1);
  }
}

TEST_CASE("no code is written in the sources beside the table") {
  const std::regex code("\"[ENW][0-9]{3}\"");
  for (const auto& entry :
       fs::recursive_directory_iterator(std::string(ROB_SOURCE_DIR) + "/runtime")) {
    if (!entry.is_regular_file()) continue;
    std::ostringstream text;
    text << std::ifstream(entry.path()).rdbuf();
    CAPTURE(entry.path().string());
    CHECK_FALSE(std::regex_search(text.str(), code));
  }
}
