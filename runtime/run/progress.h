#pragma once

#include <optional>
#include <string>
#include <vector>

#include "runtime/run/run.h"

namespace rob::runtime {

/// A line at the bottom of a terminal that shows how far a run is: source line, time, time left as
/// planned, override and state; or how far a program is foretold. Prints nothing where stderr is no
/// terminal.
class Progress {
 public:
  /// `planned`: s, or 0 where it is not known. `override_share`: 1 is 100 %. `used`: the names of
  /// the files that the program USEs.
  Progress(double planned, double override_share, std::vector<std::string> used);

  /// For a program that is foretold, for so many s of its time at most.
  explicit Progress(double longest) : Progress(longest, 1, {}) {}

  void show(const Position& position);
  /// How far a program is foretold, s.
  void show(double time);
  /// Shows the message of HALT or ASK to the operator. While they wait, nothing else is shown.
  void consult(const Note& note, int line);
  /// Makes room for other output.
  void clear();

 private:
  double planned_;
  double override_share_;
  std::vector<std::string> used_;
  bool terminal_;
  bool shown_ = false;
  std::optional<Note::Kind> consulting_;
  double last_ = -1;  ///< s of the run, or of the clock
};

}  // namespace rob::runtime
