#include <algorithm>
#include <span>
#include <string>
#include <utility>

#include <fmt/core.h>

#include "lang/text/codes.h"
#include "lang/vm/vm.h"

// How runs of the Vm begin and end: its beginning, waits, errors, and the handlers of WHEN. A
// handler is a routine that no statement calls. Its frame lies above all that the interrupted
// program uses.
namespace rob::lang {
namespace {

/// More than a program executes in a year; in bytes of code it still fits 64 bits.
constexpr std::int64_t kMostBudget = std::int64_t{1} << 56;

/// The code before the first entry of the prompt.
const Chunk& no_entry() {
  static const Chunk chunk = [] {
    Chunk empty;
    empty.code.push_back(Instruction::abc(Opcode::end));
    empty.places.push_back({});
    return empty;
  }();
  return chunk;
}

}  // namespace

Vm::Vm(const Chunk& chunk, Machine& machine, std::uint64_t seed)
    : role_(Role::Program),
      machine_(&machine),
      loaded_(chunk),
      next_(chunk.code.data()),
      stack_(chunk),
      budget_(next_),
      instant_(seed, next_) {}

Vm::Vm(const Chunk& chunk, Machine& machine, std::size_t task, TaskStack stack, std::uint64_t seed)
    : role_(Role::Task),
      machine_(&machine),
      loaded_(chunk),
      next_(chunk.code.data() + chunk.task_entry),
      asked_for_(chunk.tasks[task].routine),
      stack_(stack),
      budget_(next_),
      instant_(seed, next_) {}

Vm::Vm(Machine& machine, std::uint64_t seed)
    : role_(Role::Entries),
      state_(State::Done),
      machine_(&machine),
      loaded_(no_entry()),
      next_(no_entry().code.data()),
      budget_(next_),
      instant_(seed, next_) {}

void Vm::choose_test(std::size_t test) {
  asked_for_ = loaded_.chunk->tests.at(test).routine;
  go_on_at(loaded_.chunk->code.data() + loaded_.chunk->test_entry);
  instant_.begin(next_);
}

void Vm::go_on_with(const Chunk& chunk) {
  loaded_ = Loaded(chunk);
  go_on_at(chunk.code.data());
  instant_.begin_anew(next_);
  stack_.release_memory();
  state_ = State::Running;
}

Reply Vm::give_up_entry() {
  const int at = state_ == State::Failed ? line_tag(error().place) : line(next_);
  if (handling()) abandon_handler();
  const Reply ended = settings_.end_presses(*machine_, at, 0);
  if (ended != Reply::Done) return ended;
  settings_.leave(*machine_, at, 0);
  const Reply disarmed = whens_.disarm(*machine_, at, whens_.kept());
  if (disarmed != Reply::Done) return disarmed;
  tries_.drop(0);
  stack_.unwind(0);
  state_ = State::Done;
  return Reply::Done;
}

Vm::State Vm::run(std::int64_t budget) {
  if (state_ == State::Done || state_ == State::Failed || turns_.circling() != nullptr) {
    return state_;
  }
  budget_.grant(std::min(budget, kMostBudget), next_);
  for (;;) {
    if (tries_.rescuing() && !rescue()) return state_ = leave(next_, next_, State::Waiting);
    const bool handled = handling();
    state_ = execute(next_);
    const bool over = handled && !handling() && state_ == State::Running;  // the handler
    if (tries_.rescuing() || over) continue;
    if (state_ != State::Failed) tell_persistent();
    return state_;
  }
}

/// A PATH has its motions planned when it ends: the machine gets what changes in it after it.
Reply Vm::tell_persistent() {
  if (!persistent_.any() || in_path_) return Reply::Done;
  return persistent_.tell(*machine_, line(next_), *loaded_.chunk, stack_);
}

void Vm::go_on_at(Code next) {
  next_ = next;
  budget_.go_on_at(next);
}

Vm::State Vm::leave(Code pc, Code resume, State state) {
  budget_.settle(pc);
  go_on_at(resume);
  if (resume == instant_.latch() && resume != pc) instant_.start_anew();
  // When the program goes on, time has passed; only a used-up budget stays in the current cycle.
  if (state == State::Running) return state;
  instant_.pass();
  // A routine that still runs counts as called in the cycle in which it goes on.
  for (const Stack::Frame& call : stack_.calls()) call.callee->called_in = instant_.cycle();
  return state;
}

Vm::State Vm::pause(Code pc, Code resume, Reply reply) {
  if (reply == Reply::Later) return leave(pc, resume, State::Waiting);
  return fail(pc, machine_->refusal());
}

Vm::State Vm::fail(Code pc, RuntimeError error) {
  const std::span<const Stack::Frame> calls = stack_.calls();
  for (auto call = calls.rbegin(); call != calls.rend(); ++call) {
    const RoutineCode& routine = *call->callee->routine;
    if (routine.handler) {
      error.calls.push_back({routine.name, line_tag(routine.place), CallSite::By::When});
    } else {
      const Place from = place(*call->callee->chunk, call->back - 1);
      error.calls.push_back({.routine = routine.name, .line = line_tag(from)});
    }
  }
  tries_.fail(std::move(error));
  return give_up(pc);
}

Vm::State Vm::fail(Code pc, Refusal why) {
  return fail(pc, RuntimeError{.code = std::move(why.code),
                               .place = why.place.line > 0 ? why.place : place(pc),
                               .message = std::move(why.message),
                               .help = std::move(why.help)});
}

Vm::State Vm::fail(Code pc, ArithmeticError error) { return fail(pc, refusal_of(error)); }

Vm::State Vm::fail_calls_too_deep(Code pc) { return fail(pc, calls_too_deep()); }

Vm::State Vm::fail_index(Code pc, std::int64_t index, std::int64_t count) {
  std::string message =
      fmt::format("there is no element {}: they count from 1 to {}", index, count);
  if (count == 0) message = fmt::format("there is no element {}: it has none at all", index);
  return fail(pc, Refusal{.code = std::string(code::kIndexOutOfRange),
                          .message = std::move(message),
                          .help = ""});
}

/// The error is known: to the innermost TRY block, or to the end.
Vm::State Vm::give_up(Code pc) {
  if (handling() && !tries_.catches(interrupted_->tries)) abandon_handler();
  return leave(pc, pc, tries_.rescuing() ? State::Running : State::Failed);
}

/// Goes on at the RESCUE of the innermost TRY block; false while the machine has not settled.
bool Vm::rescue() {
  const int at = line_tag(error().place);
  if (machine_->settle(at) != Reply::Done) return false;
  const TryBlock& block = tries_.rescuer();
  if (whens_.disarm(*machine_, at, block.whens) != Reply::Done) return false;
  if (settings_.end_presses(*machine_, at, block.presses) != Reply::Done) return false;
  settings_.leave(*machine_, at, block.settings);
  in_path_ = false;
  stack_.unwind(block.depth);
  stack_.texts()[block.why] = tries_.reason();
  tries_.rescue();
  go_on_at(block.rescue);
  return true;
}

void Vm::interrupt(RuntimeError error) {
  question_.forget();
  if (handling()) tries_.drop(interrupted_->tries);  // it is the program's error, not the handler's
  state_ = fail(next_, std::move(error));
}

bool Vm::takes_handlers() const {
  const bool over = state_ == State::Done && role_ != Role::Entries;
  return !handling() && !tries_.rescuing() && turns_.circling() == nullptr && !over &&
         state_ != State::Failed;
}

/// That of the innermost call.
Slots Vm::frame_size() const {
  if (stack_.depth() == 0) return {loaded_.chunk->registers, loaded_.chunk->text_registers};
  const Callee& callee = *stack_.calls().back().callee;
  return {callee.registers, callee.text_registers};
}

void Vm::handle(int when, Machine& machine) {
  const ArmedWhen& armed = whens_.find(when);
  const Code back = next_;
  const Slots size = frame_size();
  interrupted_.emplace(Interrupted{machine_, next_, instant_.expression(), stack_.depth(),
                                   tries_.count(), settings_.settings(), last_guard_});
  machine_ = &machine;
  if (state_ == State::Done) state_ = State::Running;
  if (armed.chunk != loaded_.chunk) {
    interrupted_->loaded = std::exchange(loaded_, Loaded(*armed.chunk));
  }
  go_on_at(armed.handler);
  const std::uint32_t routine = (armed.handler + 1)->word;
  if (!enter(stack_.numbers() + size.numbers, stack_.texts() + size.texts, routine, back)) {
    state_ = fail_calls_too_deep(armed.handler);
    return;
  }
  std::copy_n(armed.captured, armed.handler->b(), stack_.numbers());
  settings_.enter_as_of(*machine_, line(armed.handler), armed.settings);
  go_on_at(loaded_.callees[routine].entry);
  instant_.begin(next_);
}

/// The program goes on as though nothing had been, but for what the handler has changed.
void Vm::end_handler() {
  const Interrupted found = abandon_handler();
  settings_.drop(found.settings);
  go_on_at(found.next);
  instant_.go_on_with(found.expression);
  last_guard_ = found.last_guard;
}

/// An error in a handler is one of the program.
Vm::Interrupted Vm::abandon_handler() {
  Interrupted found = *std::exchange(interrupted_, std::nullopt);
  stack_.unwind(found.depth);
  if (found.loaded) loaded_ = std::move(*found.loaded);
  machine_ = found.machine;
  return found;
}

}  // namespace rob::lang
