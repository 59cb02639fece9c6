#pragma once

#include <cstddef>
#include <functional>
#include <mutex>
#include <string>
#include <string_view>
#include <vector>

#include "lang/machine/point_table.h"
#include "lang/text/diagnostic.h"
#include "motion/robots/robot_model.h"
#include "runtime/files/point_keeper.h"

namespace rob::runtime {

/// The size up to which a points file is read. [choice] more than 10,000 points
inline constexpr std::size_t kMostPointsBytes = std::size_t{4} << 20U;

/// The content of a points file (docs/language.md, "Points"). Its first line names the robot and
/// gives its geometry, by the pose to which some joints bring its flange. After it come a point a
/// line, blank lines and `//` comments. Without the geometry (written by hand) the name alone is
/// compared.
///
///     ROBOT "gantry" JOINTS(100mm, 200mm, 51deg) POSE(100mm, 200mm, 0mm, 0deg, 0deg, 51deg)
///     pick = POSE(40mm, 20mm, 0mm, 0deg, 0deg, 90deg) JOINTS(40mm, 20mm, 90deg) IN world
///         TOOL none TAUGHT "2026-11-21 05:40:12 UTC"          (on the same line)
///
/// Points are written with 0.001 mm and 0.0001 deg, the robot's line with all digits (PointDigits).
///
/// A point whose POSE was changed by hand has no JOINTS and no TOOL.
struct Points {
  /// Text that people have written beside a line; it moves with the line.
  struct Remarks {
    std::string above;   ///< comments alone on their lines and blank lines, each with its end
    std::string behind;  ///< "// …" on the line itself
  };
  struct Point {
    lang::PointTable::Point value;
    std::vector<double> joints;  ///< m or rad, one an axis; empty where not known
    std::string tool;            ///< of the program; empty for none
    std::string taught;          ///< when, for people
    Remarks remarks{};
  };
  std::vector<Point> points;
  Remarks robot;                  ///< of the line that names the robot
  std::string below;              ///< comments and blank lines after the last point
  lang::Diagnostics diagnostics;  ///< all errors of the file; with one it must not be used

  lang::PointTable table() const;
};

/// Where the points of a program are: `pallet.points` beside `pallet.rob`.
std::string points_file_of(const std::string& program_file);

Points parse_points(std::string_view text, const motion::RobotModel& robot);
/// The line of one point, without what people have written beside it.
std::string point_text(const Points::Point& point, const motion::RobotModel& robot);
/// Sorted by name, so that it always looks the same; parse_points() reads it back.
std::string points_text(const Points& points, const motion::RobotModel& robot);

/// The points of a file; none if it is not there. Throws FileError, with all messages, if it cannot
/// be read or used.
Points load_points(const std::string& file, const motion::RobotModel& robot);

/// Keeps what is taught in a file, which is read again each time: what was edited meanwhile stays.
/// All may be called from several threads.
class PointsFile final : public PointKeeper {
 public:
  /// `robot` must outlive it.
  PointsFile(std::string file, const motion::RobotModel& robot)
      : file_(std::move(file)), robot_(robot) {}

  std::optional<lang::Refusal> keep(const lang::TaughtPoint& point) override;

  // The following throw FileError, with the file as it was.
  /// False if there is no such point. Throws also if there is one of the new name.
  bool rename(std::string_view name, const std::string& new_name);
  /// False if there is no such point.
  bool forget(std::string_view name);
  /// Takes back the last change made here that was not taken back yet; false if there is none.
  /// Throws also if others have changed the file since.
  bool undo();

  /// From now on they are kept there; changes of before stay as they are.
  void move_to(std::string file);

 private:
  struct Change {
    std::string before;  ///< the text of the file, empty if it was not there
    std::string after;
  };
  /// False, and nothing is written, if `edit` says so.
  bool change(const std::function<bool(Points&)>& edit);

  std::mutex mutex_;
  std::string file_;
  const motion::RobotModel& robot_;
  std::vector<Change> changes_;
};

}  // namespace rob::runtime
