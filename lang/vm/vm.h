#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <map>
#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "lang/code/chunk.h"
#include "lang/machine/machine.h"
#include "lang/text/diagnostic.h"
#include "lang/values/random.h"
#include "lang/vm/task_memory.h"

namespace rob::lang {

/// A routine that was running, and the line that called it.
struct CallSite {
  /// What has begun it: a call; START, of a TASK; the condition of a WHEN, of its handler: then the
  /// line is that of the WHEN.
  enum class By : std::uint8_t { Call, Start, When };

  std::string routine;  ///< "WHEN": a handler
  int line = 0;
  By by = By::Call;

  bool operator==(const CallSite&) const = default;
};

/// An error of the running program: what a Diagnostic says, found at run time.
struct RuntimeError {
  std::string code;
  Place place;
  std::string message;
  std::string help;
  std::vector<CallSite> calls{};  ///< the routines it happened in, the innermost first
};

/// How deep calls may be nested. [choice] a recursion that goes deeper has most probably no end.
inline constexpr std::size_t kMostCalls = 1000;
/// What the budget gives for an instruction on long blocks. [choice] copying them takes as long.
inline constexpr std::uint32_t kSlotsAnInstruction = 16;
/// WHENs that can be armed at once, and are looked at in every cycle. [choice] more than needed.
inline constexpr std::size_t kMostWhens = 16;
/// TRY blocks that can be open, those whose RESCUE runs included. [choice] one a call.
inline constexpr std::size_t kMostTries = kMostCalls;

/// Executes a Chunk against a Machine. It never blocks: where the program has to wait, run()
/// returns and is called again. `chunk` and `machine` must outlive it.
///
/// Observations. At standstill a program would see the same world again and again without any time
/// passing; so the first observation after a loop has turned is put off to the next control cycle
/// if the present one was observed before. All observations of one expression belong to one cycle:
/// run() stops for its budget only where a loop turns, which never is inside an expression, and if
/// the machine has to wait in the middle of one, the expression starts anew from its beginning.
///
/// A routine called a second time is like a loop that has turned. It may be called in the middle of
/// an expression: what is observed after the call belongs to a new instant.
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
  Vm(const Chunk& chunk, Machine& machine, std::size_t task, TaskMemory& memory,
     std::uint64_t seed);
  /// For entries of the prompt, which go_on_with() gives it.
  explicit Vm(Machine& machine, std::uint64_t seed = Random::kDefaultSeed);
  Vm(const Vm&) = delete;
  Vm& operator=(const Vm&) = delete;

  /// The next entry of the prompt, compiled behind all that it can name: variables keep their
  /// values, and WHENs of the top level stay armed. The chunk of the entry before stays, too.
  void go_on_with(const Chunk& chunk);
  /// Behind an entry that has Failed, until Done: leaves all that it has opened.
  Reply give_up_entry();
  void forget_whens();  ///< the machine has disarmed them all

  /// Instead of the program: its declarations, then one of Chunk::tests. Before the first run().
  void choose_test(std::size_t test);

  /// Lets no LOOP or WHILE turn more often than that without a motion, counted from where it was
  /// begun: circling() then tells, and the program does not go on. A FOR ends by itself.
  void limit_turns(std::uint32_t most);
  /// The line of the loop that has turned too often; 0 if there is none.
  int circling() const { return circling_; }

  /// Executes until the program has to wait or is over, or `budget` instructions are spent.
  /// The budget is looked at where a loop turns: a run may exceed it by the length of the code.
  State run(std::int64_t budget);

  /// Something went wrong while the program was waiting: it fails with this error where it is.
  void interrupt(RuntimeError error);

  /// A WHEN, by the number of its Machine, has come true: its handler begins and commands
  /// `machine`.
  void handle(int when, Machine& machine);
  /// Whether a handler may begin: none is running, and the program neither is over nor goes wrong.
  bool takes_handlers() const;
  bool handling() const { return handling_; }
  State state() const { return state_; }
  /// Of the instruction that comes next.
  Place place() const { return place(next_); }
  const RuntimeError& error() const { return error_; }
  /// Instructions executed since the start; those that a forward jump passed over count too.
  std::int64_t executed() const { return executed_; }

