#pragma once

#include <string>
#include <utility>

#include "tests/runtime/prompt/virtual_prompt.h"
#include "tests/support/scratch_folder.h"

namespace rob::test {

/// A prompt as a pipe has it, with files in a scratch folder.
struct PipedPrompt : VirtualPrompt {
  explicit PipedPrompt(const ScratchFolder& folder, const std::string& robot = "gantry",
                       const std::string& trace = "")
      : VirtualPrompt(in(folder, robot, trace)) {}
  static runtime::SessionOptions in(const ScratchFolder& folder, const std::string& robot,
                                    const std::string& trace) {
    runtime::SessionOptions options = VirtualPrompt::options(robot);
    options.waits = true;
    options.points_file = folder.file("prompt.points");
    options.trace = trace;
    options.archive = folder.file("archive");
    return options;
  }
  /// What was said since this was asked last.
  std::string said() { return std::exchange(screen.messages, ""); }
  double axis(int i) const {
    return session.robot().reports().last()->sample.reference.q[i] * 1000;  // mm
  }
};

}  // namespace rob::test
