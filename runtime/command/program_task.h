#pragma once

#include <cstdint>
#include <optional>

#include "lang/vm/vm.h"
#include "runtime/command/background_tasks.h"
#include "runtime/command/robot_machine.h"

namespace rob::runtime {

/// Runs a program ahead of the motion, a slice at a time, and never blocks: the same object is
/// stepped by the virtual clock and by a thread of its own in real time.
class ProgramTask {
 public:
  enum class State : std::uint8_t {
    Busy,     ///< has more to calculate
    Waiting,  ///< for room in the buffer, a decision point or the next cycle
    Over      ///< all that was commanded is queued
  };

  /// `seed`: of RANDOM.
  /// `test`: one of the chunk's TESTs instead of the program.
  ProgramTask(const lang::Chunk& chunk, RobotMachine& machine,
              std::uint64_t seed = lang::Random::kDefaultSeed,
              std::optional<std::size_t> test = std::nullopt);

  /// A loop that turns so often ends the program as its end would.
  /// The values of PERSIST variables that an earlier run has left; they must outlive this.
  void start_from(const lang::SavedValues& saved) { vm_.start_from(saved); }
  void limit_turns(std::uint32_t most) { vm_.limit_turns(most); }
  /// The line of that loop; 0 if there is none.
  int circling() const { return vm_.circling(); }

  /// At most `budget` instructions.
  State step(std::int64_t budget);

  /// To be called after step(), once in every cycle: runs one of the program's TASKs. `state`: the
  /// last result of step(). Returns the state now, since an error of a TASK is one of the program.
  State run_tasks(State state);
  /// The program waits, but not for the next cycle: it may go on as soon as there is room.
  bool waits_for_room() const { return !failure_ && vm_.state() == lang::Vm::State::Waiting; }
  bool has_tasks() const { return tasks_.any(); }

  /// How the program failed; what it had commanded before is finished all the same. Valid once
  /// step() has returned Over.
  const std::optional<lang::RuntimeError>& failure() const { return failure_; }
  /// Where the program is.
  lang::Place place() const { return vm_.place(); }
  std::int64_t executed() const { return vm_.executed(); }

 private:
  State finish(int line);

  void begin_handler();

  lang::Vm vm_;
  RobotMachine& machine_;
  BackgroundTasks tasks_;
  TaskMachine beside_;             ///< of handlers that do not stop the axes
  std::int64_t tasks_cycle_ = -1;  ///< in which they ran last
  std::optional<lang::RuntimeError> failure_;
};

}  // namespace rob::runtime
