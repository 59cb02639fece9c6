#pragma once

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "tests/support/process.h"

namespace rob::test {

/// A program file of the test's own, and the `rob` that is under test (ROB_BINARY).
class RobCommand {
 public:
  explicit RobCommand(const std::string& text) {
    std::ofstream(program(), std::ios::binary) << text;
    ::setenv("XDG_STATE_HOME", states().c_str(), 1);  // not that of whoever runs the tests
  }

  std::string file(const std::string& name) const { return (folder_.path() / name).string(); }
  /// Where runs in real time leave their marks.
  std::string states() const { return file("states"); }
  std::string program() const { return file("test.rob"); }

  /// "run", "check", … with the program and further arguments.
  std::vector<std::string> line(const std::string& command,
                                const std::vector<std::string>& more = {}) const {
    std::vector<std::string> arguments{ROB_BINARY, command, program()};
    arguments.insert(arguments.end(), more.begin(), more.end());
    return arguments;
  }
  ProcessResult operator()(const std::string& command,
                           const std::vector<std::string>& more = {}) const {
    return run_process(line(command, more));
  }

 private:
  ScratchFolder folder_;
};

inline bool contains(const std::string& text, const std::string& part) {
  return text.find(part) != std::string::npos;
}

}  // namespace rob::test