 private:
  using Code = const Instruction*;

  /// Where execution goes on; null if the run has been left, with that state.
  struct Step {
    Step(Code to) : next(to) {}
    Step(State with) : left(with) {}
    Code next = nullptr;
    State left = State::Running;
  };

  static const Chunk& nothing();
  /// The dispatch loop (vm.cpp).
  State execute(Code pc);
  /// An instruction that the loop hands over (vm_step.cpp).
  Step step(Code pc);
  /// Ends a run: `resume` is where the next one goes on.
  State leave(Code pc, Code resume, State state);
  State fail(Code pc, RuntimeError error);
  State fail(Code pc, ArithmeticError error);
  /// error_ is complete: to the innermost TRY block, or to the end.
  State give_up(Code pc);
  State raise_again(Code pc);
  /// Goes on at the RESCUE of the innermost TRY block; false while the machine has not settled.
  bool rescue();
  bool open_try(Code pc);
  State fail_tries_too_deep(Code pc);
  /// What a reply other than Done to the instruction at `pc` means.
  State pause(Code pc, Code resume, Reply reply);
  static std::intptr_t address(Code pc) { return reinterpret_cast<std::intptr_t>(pc); }
  /// What is left of the budget at an instruction.
  std::int64_t left_at(Code pc) const { return (limit_ - address(pc)) / kWord; }
  /// The frame of a routine that is called, with its first registers; false if the stack is used
  /// up.
  bool enter(Slot* numbers, std::string* texts, std::uint32_t number, Code back);
  /// Into a routine or out of it: from behind the present instruction.
  Step go(Code behind, Code next);
  /// Memory for the frame of a routine, or of the top level; false if there is not so much left.
  bool reserve(Code pc);
  State fail_memory(Code pc);
  void charge(std::uint32_t slots) { limit_ -= slots / kSlotsAnInstruction * kWord; }
  bool append_memory(Code pc);
  // Elements stored by a FOR (vm_fill.cpp)
  Step fill(Code pc, Slot value);
  /// Back to the caller's frame; where its code goes on.
  Code leave_routine();
  std::size_t depth() const { return static_cast<std::size_t>(frame_ - frames_.data()); }
  /// Counts how often loops turn; false if this one has turned too often.
  bool count_turn(Code pc, Code target);
  bool next_cycle_is_due() const { return turned_ && observed_; }
  Reply observe(Code pc);
  Reply observe_analog(Code pc);
  Reply read(Code pc);
  Reply feel(Code pc);
  /// Whether the `read` at `pc` is an observation of the next cycle.
  bool waits_for_cycle(Code pc) const;
  Reply forward(Code pc);
  Reply at_joints(Code pc);
  Reply inverse(Code pc);
  Reply live_pace(Code pc);
  Reply simulate_force(Code pc);
  /// False, with error_ set, if HITPOSE is read before the first guarded motion.
  bool check_hit_pose(Code pc);
  Reply stand(Code pc);
  Watch watch_of(Code pc) const;
  Reply guard(Code pc);
  Reply ended(Code pc);
  Reply simulate(Code pc, double value);
  Reply teach(Code pc);
  Reply ask(Code pc);
  Reply publish(Code pc);
  Reply refresh(Code pc);
  Reply when(Code pc);
  /// Disarms the WHENs beyond the first `kept`.
  Reply disarm(int line, std::size_t kept);
  std::size_t whens_below(std::size_t level) const;
  State fail_too_many_whens(Code pc);
  PathPlace place_of(Code pc) const;
  /// False, with error_ set, if LEAD or LAG turned out to be too long.
  bool check_place(Code pc);
  State fail_timeout(Code pc);

