#pragma once

#include <cstdint>

#include "motion/generate/position_error.h"
#include "motion/plan/segment_descriptor.h"

namespace rob::motion {

/// An event that motion reports to those above, in order of time. Fixed size; texts are made above.
struct MotionEvent {
  enum class Kind : std::uint8_t {
    SegmentStarted,  ///< tag; number; value: 1 if it has a way to go
    DecisionPoint,   ///< tag; number: what follows this motion must be known by now; reported under
                     ///< the look-ahead law, where it is not known beforehand
    EffectDue,       ///< effect
    LateDecision,    ///< tag: nothing was known at the decision point; the target is made exact
    LeadMissed,      ///< tag; value: s by which a path event came too early, below 0 too late
    LeadCut,         ///< tag; value: s by which a path event comes later than its LEAD asked for,
                     ///< since its motion does not take so long to its place
    Finished,        ///< everything commanded has been done; the axes stand
    Hit,             ///< tag; number: the guard of this motion holds; it brakes
    Braking,         ///< tag; number: it brakes, since it was asked to or its guard has no answer
    Rest,            ///< the Rest that TrajectoryGenerator::take_rest() gives next
    ActionDue,       ///< effect: a WHEN does it
    EffectDropped,   ///< effect: what carried it has ended early
    PulseOver,       ///< effect: the Pulse whose output is off again
    Handling,        ///< tag: of the WHEN whose handler has the axes from here on
    HandlerOver,     ///< they are the program's again; value: 1 if the interrupted motion is over
    Held,            ///< the axes stand on the path by request or by fault; value: share of the
                     ///< segment's time that is done, 0…1
    JogStopped,      ///< axis: a jog goes no further, since this axis is near the end of its way;
                     ///< value: where the axis is, m or rad; axis −1: the arm is near a singular
                     ///< place, or the end of its reach; kAtBody: of the pair `value`, two bodies
                     ///< would come too near (JogRoom::stops)
    WentBack,        ///< tag: the axes stand where this motion had begun; 0: on the way there
    NoWayBack,       ///< what is recorded of their way begins where they stand
    PaceFailed,      ///< tag: what its LivePace computes has no result
    Unsettled,       ///< tag: `off` says how far the robot still is from its SettleWindow
    Overrun,         ///< the tick came too late to be made up; value: how late, s
    Fault            ///< axis: its reference was no number; it has not been handed out
  };

  static constexpr int kAtBody = -2;  ///< `axis` of JogStopped

  Kind kind = Kind::SegmentStarted;
  double time = 0;  ///< s, exact instant since the start of the run, not rounded to periods
  Tag tag = 0;
  std::uint32_t number = 0;
  double value = 0;
  Effect effect{};
  int axis = -1;
  PositionError off{};
};

}  // namespace rob::motion
