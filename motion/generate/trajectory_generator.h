#pragma once

#include <cstdint>

#include "motion/collision/jog_room.h"
#include "motion/generate/motion_event.h"
#include "motion/generate/rest.h"
#include "motion/plan/watch.h"
#include "motion/space/joint_vector.h"

namespace rob::motion {

/// The state of the generator; the numbers stand in the trace.
enum class MotionState : std::uint8_t {
  Idle = 0,
  Running = 1,
  Held = 2,
  Stopping = 3,
  Jogging = 4,
  Pressing = 5  ///< a force is kept beside the path; reported by who keeps it
};

/// One reference and where it comes from.
struct GeneratorSample {
  JointReference reference;
  Tag tag = 0;              ///< of the segment that owns this instant; 0 before the first
  std::uint32_t piece = 0;  ///< number of that segment
  double sigma = 0;         ///< path parameter inside it (Paul: its own time, s)
  double rate = 0;          ///< d sigma / dt (Paul: the time scale, 1 = as planned)
  MotionState state = MotionState::Idle;
  std::uint8_t limit = 0;  ///< what holds the speed (docs/cli.md, trace)
};

/// Makes references on line out of what the LookAheadBuffer holds (S2's kinematic part).
///
/// Its time runs in whole reference periods from the start of the run; transitions happen at
/// their exact instants in between. Every call may be used in the tick: no memory, no lock,
/// bounded work. One thread calls it; hold(), resume() and set_override() come from that thread.
class TrajectoryGenerator {
 public:
  virtual ~TrajectoryGenerator() = default;

  /// Asks all watches about the current cycle, before advance() goes on from it.
  virtual void look(const CycleView& view) noexcept = 0;

  /// Computes every reference up to `period` (the reference stamped period·T) in order, and
  /// returns the last. If `period` lies too far ahead of the last one to be made up
  /// (20 periods or 200 ms, whichever is longer), the path is not followed to where it should
  /// be: it goes on from the last reference into a hold, and an Overrun event says so.
  virtual const GeneratorSample& advance(std::int64_t period) noexcept = 0;

  /// Before the run: jogs keep to this room, which must outlive the generator.
  virtual void keep_to(const JogRoom& room) noexcept = 0;

  /// Slows down on the path to rest, within the limits; resume() speeds up again.
  virtual void hold() noexcept = 0;
  virtual void resume() noexcept = 0;
  /// 0 < share <= 1 of the programmed speed; taken up smoothly.
  virtual void set_override(double share) noexcept = 0;

  // A WHEN with a handler has come true (Rest::Outcome::Handled): the axes stand on the path, and
  // what the handler commands goes through another generator. Handlers are not asked meanwhile.

  /// The axes are back where they left the path; `time`: now.
  virtual void go_on(double time) noexcept = 0;
  /// The handler that was called does not begin: the axes go on, and it is called anew when
  /// handlers may begin and its condition holds.
  virtual void decline_handler(double time) noexcept = 0;
  /// Whether no handler may begin: the program settles an error, or is over.
  virtual void bar_handlers(bool barred) noexcept = 0;
  /// They are not, they stand at `q`: the motion under way has ended (Rest::Outcome::Braked, at
  /// `time`), and all that is queued after it is taken back. An effect between the motions stays
  /// and goes with the motions of the same numbers, which are queued anew; with `all` it is
  /// dropped.
  virtual void leave_path(const JointVector& q, double time, bool all) noexcept = 0;
  /// Nothing has been commanded here, or all of it is done: the axes have been brought to `q`.
  virtual void stand_at(const JointVector& q) noexcept = 0;
  /// The motion under way brakes on its path and ends there (Braked), with all that is queued.
  virtual void brake() noexcept = 0;

  /// The highest segment number at whose decision point the world may be read now: the next call
  /// of advance() will have to know what follows that segment. At rest: the last one done.
  virtual std::uint32_t decidable() const noexcept = 0;

  /// Takes the next event, in order of time; false if there is none. Instants lie up to one
  /// period ahead of the cycle that computed them.
  virtual bool take_event(MotionEvent& event) noexcept = 0;
  /// Takes the next Rest; there is one for every MotionEvent of that kind.
  virtual bool take_rest(Rest& rest) noexcept = 0;
};

}  // namespace rob::motion
