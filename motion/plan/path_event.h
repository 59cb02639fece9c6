#pragma once

#include <cassert>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <type_traits>

#include "motion/dynamics/arm_load.h"
#include "motion/plan/motion_request.h"

namespace rob::motion {

struct WatchedAction;

/// Something that happens in motion order beside the axes: an output, a line of print.
struct Effect {
  enum class Kind : std::uint8_t {
    Output,
    Analog,
    Pulse,
    Simulate,
    SimulateAnalog,
    SimulateForce,  ///< component `channel` of force (N) and torque (Nm) along the world is `volts`
    SimulateGo,
    SimulateAnswer,  ///< `id`
    Note,
    ZeroForce,  ///< what the force sensor tells now is nothing
    Override,   ///< from here on the path's time runs at `share`
    Load,       ///< from here on the arm carries `carried`
    Report,     ///< `id`: the asker learns that its turn has come, or that it is dropped
    Arm,        ///< `watched` is asked from here on
    Disarm      ///< and no longer, whether it was armed or not
  };

  Tag tag = 0;
  Kind kind = Kind::Note;
  bool value = false;        ///< of an Output or Simulate
  bool safe = false;         ///< of an Output or Analog: nothing sets it any more behind this one
  std::uint8_t channel = 0;  ///< of the output or, for Simulate…, the input
  double volts = 0;          ///< of an …Analog: as asked for; the channel carries what it can
  double share = 1;          ///< of an Override, above 0; above 1 is as 1
  double seconds = 0;        ///< of the run: how long a Pulse is on, in how long a Simulate… acts
  std::uint32_t id = 0;      ///< the asker's own
  std::uint32_t after = 0;   ///< number of the segment that carries it; 0: before any motion
  std::uint32_t generation = 1;
  WatchedAction* watched = nullptr;      ///< of Arm and Disarm
  const CarriedLoad* carried = nullptr;  ///< of Load; as long as the run
};

/// Something that happens at a place on the way of a motion.
struct PathEvent {
  double share = 0;  ///< of the leg, 0 … 1
  double lead = 0;   ///< s of the run by which it comes before the place; below 0: behind it
  Effect effect{};   ///< `after`: the number of its motion
};

/// What happens on the way of one motion, as it is written. Motions are copied often and have
/// mostly nothing of it: a copy costs what there is.
class EventsOnTheWay {
 public:
  /// [choice] as many as are on a leg of a seam, and the buffer stays small
  static constexpr std::size_t kMost = 8;

  EventsOnTheWay() noexcept {}
  EventsOnTheWay(const EventsOnTheWay& other) noexcept { *this = other; }
  EventsOnTheWay& operator=(const EventsOnTheWay& other) noexcept {
    if (this == &other) return *this;
    count_ = 0;
    for (const PathEvent& event : other) push_back(event);
    return *this;
  }

  bool full() const noexcept { return count_ == kMost; }
  std::size_t size() const noexcept { return count_; }
  const PathEvent* begin() const noexcept { return events_; }
  const PathEvent* end() const noexcept { return events_ + count_; }
  PathEvent* begin() noexcept { return events_; }
  PathEvent* end() noexcept { return events_ + count_; }
  const PathEvent& operator[](std::size_t i) const noexcept { return events_[i]; }
  void clear() noexcept { count_ = 0; }
  /// Not if it is full.
  void push_back(const PathEvent& event) noexcept {
    assert(!full());
    std::construct_at(events_ + count_++, event);
  }

 private:
  static_assert(std::is_trivially_destructible_v<PathEvent>);

  std::size_t count_ = 0;
  union {
    PathEvent events_[kMost];  // the first `count_` of them exist
  };
};

}  // namespace rob::motion
