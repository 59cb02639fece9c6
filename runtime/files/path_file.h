#pragma once

#include <string>

#include "motion/ahead/path_listener.h"
#include "motion/robots/robot_model.h"
#include "runtime/files/atomic_file.h"

namespace rob::runtime {

/// The path that the look-ahead law has planned (docs/cli.md, --path): a header, then a row for
/// both ends of each piece: sigma, the axes' values, and their first and second derivatives with
/// respect to sigma. Between two rows the axes are the quintic through both; where second
/// derivatives leap one sigma has two rows. mm and deg, 17 significant digits.
class PathFile final : public motion::PathListener {
 public:
  /// `path`: where it will stand.
  PathFile(const std::string& path, const motion::RobotModel& robot);

  void planned(const motion::Piece& piece) override;
  /// Saves it, whole (save_file()): throws FileError, and then nothing has changed.
  void save() const { save_file(path_, text_); }

 private:
  void put(const motion::Piece& piece, double at);

  const motion::RobotModel& robot_;
  std::string path_;
  std::string text_;
  double sigma_ = 0;  ///< mm, of the last row
};

}  // namespace rob::runtime
