#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include "lang/code/chunk.h"
#include "lang/values/arithmetic.h"
#include "lang/values/setting.h"

/// Code that is evaluated in every control cycle: the conditions of UNTIL and WHEN.
///
/// The code of a watch is a stretch of its chunk that only jumps forward and ends with `answer`.
/// Its first registers hold the values that the program's variables had when the statement was
/// executed, so that nothing of the Vm is touched.
namespace rob::lang {

/// A condition with the values that it was executed with.
struct Watch {
  const Chunk* chunk = nullptr;
  WatchForm form;
  std::array<Slot, kMostWatched> values{};
  Setting setting;  ///< the tool of HERE, and the frame of force and torque
};

/// Where a watch reads the world: one control cycle. Called in the tick.
class WatchedWorld {
 public:
  virtual ~WatchedWorld() = default;
  /// By its index in the RobotSignature.
  virtual bool signal(int signal) const noexcept = 0;
  virtual double analog(int signal) const noexcept = 0;  ///< V
  /// As Machine::read() of an observation, in this cycle, but HERE is the flange.
  virtual void read(Reading what, Slot* value) const noexcept = 0;
};

struct WatchResult {
  ArithmeticError error = ArithmeticError::None;  ///< else there is no value
  Slot value{.integer = 0};
};

/// Takes no memory, calls nothing of the program, and ends after at most kLongestWatch
/// instructions: may be used in the tick.
WatchResult evaluate(const Watch& watch, const WatchedWorld& world) noexcept;

/// Whether evaluate() knows an instruction.
bool is_watchable(Opcode opcode);

}  // namespace rob::lang
