#pragma once

#include <cstdint>

#include "motion/path/joint_path.h"
#include "motion/plan/boxed.h"
#include "motion/plan/corner.h"
#include "motion/plan/jog_rates.h"
#include "motion/plan/leg_bounds.h"
#include "motion/plan/motion_request.h"
#include "motion/plan/path_event.h"
#include "motion/plan/profile.h"
#include "motion/plan/watch.h"
#include "motion/robots/settle_window.h"
#include "motion/robots/time_scaling.h"
#include "motion/space/joint_vector.h"

namespace rob::motion {

/// One motion, complete and admissible: what the generator needs and nothing else.
/// The segment runs from where the one before it ends (B) to `target` (C).
struct SegmentMotion {
  Tag tag = 0;
  std::uint32_t number = 0;  ///< 1, 2, 3 … in the order of the buffer
  JointVector target;        ///< m, rad
  double duration = 0;       ///< s: T1 of S1
  double t_acc = 0;          ///< s: half the transition around `target`
  bool no_length = false;    ///< target = the target before: the exact pass, a stop or a dwell
  bool dwell = false;        ///< a standstill of `duration`, 0 too; override does not stretch it
  std::uint8_t limit = 0;    ///< what set the duration: 0 nothing, 1 AT, 2 + i the speed of axis i
  double t_acc_before = 0;   ///< s: half the transition in which it begins
  /// What ends early takes all of its generation with it; see Rest
  std::uint32_t generation = 1;
  /// No target, but rates; begins at rest, or joins a jog before. `duration` is what it lasts, 0
  /// where only something else ends it.
  Boxed<JogRates> jog{};
  LivePace live{};  ///< slows it down, as long as it runs
  Watch guard{};    ///< ends it early: UNTIL. Also of the stop that makes it exact
  /// Of one that ends at rest: it is done when the measured robot is within this window.
  SettleWindow settle{};

  /// Along this the axes run, parameter 0 … 1; null: straight. Its planner keeps it as long as the
  /// motion, or the corner after it, can run.
  const JointPath* path = nullptr;
  const Corner* corner = nullptr;  ///< out of the motion before; null: S1's in the axes
  bool from_rest = false;          ///< the target before is reached exactly: no corner leads here
  AxisReserve reserve{};           ///< under Paul's law: beyond its own speeds
  ProfileLaw profile{};            ///< from rest to rest; `duration` is its own
  LegBounds ahead{};               ///< under the look-ahead law, whose times come with its path

  /// The axes stand at the target.
  bool ends_at_rest() const noexcept { return no_length || profile.present(); }
  /// s from the decision instant before it to its own: S1's t runs from −t_acc_before to T1 −
  /// t_acc.
  double span() const noexcept {
    return dwell || profile.present() ? duration : duration + (t_acc_before - t_acc);
  }
};

/// The same with what is done on its way.
struct SegmentDescriptor : SegmentMotion {
  EventsOnTheWay on_the_way{};
};

}  // namespace rob::motion
