#pragma once

#include <doctest/doctest.h>

#include <string>
#include <utility>
#include <vector>

#include "runtime/prompt/session.h"
#include "tests/runtime/prompt/virtual_prompt.h"
#include "tests/support/scratch_folder.h"

namespace rob::test {

/// A prompt on the gantry as a pipe has it, on the virtual clock, with files in a scratch folder.
struct PipedPrompt {
  explicit PipedPrompt(const ScratchFolder& folder, const std::string& robot = "gantry",
                       const std::string& trace = "")
      : session(options(folder, robot, trace), screen) {}
  static runtime::SessionOptions options(const ScratchFolder& folder, const std::string& robot,
                                         const std::string& trace) {
    runtime::SessionOptions options;
    options.robot = robot;
    options.fast = true;
    options.waits = true;
    options.points_file = folder.file("prompt.points");
    options.trace = trace;
    options.archive = folder.file("archive");
    return options;
  }
  /// Enters each, and carries it out; what was printed.
  std::string enter(const std::vector<std::string>& entries) {
    const std::size_t before = screen.results.size();
    for (const std::string& entry : entries) {
      REQUIRE(session.enter(entry) == runtime::Session::Taken::Done);
      session.carry_out_entries();
    }
    session.finish();
    return screen.results.substr(before);
  }
  /// What was said since this was asked last.
  std::string said() { return std::exchange(screen.messages, ""); }
  double axis(int i) const {
    return session.robot().reports().last()->sample.reference.q[i] * 1000;  // mm
  }
  double time() const { return session.robot().reports().last()->sample.reference.time; }

  WrittenScreen screen;
  runtime::Session session;
};

}  // namespace rob::test
