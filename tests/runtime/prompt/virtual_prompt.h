#pragma once

#include <doctest/doctest.h>

#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "runtime/prompt/commands.h"

namespace rob::test {

class WrittenScreen final : public runtime::Screen {
 public:
  void result(std::string_view text) override { results += text; }
  void message(std::string_view text) override { messages += text; }
  std::string results;
  std::string messages;
};

/// A prompt on the gantry, or another robot.
struct VirtualPrompt {
  explicit VirtualPrompt(const std::string& robot = "gantry") : VirtualPrompt(options(robot)) {}
  explicit VirtualPrompt(runtime::SessionOptions options) : session(std::move(options), screen) {}
  static runtime::SessionOptions options(const std::string& robot) {
    runtime::SessionOptions options;
    options.robot = robot;
    options.fast = true;
    options.points_file.clear();
    return options;
  }
  /// Enters each, and carries it out; what was printed.
  std::string enter(const std::vector<std::string>& entries) {
    const std::size_t before = screen.results.size();
    for (const std::string& entry : entries) {
      REQUIRE(runtime::enter(session, entry) == runtime::Session::Taken::Done);
      session.carry_out_entries();
    }
    session.finish();
    return screen.results.substr(before);
  }
  double time() const { return session.robot().reports().last()->sample.reference.time; }

  WrittenScreen screen;
  runtime::Session session;
};

}  // namespace rob::test
