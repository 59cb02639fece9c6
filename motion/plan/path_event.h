#pragma once

#include <array>
#include <cassert>
#include <cstddef>
#include <cstdint>
#include <memory>

#include "motion/dynamics/arm_load.h"
#include "motion/plan/boxed.h"
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
    ZeroForce,  ///< what the force sensor reports now is nothing
    Override,   ///< from here on the path's time runs at `share`
    Load,       ///< from here on the arm carries `carried`
    Report,     ///< `id`: the asker learns that its turn has come, or that it is dropped
    Arm,        ///< `watched` is asked from here on
    Disarm      ///< and no longer, whether it was armed or not
  };

  Tag tag = 0;
  Kind kind = Kind::Note;
  bool value = false;        ///< of an Output or Simulate
  bool safe = false;         ///< of an Output or Analog: nothing sets it any more after this one
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
  double lead = 0;   ///< s of the run by which it comes before the place; below 0: after it
  Effect effect{};   ///< `after`: the number of its motion
};

/// The path events of one motion in the order of the program; most motions have none.
class EventsOnTheWay {
 public:
  /// [choice] as many as are on a leg of a seam
  static constexpr std::size_t kMost = 8;

  bool full() const noexcept { return size() == kMost; }
  std::size_t size() const noexcept { return list_->count; }
  const PathEvent* begin() const noexcept { return list_->events.data(); }
  const PathEvent* end() const noexcept { return begin() + size(); }
  const PathEvent& operator[](std::size_t i) const noexcept { return list_->events[i]; }
  void clear() noexcept { list_.clear(); }
  /// Not if it is full.
  void push_back(const PathEvent& event) {
    assert(!full());
    List list = *list_;
    list.events[list.count++] = event;
    list_ = list;
  }
  /// `change` is called with every event; other copies stay as they are.
  template <typename Change>
  void change_each(Change change) {
    if (size() == 0) return;
    List list = *list_;
    for (std::size_t i = 0; i < list.count; ++i) change(list.events[i]);
    list_ = list;
  }
  std::shared_ptr<const void> box() const noexcept { return list_.box(); }

 private:
  struct List {
    std::size_t count = 0;
    std::array<PathEvent, kMost> events;
  };

  Boxed<List> list_;
};

}  // namespace rob::motion
