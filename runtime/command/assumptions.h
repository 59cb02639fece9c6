#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "runtime/command/robot_links.h"

namespace rob::runtime {

/// The assumptions while a program is foretold: inputs that nobody drives stay OFF or at 0 V, a
/// WAIT that reads one is met, HALT and ASK are answered. Each place that rests on one is a
/// finding.
class Assumptions {
 public:
  explicit Assumptions(const RobotLinks& links) : links_(links) {}

  /// The program is foretold. `inputs`: by signal number what those are called that nobody drives,
  /// empty for all others.
  void foretell(std::vector<std::string> inputs) {
    inputs_ = std::move(inputs);
    foretelling_ = true;
  }
  bool foretelling() const { return foretelling_; }

  /// This signal was read.
  void note_read(int line, int signal);
  // The same in the condition of a WAIT: taken_as_met() is to say it.
  void begin_condition() { read_ = -1; }
  void note_read_in_condition(int signal);
  bool taken_as_met(int line);
  /// `what`: HALT or ASK.
  /// RECEIVE has got an empty line.
  void note_line(int line);
  void note_answer(int line, std::string_view what);

 private:
  const RobotLinks& links_;
  std::vector<std::string> inputs_;
  bool foretelling_ = false;
  int read_ = -1;  ///< by the condition of the current WAIT
};

}  // namespace rob::runtime
