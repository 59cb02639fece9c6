#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "lang/code/chunk.h"
#include "lang/code/watch.h"
#include "lang/machine/machine.h"
#include "lang/values/random.h"
#include "lang/vm/active_settings.h"
#include "lang/vm/answer.h"
#include "lang/vm/budget.h"
#include "lang/vm/errors.h"
#include "lang/vm/instant.h"
#include "lang/vm/persistent_values.h"
#include "lang/vm/stack.h"
#include "lang/vm/task_memory.h"
#include "lang/vm/turns.h"
#include "lang/vm/whens.h"

namespace rob::lang {

/// Executes a Chunk against a Machine. It never blocks: where the program must wait, run()
/// returns and is called again. `chunk` and `machine` must outlive it.
///
/// run() stops for its budget only where a loop turns or a routine is called or left; if the
/// machine must wait in the middle of an expression, the expression starts anew from its
/// beginning (Instant).
///
/// Errors take effect in motion order: with a TRY block open, the machine first settles what was
/// commanded before; then the RESCUE goes on in the frame of its TRY.
///
/// Arithmetic, loops, calls, motions, observations take no memory. Texts and TRY blocks do.
class Vm {
 public:
  enum class State : std::uint8_t {
    Running,    ///< the budget is used up; call run() again
    Waiting,    ///< the machine said Later; call again when something has changed
    NextCycle,  ///< a loop reads the world again: call again in the next control cycle
    Done,
    Failed  ///< error() says why; what was commanded before stays commanded
  };

  /// `seed` is where RANDOM begins.
  Vm(const Chunk& chunk, Machine& machine, std::uint64_t seed = Random::kDefaultSeed);
  /// A TASK, by its number, in the memory that they share; run(), state(), error() and executed()
  /// are for it as for a program.
  Vm(const Chunk& chunk, Machine& machine, std::size_t task, TaskStack stack, std::uint64_t seed);
  /// For entries of the prompt, which go_on_with() gives it.
  explicit Vm(Machine& machine, std::uint64_t seed = Random::kDefaultSeed);
  Vm(const Vm&) = delete;
  Vm& operator=(const Vm&) = delete;

  /// The next entry of the prompt, compiled after all that it can name: variables keep their
  /// values, and WHENs of the top level stay armed. The chunk of the entry before stays, too.
  void go_on_with(const Chunk& chunk);
  /// After an entry that has Failed, until Done: leaves all that it has opened.
  Reply give_up_entry();
  void forget_whens() { whens_.forget(); }  ///< the machine has disarmed them all

  /// Instead of the program: its declarations, then one of Chunk::tests. Before the first run().
  void choose_test(std::size_t test);

  /// The values of PERSIST variables that an earlier run has left; they must outlive this.
  void start_from(const SavedValues& saved) { persistent_.start_from(saved); }
  /// Hands the machine the values of PERSIST variables that it does not know yet.
  Reply tell_persistent();

  /// Lets no LOOP or WHILE turn more often than that without a motion, counted from where it was
  /// begun: circling() then is its line, and the program does not go on. A FOR ends by itself.
  void limit_turns(std::uint32_t most) { turns_.limit(most); }
  /// The line of the loop that has turned too often; 0 if there is none.
  int circling() const { return turns_.circling() == nullptr ? 0 : line(turns_.circling()); }

  /// Executes until the program must wait or is over, or `budget` instructions are spent.
  /// The budget is looked at where a loop turns: a run may exceed it by the length of the code.
  State run(std::int64_t budget);

  /// Something went wrong while the program was waiting: it fails with this error where it is.
  void interrupt(RuntimeError error);

  /// A WHEN, by the number of its Machine, has come true: its handler begins and commands
  /// `machine`.
  void handle(int when, Machine& machine);
  /// Whether a handler may begin: none is running, and the program neither is over nor goes wrong.
  bool takes_handlers() const;
  bool handling() const { return interrupted_.has_value(); }
  State state() const { return state_; }
  /// The place of the instruction that comes next.
  Place place() const { return place(next_); }
  const RuntimeError& error() const { return tries_.error(); }
  /// Instructions executed since the start; those that a forward jump passed over count too.
  std::int64_t executed() const { return budget_.executed(); }

