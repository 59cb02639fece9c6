#pragma once

#include <algorithm>
#include <cmath>
#include <memory>
#include <optional>
#include <vector>

#include "motion/path/joint_path.h"
#include "motion/path/tool_line.h"
#include "motion/plan/segment_descriptor.h"

namespace rob::motion {

/// Where motions lie on a part of the path that is not one motion as it was commanded.
struct PathStretch {
  struct Member {
    SegmentDescriptor segment;  ///< as it was commanded
    double begin = 0;           ///< m of σ from the beginning of the stretch
    double end = 0;             ///< likewise; beyond the stretch where the motion goes on there
    bool begins = true;         ///< here; else on what lies before
    double before = 0;          ///< m at its beginning, and at its end, that are not on a curve
    double beyond = 0;
  };
  std::vector<Member> members;
  JointPath axes;  ///< of a parameter 0 … 1, where it is a curve, or a part of a tool's line
  std::optional<ToolLine> line;  ///< that part
  /// On a curve: the m that the tool goes for a m of σ, at places that are slopes_apart m of σ
  /// apart.
  std::vector<double> slopes;
  double slopes_apart = 0;
  /// The greatest slope between two places, m of σ.
  double greatest_slope(double begin, double end) const;
  bool goes_on = false;  ///< the next item continues it without a corner
};

inline double PathStretch::greatest_slope(double begin, double end) const {
  if (slopes.empty()) return 1;
  const auto last = static_cast<double>(slopes.size() - 1);
  const auto first_at =
      static_cast<std::size_t>(std::clamp(std::floor(begin / slopes_apart), 0.0, last));
  const auto last_at =
      static_cast<std::size_t>(std::clamp(std::ceil(end / slopes_apart), 0.0, last));
  return *std::max_element(slopes.begin() + static_cast<std::ptrdiff_t>(first_at),
                           slopes.begin() + static_cast<std::ptrdiff_t>(last_at) + 1);
}

/// The PathPlanner's next input: a motion as it is, a part of one, or a curve along many.
struct PathItem {
  SegmentDescriptor segment;  ///< of a curve the last of its motions; with the bounds of the item
  std::shared_ptr<const PathStretch> stretch;  ///< null: a motion as it was commanded
};

/// It has a target and no law of its own.
inline bool moves(const SegmentDescriptor& segment) {
  return !segment.no_length && !segment.dwell && !segment.jog->present() &&
         !segment.profile.present();
}
/// It has a way on the path.
inline bool has_way(const SegmentDescriptor& segment) {
  return moves(segment) && segment.ahead.length > 0;
}

}  // namespace rob::motion
