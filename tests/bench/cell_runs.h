#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "drivers/contact/sim_cell.h"
#include "motion/robots/robot_model.h"
#include "runtime/run/run_result.h"
#include "tests/bench/bench_options.h"

namespace rob::bench {

/// What really is at the tool at the end of a servo cycle, SI, along the world's axes: no sensor is
/// in between.
struct Instant {
  double time = 0;
  Eigen::Vector3d tip = Eigen::Vector3d::Zero();
  Eigen::Vector3d foot = Eigen::Vector3d::Zero();  ///< lower end of what is held
  Eigen::Vector3d force = Eigen::Vector3d::Zero();
  double torque = 0;  ///< about the upward vertical
  double turned = 0;  ///< rad, of the last axis
  bool held = false;  ///< something is in the jaws
};

/// How the cell is left.
struct CellEnd {
  int dropped = 0;
  std::vector<bool> occupied;  ///< holes, numbered as in RackGrid
  std::vector<double> turned;  ///< rad of the caps' thread that are on
};

struct CellRun {
  runtime::RunResult result;
  std::vector<Instant> instants;
  CellEnd end;
};

/// Runs a program's text on the virtual clock, on `robot` and in its simulated cell. `file`: for
/// messages. Throws std::runtime_error for a program that does not compile.
CellRun run_in_cell(const std::string& file, const std::string& source,
                    const motion::RobotModel& robot);

/// What a bench of one skill in many cells is told on its command line.
struct CellBench {
  std::string program;
  std::uint64_t first = 1;  ///< seed
  int cells = 0;
  bool by_hand = false;  ///< the skill as it is spelt out in velocity mode
  bool every = false;    ///< a line for each cell, not only for those that fail

  void add_to(BenchOptions& line);
  /// The program's text, in the form that was asked for; throws as edited() does.
  std::string source() const;
  /// lwa4p in the cell number `i` of `cells`.
  motion::RobotModel robot(int i) const;
  std::uint64_t seed(int i) const { return first + static_cast<std::uint64_t>(i); }
};

/// What the program printed, and the error that ended it.
std::string said_by(const CellRun& run);
std::string text_of(const std::string& file);
/// With what stands for `was` put in its place; throws std::runtime_error unless it is there once.
std::string edited(std::string text, const std::string& was, const std::string& is);

}  // namespace rob::bench
