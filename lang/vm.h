#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "lang/chunk.h"
#include "lang/diagnostic.h"
#include "lang/machine.h"

namespace rob::lang {

/// An error of the running program: what a Diagnostic says, found at run time.
struct RuntimeError {
  std::string code;
  Place place;
  std::string message;
  std::string help;
};

/// Executes a Chunk against a Machine. It never blocks: where the program has to wait, run()
/// returns and is called again. `chunk` and `machine` must outlive it.
class Vm {
 public:
  enum class State : std::uint8_t {
    Running,    ///< the budget is used up; call run() again
    Waiting,    ///< the machine said Later; call again when something has changed
    NextCycle,  ///< a loop reads the world again: call again in the next control cycle
    Done,
    Failed      ///< error() says why; what was commanded before stays commanded
  };

  Vm(const Chunk& chunk, Machine& machine);

  /// Executes at most `budget` instructions.
  State run(std::int64_t budget);

  State state() const { return state_; }
  const RuntimeError& error() const { return error_; }
  /// Instructions executed since the start.
  std::int64_t executed() const { return executed_; }

 private:
  const Chunk& chunk_;
  Machine& machine_;
  State state_ = State::Running;
  RuntimeError error_;
  std::int64_t executed_ = 0;
};

}  // namespace rob::lang
