#pragma once

#include "motion/plan/segment_descriptor.h"

namespace rob::motion {

/// Neither a dwell, nor a jog, nor a motion with a profile.
inline bool moves(const SegmentDescriptor& segment) noexcept {
  return !segment.no_length && !segment.dwell && !segment.jog.present() &&
         !segment.profile.present();
}

/// A motion that is a leg of the path.
inline bool has_way(const SegmentDescriptor& segment) noexcept {
  return moves(segment) && segment.ahead.length > 0;
}

}  // namespace rob::motion
