#pragma once

#include <string>

#include "motion/ahead/path_listener.h"
#include "motion/robots/robot_model.h"
#include "runtime/program/files.h"

namespace rob::runtime {

/// The path that the look-ahead law has planned (docs/cli.md, --path): a header, then a row for
/// both ends of each piece: sigma, the axes' values, and their first and second derivatives with
/// respect to sigma. Between two rows the axes are the quintic through both; where second
/// derivatives leap one sigma has two rows. mm and deg, 17 significant digits.
class PathFile final : public motion::PathListener {
 public:
  /// Opens the file at once: throws FileError.
  PathFile(const std::string& path, const motion::RobotModel& robot);

  void planned(const motion::Piece& piece) override;
  /// Flushes; false if not all rows are in the file.
  bool close();

 private:
  void put(const motion::Piece& piece, double at);
  void put(const std::string& text);

  const motion::RobotModel& robot_;
  FileHandle file_;
  double sigma_ = 0;  ///< mm, of the last row
  bool full_ = false;
};

}  // namespace rob::runtime
