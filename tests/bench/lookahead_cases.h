#pragma once

#include <string>
#include <vector>

#include "tests/support/path_deviation.h"

namespace rob::bench {

/// A program whose times under other controllers are known, from rest to rest, with every axis
/// within 1000 mm/s² (deg/s²) and the tool within `zone` of what is programmed. mm, s.
struct LookAheadCase {
  std::string name;
  const char* robot;          ///< the file below tests/bench
  test::ProgrammedPath path;  ///< begins where the robot stands
  std::vector<double> turns;  ///< deg: what the rotary axis reaches at each place; may be empty
  double speed = 0;           ///< mm/s, AT
  double zone = 0;            ///< mm
  double linuxcnc = 0;        ///< s: the better of its 2.9 and 2.10 planners
  double best_known = 0;      ///< s: the best feasible trajectory known
  double margin = 1.03;       ///< what Rob may take of best_known
  double jerk_linuxcnc = 0;   ///< s, with 1e5 mm/s³; 0: not compared
  double jerk_goal = 0;       ///< s

  /// The lesser of margin·best_known and LinuxCNC − 0.001 s.
  double goal() const;
  /// One MOVE for each place but the first; jerk in mm/s³, 0: none.
  std::string program(double jerk) const;
};

inline constexpr double kBenchAcceleration = 1000;  ///< mm/s² and deg/s² of xy.toml, xyza.toml
inline constexpr double kBenchJerk = 1e5;           ///< mm/s³

std::vector<LookAheadCase> lookahead_cases();

}  // namespace rob::bench
