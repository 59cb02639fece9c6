#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "lang/text/ascii.h"
#include "lang/values/pose_math.h"

namespace rob::lang {

/// The content of a program's points file, as plain values; where it comes from is none of the
/// language's business.
struct PointTable {
  struct Point {
    std::string name;
    std::string frame;  ///< of the program, that `pose` is in; empty for the world
    PoseValue pose;
    std::vector<double> joints{};  ///< that it was taught with; empty where they are not known
    bool with_tool = false;        ///< that was on then
  };
  std::vector<Point> points;

  /// Names are the same in small letters and in capitals. Null if there is none.
  const Point* find(std::string_view name) const {
    for (const Point& point : points) {
      if (same_word(point.name, name)) return &point;
    }
    return nullptr;
  }
};

/// A point that TEACH keeps.
struct TaughtPoint {
  std::string_view name;
  std::string_view frame;  ///< of the program, that `pose` is in; empty for the world
  std::string_view tool;   ///< of the program, that was on; empty for none
  PoseValue pose;
  PoseValue tip{};               ///< of the tool, whatever its name
  std::vector<double> joints{};  ///< m or rad, one an axis; empty where the machine has none
};

}  // namespace rob::lang
