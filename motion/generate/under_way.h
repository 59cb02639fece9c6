#pragma once

#include "motion/generate/rest.h"
#include "motion/plan/segment_descriptor.h"
#include "motion/plan/watch.h"

namespace rob::motion {

/// Orders to a path while it is under way.
struct PathOrders {
  double share = 1;    ///< the override, above 0: a share of the programmed speed
  bool stop = false;   ///< the axes shall come to rest on the path, and stand there
  bool brake = false;  ///< and it ends there
};

/// The motion under way while one reference is made. s since the start of the run.
struct UnderWay {
  /// This one, or the last one. The axes stand at its target when it is over.
  SegmentDescriptor segment;
  bool running = false;
  double stamp = 0;         ///< the reference's
  double stamp_before = 0;  ///< the reference's before it
  CycleView view;           ///< the world in the control cycle
  PathOrders orders;

  bool dwelling() const noexcept { return running && segment.dwell; }
  bool jogging() const noexcept { return running && segment.jog->present(); }
  bool on_path() const noexcept { return running && !segment.dwell && !segment.jog->present(); }

  /// A Rest as far as it is known before the axes stand; `time`: when it began.
  Rest rest(Rest::Outcome outcome, WatchedAction* by, double time) const noexcept {
    Rest begun;
    begun.outcome = outcome;
    begun.by = by;
    begun.generation = segment.generation;
    begun.number = segment.number;
    begun.tag = segment.tag;
    begun.trip_time = time;
    begun.trip_q = view.measured;
    return begun;
  }
};

}  // namespace rob::motion