  // WITH, PRESS, OVERRIDE (vm_surroundings.cpp)
  /// What the WITHs say that are open.
  Setting setting() const;
  void enter_setting(Code pc);
  void leave_settings(int line, std::size_t kept);
  PressCommand press_of(Code pc) const;
  /// Ends the PRESSes beyond the first `kept`.
  Reply end_presses(int line, std::size_t kept);
  /// False, with error_ set, if an OVERRIDE turned out to be none.
  bool check_override(Code pc, double share);
  LoadCommand load_of(Code pc) const;
  /// The same if a LOAD turned out to be none.
  bool check_load(Code pc);
  /// The same if the force of a PRESS is no direction, or its LIMIT not above zero.
  bool check_press(Code pc);

  // Motions (vm_motion.cpp): false, with error_ set, if a value turned out to be impossible.
  bool build(Code pc, MoveCommand& command);
  MoveCommand build_plain(Code pc) const;
  bool choose_axis(Code pc, Slot axis, MoveCommand& command);
  bool build_clauses(Code pc, const MoveForm& form, const Slot* next, MoveCommand& command);
  bool check_zone(Code pc, double value, Dimension dimension);
  bool check_positive(Code pc, std::string_view word, double value, Dimension dimension);
  State fail_too_long(Code pc);
  /// False, with error_ set, if a WAIT is for less than no time.
  bool check_wait(Code pc, double seconds);
  /// The same if a PULSE is for no time, or for too long.
  bool check_pulse(Code pc, double seconds);
  /// The same if a SIMULATE is for the past.
  bool check_after(Code pc, double seconds);
  State fail_calls_too_deep(Code pc);
  State fail_index(Code pc, std::int64_t index, std::uint32_t count);
  /// Where a reference leads, and some slots further.
  Slot* place_of(Slot reference, std::uint32_t offset) {
    return number_stack_.data() + reference.integer + offset;
  }
  std::string* text_place_of(Slot reference, std::uint32_t offset) {
    return text_stack_.data() + reference.integer + offset;
  }
  State fail_assertion_at(Code pc);

  Place place(Code pc) const { return place(*chunk_, pc); }
  static Place place(const Chunk& chunk, Code pc) {
    return chunk.places[static_cast<std::size_t>(pc - chunk.code.data())];
  }
  int line(Code pc) const { return line_tag(place(pc)); }
  std::size_t index(Code pc) const { return static_cast<std::size_t>(pc - chunk_->code.data()); }

  static constexpr std::intptr_t kWord = sizeof(Instruction);
  const Chunk* chunk_;
  Machine* machine_;
  bool entries_ = false;        ///< of the prompt
  std::size_t kept_whens_ = 0;  ///< armed by those that are done
  /// What a call comes back to.
  struct Frame {
    Code back;
    Slot* numbers;
    std::string* texts;
    Slots memory;  ///< that was taken
    std::uint32_t routine;
  };

  /// A TRY block that is open, or whose RESCUE runs.
  struct Guard {
    Code rescue;
    std::size_t depth;     ///< calls that were open
    std::uint8_t why;      ///< text register
    bool caught;           ///< the RESCUE runs: it catches nothing more
    std::size_t armed;     ///< WHENs that were armed
    std::size_t settings;  ///< WITHs that were open
    std::size_t presses;   ///< PRESSes that were open
    RuntimeError error{};
  };
  std::vector<Guard> guards_;
  bool rescuing_ = false;  ///< error_ is on its way to a RESCUE