 private:
  using Code = const Instruction*;

  /// The kind of code that it executes.
  enum class Role : std::uint8_t { Program, Task, Entries };

  /// Where execution goes on; null if the run has been left, with that state.
  struct Step {
    Step(Code to) : next(to) {}
    Step(State with) : left(with) {}
    Code next = nullptr;
    State left = State::Running;
  };

  /// The code that is executed, with all that calls must know of it.
  struct Loaded {
    explicit Loaded(const Chunk& of) : chunk(&of), callees(callees_of(of)) {}
    const Chunk* chunk;
    std::vector<Callee> callees;
  };

  /// The last motion with UNTIL.
  struct LastGuard {
    bool ended = false;
    bool hit = false;  ///< its condition has ended it
  };

  /// Where a handler has found the program.
  struct Interrupted {
    Machine* machine;
    Code next;
    Instant::Expression expression;
    std::size_t depth;
    std::size_t tries;
    std::size_t settings;
    LastGuard last_guard;
    std::optional<Loaded> loaded{};  ///< the program's, where the handler is of an earlier entry
  };

  // The dispatch loop (vm.cpp)
  State execute(Code pc);
  bool enter(Slot* numbers, std::string* texts, std::uint32_t routine, Code back);

  // The instructions that it hands over (vm_step.cpp), each kind to the next
  Step compute_on_texts(Code pc);
  Step step(Code pc);
  Step step_observation(Code pc);
  Step step_motion(Code pc);
  Step step_control(Code pc);
  Step step_command(Code pc);
  Step fill(Code pc, Slot value);
  Step go(Code end, Code next);
  Step end_guard(Code pc);
  Step read_rows(Code pc);
  Step arm(Code pc);
  Step open_try(Code pc);
  Watch watch(Code pc) const;

  // Runs, and what ends or interrupts them (vm_run.cpp)
  void go_on_at(Code next);
  /// Ends a run: `resume` is where the next one goes on.
  State leave(Code pc, Code resume, State state);
  /// The instruction at `pc` got a reply other than Done.
  State pause(Code pc, Code resume, Reply reply);
  State fail(Code pc, RuntimeError error);
  State fail(Code pc, Refusal why);
  State fail(Code pc, ArithmeticError error);
  State fail_calls_too_deep(Code pc);
  State fail_index(Code pc, std::int64_t index, std::int64_t count);
  State give_up(Code pc);
  bool rescue();
  Slots frame_size() const;
  void end_handler();
  Interrupted abandon_handler();

  Place place(Code pc) const { return place(*loaded_.chunk, pc); }
  static Place place(const Chunk& chunk, Code pc) {
    return chunk.places[static_cast<std::size_t>(pc - chunk.code.data())];
  }
  int line(Code pc) const { return line_tag(place(pc)); }

  Role role_;
  State state_ = State::Running;
  Machine* machine_;
  Loaded loaded_;
  Code next_;                    ///< where the next run() goes on
  std::uint32_t asked_for_ = 0;  ///< the routine of the TEST or TASK
  Stack stack_;
  Budget budget_;
  Instant instant_;
  LoopTurns turns_;
  TryBlocks tries_;
  ArmedWhens whens_;
  ActiveSettings settings_;
  Question question_;
  PersistentValues persistent_;
  bool in_path_ = false;  ///< a PATH is planned: its motions are not commanded yet
  LastGuard last_guard_;
  std::optional<Interrupted> interrupted_;  ///< a handler runs
};

/// Into a routine whose first registers these are; false if the stack is used up. In every call:
/// here, so that the dispatch loop has it in line.
inline bool Vm::enter(Slot* numbers, std::string* texts, std::uint32_t routine, Code back) {
  Callee& callee = loaded_.callees[routine];
  if (!stack_.enter(numbers, texts, callee, back)) return false;
  instant_.call(callee.called_in);
  return true;
}

}  // namespace rob::lang
