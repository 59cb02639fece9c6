#pragma once

#include <map>
#include <string>
#include <vector>

#include "motion/robots/robot_model.h"
#include "runtime/files/points_file.h"

namespace rob::runtime {

/// Where a prompt keeps the points of a robot: `prompt.gantry.points` for `prompt.points`, or that
/// file itself if it is there alone, and for this robot. Empty for an empty name. Throws FileError.
std::string points_at_prompt(const std::string& name, const std::string& robot);

/// Which points of the points file a prompt has declared, so that they can be used as if each had
/// been written after POINT.
class SessionPoints {
 public:
  struct Change {
    std::string declares;           ///< a POINT a line, for those that are new or have moved
    std::vector<std::string> gone;  ///< names that the file has no more
  };

  /// The work to be done at the prompt so that its points are those of the file; it counts as done.
  /// Points in a FRAME are left to who declares the frame.
  Change take_change(const Points& points, const motion::RobotModel& robot);
  /// None is declared any more.
  void clear() { declared_.clear(); }

 private:
  std::map<std::string, std::string> declared_;  ///< by name, the line of the file
};

}  // namespace rob::runtime
