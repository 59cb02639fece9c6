#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "motion/robots/robot_model.h"
#include "runtime/record/mcap_writer.h"
#include "runtime/record/recorded_file.h"
#include "runtime/run/run_result.h"
#include "runtime/tick/channels.h"

namespace rob::runtime {

/// The record of `rob run --mcap` (docs/cli.md, mcap): every reference of a run with what was
/// measured, its outputs, prints and events, and the files that it was made of. Times are those of
/// the run: the same run on the virtual clock gives the same bytes.
class RunRecord {
 public:
  /// Opens the file at once: throws FileError. `used`: the names of the files that the program
  /// USEs.
  RunRecord(const std::string& path, const motion::RobotModel& robot, std::string program,
            std::vector<std::string> used, const std::vector<RecordedFile>& files);

  void row(const Snapshot& snapshot);
  void signal(const SignalChange& change);
  void print(double time, int line, const std::string& text);
  /// After the run: its events. False if the file is incomplete.
  bool finish(const RunResult& result);
  std::int64_t lost() const { return writer_.lost(); }

 private:
  void put_joints(const Snapshot& snapshot, std::uint64_t time);
  void put_pose(const motion::Pose& pose, std::uint64_t time);
  void put_state(const Snapshot& snapshot, std::uint64_t time);
  void log(double time, int level, int line, const std::string& text);
  std::string file_of(int tag) const;

  const motion::RobotModel& robot_;
  std::string program_;
  std::vector<std::string> used_;
  McapWriter writer_;
  std::uint16_t joints_ = 0;
  std::uint16_t pose_ = 0;
  std::uint16_t state_ = 0;
  std::uint16_t signals_ = 0;
  std::uint16_t log_ = 0;
  std::string last_state_;
};

}  // namespace rob::runtime
