// The lines of a block are looked at as they are typed.

#include <doctest/doctest.h>

#include <filesystem>
#include <string>
#include <vector>

#include "runtime/files/text_lines.h"
#include "runtime/prompt/entry_lines.h"
#include "tests/runtime/prompt/virtual_prompt.h"
#include "tests/support/process.h"

using rob::runtime::EntryLines;
using rob::runtime::Session;
using rob::test::VirtualPrompt;

namespace {

/// "prompt:3:5: error[E201]: …", a line each.
std::vector<std::string> errors_in(const std::string& told) {
  std::vector<std::string> errors;
  for (std::string& line : rob::runtime::split_lines(told))
    if (line.starts_with("prompt:") && line.find("error[") != std::string::npos)
      errors.push_back(std::move(line));
  return errors;
}

/// Types a program line by line. What was said of a block while it was open, and is not said of it
/// as a whole.
std::vector<std::string> said_too_early(const std::string& program) {
  VirtualPrompt prompt;
  std::vector<std::string> wrong;
  std::vector<std::string> said;
  EntryLines entry;
  for (const std::string& line : rob::runtime::split_lines(program)) {
    entry.add(line);
    if (EntryLines::brackets_open(entry.text())) continue;
    prompt.screen.messages.clear();
    if (rob::runtime::enter(prompt.session, entry.text()) == Session::Taken::Incomplete) {
      prompt.session.sound_so_far(entry.text(), 0);
      said = errors_in(prompt.screen.messages);
      continue;
    }
    for (const std::string& error : said)
      if (prompt.screen.messages.find(error) == std::string::npos) wrong.push_back(error);
    said.clear();
    entry.clear();
  }
  return wrong;
}

}  // namespace

TEST_CASE("while a block is open nothing is said that is not true of it as a whole") {
  const std::filesystem::path programs = std::string(ROB_SOURCE_DIR) + "/tests/programs";
  for (const auto& file : std::filesystem::recursive_directory_iterator(programs)) {
    if (file.path().extension() != ".rob") continue;
    CAPTURE(file.path().string());
    CHECK(said_too_early(rob::test::read_whole_file(file.path())) == std::vector<std::string>{});
  }
}