  std::vector<Slot> own_numbers_;  ///< of a TASK: none
  std::vector<std::string> own_texts_;
  /// The stacks: registers, the frame of the top level first; then memory, in the same order. What
  /// a TASK sees of them ends with a part of its own.
  std::span<Slot> number_stack_;
  std::span<std::string> text_stack_;
  Slots registers_;      ///< where registers end
  Slot* registers_end_;  ///< the same, as pointers
  std::string* text_registers_end_;
  Slots memory_;             ///< how much of what lies behind them is taken
  bool background_ = false;  ///< a TASK
  std::vector<Frame> frames_;
  Frame* frame_;   ///< the next one that is free
  Slot* numbers_;  ///< the registers of the present frame
  std::string* texts_;
  /// What a call has to know of a routine, together.
  struct Callee {
    Code entry;
    std::int32_t registers;
    std::int32_t text_registers;
    std::int64_t called_in = 0;  ///< the cycle of its last call
  };
  static std::vector<Callee> callees_of(const Chunk& chunk);
  std::vector<Callee> callees_;
  std::int64_t cycle_ = 1;  ///< counts whenever time may have passed
  std::uint32_t test_ = 0;  ///< its routine
  struct Turns {
    std::uint32_t count = 0;
    std::uint64_t motions = 0;  ///< motions_ then
  };
  std::map<std::size_t, Turns> turns_;  ///< by the first instruction of a loop
  std::uint32_t most_turns_ = 0;        ///< 0: no limit
  std::uint64_t motions_ = 0;           ///< commanded so far
  int circling_ = 0;
  State state_ = State::Running;
  RuntimeError error_;
  Code next_;   ///< where the next run() goes on
  Code latch_;  ///< the `latch` of the expression that is being computed
  Random random_;
  Random latched_random_;      ///< as it was at latch_
  std::int64_t executed_ = 0;  ///< up to the last leave()
  std::int64_t granted_ = 0;   ///< the budget as it was then
  /// The address where the budget is used up, were the code to go straight on: so instructions
  /// pay by being passed, and only what jumps back has to reckon.
  std::intptr_t limit_ = 0;
  bool turned_ = false;  ///< a loop has turned since the last observation
  /// A WHEN that is armed.
  struct Armed {
    std::size_t depth = 0;         ///< calls that were open
    std::uint32_t level = 0;       ///< of its frame
    int id = 0;                    ///< the machine's
    const Chunk* chunk = nullptr;  ///< that the handler is of
    Code handler = nullptr;        ///< its `when_handle`; null: it has none
    Slot* captured = nullptr;      ///< in the frame of the WHEN, which lives as long as it is armed
    std::size_t settings = 0;      ///< that were open
  };
  std::array<Armed, kMostWhens> armed_;
  std::size_t armed_count_ = 0;
  // Handlers (vm_handlers.cpp)
  Reply when_handle(Code pc);
  void end_handler();
  void abandon_handler();
  /// Where a handler has found the program.
  struct Interrupted {
    Machine* machine = nullptr;
    Code next = nullptr;
    Code latch = nullptr;
    Random latched_random{Random::kDefaultSeed};
    bool turned = false;
    std::size_t guards = 0;
    std::size_t settings = 0;
    bool hit = false;
    bool guarded = false;
    const Frame* frame = nullptr;  ///< behind those of the program
    const Chunk* chunk = nullptr;
    std::vector<Callee> callees{};  ///< of the chunk, where the handler is of another one
  };
  Interrupted interrupted_;
  /// At the prompt a handler may be of an earlier entry.
  bool is_elsewhere(const Frame& frame) const {
    return handling_ && interrupted_.chunk != chunk_ && &frame < interrupted_.frame;
  }
  const Chunk& chunk_of(const Frame& frame) const {
    return is_elsewhere(frame) ? *interrupted_.chunk : *chunk_;
  }
  Callee& callee_of(const Frame& frame) {
    return (is_elsewhere(frame) ? interrupted_.callees : callees_)[frame.routine];
  }
  bool handling_ = false;
  std::vector<Setting> settings_;  ///< of the WITHs that are open
  std::size_t presses_ = 0;        ///< that are open
  std::string misread_;            ///< why the last answer to the present ASK could not be taken
  bool guarded_ = false;           ///< a guarded motion has ended
  bool hit_ = false;               ///< the last guarded motion was ended by its guard
  bool observed_ = false;          ///< the world was observed in the present cycle
};

}  // namespace rob::lang

#include "lang/vm/vm_calls.inc"
