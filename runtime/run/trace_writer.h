#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "motion/robots/robot_model.h"
#include "runtime/files/files.h"
#include "runtime/tick/channels.h"

namespace rob::runtime {

/// The record of a run: a header and a row for each reference period (docs/cli.md, trace). Axis
/// values in mm or deg, with 17 significant digits, so that two traces can be compared bit for
/// bit. When the disk is full the log stops and the motion goes on.
class TraceWriter {
 public:
  /// Opens the file at once: throws FileError. `used`: the names of the files that the program
  /// USEs.
  TraceWriter(const std::string& path, const motion::RobotModel& robot,
              std::vector<std::string> used);

  void write(const Snapshot& snapshot);
  /// Rows that could not be written.
  std::int64_t lost() const { return lost_; }
  /// Flushes; false if not all rows are in the file.
  bool close();

 private:
  void header();
  bool put(const std::string& text);

  const motion::RobotModel& robot_;
  std::vector<std::string> used_;
  FileHandle file_;
  std::string row_;
  bool full_ = false;
  std::int64_t lost_ = 0;
};

}  // namespace rob::runtime
