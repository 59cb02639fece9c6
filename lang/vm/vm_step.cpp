#include <algorithm>
#include <bit>
#include <string>
#include <string_view>
#include <utility>

#include <fmt/core.h>

#include "lang/text/codes.h"
#include "lang/vm/commands.h"
#include "lang/vm/csv_rows.h"
#include "lang/vm/observations.h"
#include "lang/vm/value_instructions.h"
#include "lang/vm/vm.h"

// The instructions that the dispatch loop of the Vm hands over, kind by kind: a function gives the
// next one all that it does not know.
namespace rob::lang {
namespace {

constexpr double kSameTime = 1e-9;  // s: sums of cycles that differ by less are one

/// fill_element itself, for_next_int and loop.
constexpr std::int64_t kWordsAFill = 3 + 1 + 1;

Refusal no_hit_pose() {
  return {.code = std::string(code::kNoHit),
          .message = "there is no HITPOSE yet: no motion with UNTIL has been executed",
          .help = "MOVE(140, 40, 0) UNTIL touched comes first"};
}

Refusal timeout(bool of_receive) {
  return {.code = std::string(code::kTimeout),
          .message = of_receive ? "timeout: the device has sent no line in time"
                                : "timeout: what this WAIT waits for did not come in time",
          .help = "an ELSE after TIMEOUT says what to do then"};
}

Refusal assertion_failed(std::string_view condition) {
  return {.code = std::string(code::kAssertionFailed),
          .message = fmt::format("ASSERT {} does not hold", condition),
          .help = ""};
}

Refusal raised(const std::string& text) {
  return {.code = std::string(code::kRaised),
          .message = text,
          .help = text.empty() ? "the text after this RAISE is empty" : ""};
}

Refusal too_large_to_keep() {
  return {.code = std::string(code::kPersistTooLarge),
          .message = "a PERSIST variable has a value of more than 1 MiB",
          .help = "keep what the next run needs"};
}

/// Whether what was assigned before belongs before it in motion order.
bool follows_values(Opcode opcode) {
  switch (opcode) {
    case Opcode::move:
    case Opcode::move_to:
    case Opcode::begin_path:
    case Opcode::press:
    case Opcode::end_press:
    case Opcode::stop:
    case Opcode::brake:
    case Opcode::wait:
    case Opcode::waited:
    case Opcode::halt:
    case Opcode::ask:
    case Opcode::read_rows:
    case Opcode::zero_force:
    case Opcode::leave_handler:
    case Opcode::end:
      return true;
    default:
      return false;
  }
}

/// How many steps stay between 0 and `length` - 1.
std::int64_t steps_within(std::uint64_t index, std::int64_t step, std::uint64_t length) {
  const auto by = static_cast<std::uint64_t>(step);
  return static_cast<std::int64_t>(step < 0 ? index / (0 - by) : (length - 1 - index) / by);
}

}  // namespace

#define ROB_CHECKED(operation)                                  \
  do {                                                          \
    const ArithmeticError error = (operation);                  \
    if (error != ArithmeticError::None) return fail(pc, error); \
  } while (false)
#define ROB_SOUND(objection)                                           \
  do {                                                                 \
    if (Objection why = (objection)) return fail(pc, std::move(*why)); \
  } while (false)
#define ROB_ASK(call, resume)                                  \
  do {                                                         \
    const Reply reply = (call);                                \
    if (reply != Reply::Done) return pause(pc, resume, reply); \
  } while (false)
// An observation: of the next cycle, where a loop has turned since the last one.
#define ROB_OBSERVE(call, resume)                                   \
  do {                                                              \
    if (instant_.due()) return leave(pc, resume, State::NextCycle); \
    ROB_ASK(instant_.seen(call), resume);                           \
  } while (false)
#define ROB_IF(name, condition) \
  case Opcode::name:            \
    return pc + ((condition) ? 2 + (pc + 1)->distance() : 2)

/// Texts in registers, and single ones elsewhere.
Vm::Step Vm::compute_on_texts(Code pc) {
  Objection why;
  const Code next = step_text(pc, *loaded_.chunk, stack_, why);
  if (why) [[unlikely]]
    return fail(pc, std::move(*why));
  return next;
}

/// Computing.
Vm::Step Vm::step(Code pc) {
  Slot* const n = stack_.numbers();
  switch (pc->opcode()) {
    case Opcode::fill_element:
      return fill(pc, n[pc->a()]);
    case Opcode::fill_element_constant:
      return fill(pc, loaded_.chunk->constants[pc->a()]);
    case Opcode::random:
      n[pc->a()].real = instant_.random().share();
      return pc + 1;
    case Opcode::random_int: {
      Slot* const range = &n[pc->a()];
      ROB_CHECKED(instant_.random().between(range[0].integer, range[1].integer, range[0].integer));
      return pc + 1;
    }
    case Opcode::random_real: {
      Slot* const range = &n[pc->a()];
      ROB_CHECKED(instant_.random().between(range[0].real, range[1].real, range[0].real));
      return pc + 1;
    }
    case Opcode::leave_with_text:
      if (pc->a() != 0) stack_.texts()[0].swap(stack_.texts()[pc->a()]);
      return go(pc + 1, stack_.leave());
    default: {
      Objection why;
      const Code next = step_value(pc, *loaded_.chunk, stack_, budget_, why);
      if (why) return fail(pc, std::move(*why));
      return next != pc ? next : step_observation(pc);
    }
  }
}

/// Looking at the world, and asking the machine.
Vm::Step Vm::step_observation(Code pc) {
  Slot* const n = stack_.numbers();
  switch (pc->opcode()) {
    case Opcode::latch:
      instant_.latch(pc);
      return pc + 1;
    case Opcode::read_signal:
      ROB_OBSERVE(read_signal(*machine_, line(pc), pc, n), pc);
      return pc + 1;
    case Opcode::read_latched:
      ROB_OBSERVE(read_signal(*machine_, line(pc), pc, n), instant_.latch());
      return pc + 1;
    case Opcode::read_group:
      ROB_OBSERVE(read_group(*machine_, line(pc), pc, n), pc);
      return pc + 2;
    case Opcode::read_group_latched:
      ROB_OBSERVE(read_group(*machine_, line(pc), pc, n), instant_.latch());
      return pc + 2;
    case Opcode::write_group:
    case Opcode::simulate_group:
      ROB_SOUND(check_group(*pc, (pc + 1)->word, &n[pc->a()]));
      ROB_ASK(set_group(*machine_, line(pc), *pc, static_cast<int>((pc + 1)->word), &n[pc->a()]),
              pc);
      return pc + 2;
    case Opcode::read_analog:
      ROB_OBSERVE(read_analog(*machine_, line(pc), pc, n), pc);
      return pc + 1;
    case Opcode::read_analog_latched:
      ROB_OBSERVE(read_analog(*machine_, line(pc), pc, n), instant_.latch());
      return pc + 1;
    case Opcode::read: {
      const auto what = static_cast<Reading>(pc->b());
      const Code resume = pc->c() != 0 ? instant_.latch() : pc;
      if (what == Reading::HitPose && !last_guard_.ended) return fail(pc, no_hit_pose());
      if (is_observation(what)) {
        ROB_OBSERVE(read_value(*machine_, line(pc), pc, n, settings_.setting(), *loaded_.chunk),
                    resume);
      } else {
        ROB_ASK(read_value(*machine_, line(pc), pc, n, settings_.setting(), *loaded_.chunk),
                resume);
      }
      return pc + 1;
    }
    case Opcode::exists:
      ROB_OBSERVE(exists(*machine_, line(pc), pc, n, stack_.texts()),
                  pc->c() != 0 ? instant_.latch() : pc);
      return pc + 1;
    case Opcode::read_hit:
      n[pc->a()].integer = last_guard_.hit ? 1 : 0;
      return pc + 1;
    case Opcode::stand:
      turns_.forget(pc);  // a WAIT that looks again is no loop
      ROB_OBSERVE(machine_->stand(line(pc), n[pc->a()].real), pc);
      return pc + 1;
      ROB_IF(if_elapsed, n[pc->a()].real - n[pc->b()].real >= n[pc->c()].real - kSameTime);
      ROB_IF(if_assumed, machine_->taken_as_met(line(pc)));
    case Opcode::forward:
      ROB_ASK(forward(*machine_, line(pc), pc, n, *loaded_.chunk), pc);
      return pc + 1;
    case Opcode::at_joints:
      ROB_ASK(at_joints(*machine_, line(pc), pc, n, *loaded_.chunk), pc);
      return pc + 2;
    case Opcode::inverse:
      ROB_ASK(inverse(*machine_, line(pc), pc, n, *loaded_.chunk), pc);
      return pc + 2;
    // The globals of a TASK are those that all TASKs see.
    case Opcode::publish:
      if (role_ == Role::Task) return pc + 2;
      ROB_ASK(publish(*machine_, line(pc), pc, stack_, budget_), pc);
      return pc + 2;
    case Opcode::publish_list:
      ROB_ASK(publish_list(*machine_, line(pc), pc, stack_, budget_), pc);
      return pc + 1;
    case Opcode::refresh:
      if (role_ == Role::Task) return pc + 3;
      ROB_OBSERVE(refresh(*machine_, line(pc), pc, stack_, budget_),
                  pc->c() != 0 ? instant_.latch() : pc);
      return pc + 3;
    default:
      return step_motion(pc);
  }
}

/// Motions, and what else the machine gets that depends on more than registers.
Vm::Step Vm::step_motion(Code pc) {
  if (persistent_.any() && follows_values(pc->opcode())) {
    next_ = pc;
    const Reply reply = tell_persistent();
    if (reply == Reply::Refused && persistent_.too_large()) return fail(pc, too_large_to_keep());
    if (reply != Reply::Done) return pause(pc, pc, reply);
  }
  const Slot* const n = stack_.numbers() + pc->a();
  std::string* const t = stack_.texts();
  switch (pc->opcode()) {
    case Opcode::move: {
      MoveCommand command;
      ROB_SOUND(build_move(loaded_.chunk->moves[pc->x()], n, command));
      take_defaults(settings_.defaults(), command);
      ROB_ASK(machine_->move(line(pc), command), pc);
      turns_.moved();
      return pc + 1;
    }
    case Opcode::move_to: {
      const MoveForm& form = loaded_.chunk->moves[pc->x()];
      MoveCommand command = plain_move(form, pc + 1);
      take_defaults(settings_.defaults(), command);
      ROB_ASK(machine_->move(line(pc), command), pc);
      turns_.moved();
      return pc + 1 + 2 * plain_values(form);
    }
    case Opcode::via: {
      MoveCommand point;
      ROB_SOUND(build_move(loaded_.chunk->moves[pc->x()], n, point));
      ROB_ASK(machine_->via(line(pc), point), pc);
      return pc + 1;
    }
    case Opcode::live_pace: {
      const auto means = static_cast<MoveCommand::Pace>((pc + 1)->word);
      ROB_ASK(machine_->live_pace(line(pc), watch(pc), means), pc);
      return pc + 2;
    }
    case Opcode::with:
      settings_.enter(*machine_, line(pc), setting_of(pc->b(), n, settings_.setting()));
      return pc + 1;
    case Opcode::allow:
      settings_.enter(*machine_, line(pc),
                      allowing(loaded_.chunk->allowed[pc->x()], settings_.setting()));
      return pc + 1;
    case Opcode::end_with:
      settings_.leave(*machine_, line(pc), settings_.settings() - 1);
      return pc + 1;
    case Opcode::enter_defaults:
    case Opcode::set_defaults: {
      MoveCommand clauses;
      ROB_SOUND(build_defaults(loaded_.chunk->moves[pc->x()], n, line(pc), clauses));
      if (pc->opcode() == Opcode::enter_defaults) settings_.enter(clauses);
      if (pc->opcode() == Opcode::set_defaults) settings_.set_defaults(clauses);
      return pc + 1;
    }
    case Opcode::on_the_way: {
      PathPlace at;
      ROB_SOUND(build_path_place(pc->b() != 0, n, place(pc), at));
      ROB_ASK(machine_->on_the_way(line(pc), at), pc);
      return pc + 1;
    }
    case Opcode::carry: {
      LoadCommand load;
      ROB_SOUND(build_load(pc->b() != 0, n, settings_.setting(), load));
      ROB_ASK(machine_->carry(line(pc), load), pc);
      return pc + 1;
    }
    case Opcode::guard:
      ROB_ASK(machine_->guard(line(pc), watch(pc)), pc);
      return pc + 1;
    case Opcode::ended:
      return end_guard(pc);
    case Opcode::press: {
      PressCommand command;
      ROB_SOUND(build_press(pc->b(), n, command));
      ROB_ASK(settings_.press(*machine_, line(pc), command), pc);
      return pc + 1;
    }
    case Opcode::end_press:
      ROB_ASK(settings_.end_presses(*machine_, line(pc), settings_.presses() - 1), pc);
      return pc + 1;
    case Opcode::ask:
      ROB_ASK(question_.ask(*machine_, line(pc), t[pc->a()], loaded_.chunk->types[(pc + 1)->word],
                            stack_.numbers(), t, pc->b()),
              pc);
      return pc + 2;
    case Opcode::teach: {
      Slot* const pose = &stack_.numbers()[pc->a()];
      Slot* const joints = &stack_.numbers()[pc->b()];
      TaughtPoint point = taught_point(*loaded_.chunk, pc, pose, joints, settings_.setting());
      ROB_ASK(machine_->teach(line(pc), point), pc);
      take_kept(point, *loaded_.chunk, pose, {joints, pc->c()});
      return pc + 3;
    }
    case Opcode::send:
      ROB_ASK(machine_->send(line(pc), pc->x(), t[pc->a()]), pc);
      return pc + 1;
    case Opcode::receive: {
      bool came = false;
      std::string& text = stack_.texts()[pc->a()];
      turns_.forget(pc);  // it waits, and is no loop
      ROB_OBSERVE(
          machine_->receive(line(pc), (pc + 1)->word, stack_.numbers()[pc->b()].real, text, came),
          pc);
      stack_.numbers()[pc->c()].integer = came ? 1 : 0;
      return pc + 2;
    }
    case Opcode::simulate_line:
      ROB_SOUND(check_command(pc->opcode(), n));
      ROB_ASK(machine_->simulate_line(line(pc), (pc + 1)->word, t[pc->b()], n[1].real), pc);
      return pc + 2;
    case Opcode::read_rows:
      return read_rows(pc);
    case Opcode::persist:
      switch (pc->a()) {
        case 0:
          persistent_.change(pc->x());
          return pc + 1;
        case 1:
          persistent_.lend(pc->x());
          return pc + 1;
        default:
          persistent_.take_back(pc->x());
          return pc + 1;
      }
    case Opcode::restore:
      ROB_SOUND(persistent_.restore(loaded_.chunk->persists[pc->x()], pc->x(), stack_));
      return pc + 1;
    case Opcode::begin_path:
      ROB_ASK(machine_->begin_path(line(pc)), pc);
      in_path_ = true;
      return pc + 1;
    case Opcode::end_path:
      ROB_ASK(machine_->end_path(line(pc)), pc);
      in_path_ = false;
      return pc + 1;
    case Opcode::start:
      ROB_ASK(machine_->start(place(pc), (pc + 1)->word), pc);
      return pc + 2;
    default:
      return step_control(pc);
  }
}

/// WHEN, errors, and the end.
Vm::Step Vm::step_control(Code pc) {
  const std::string* const t = stack_.texts();
  switch (pc->opcode()) {
    case Opcode::when:
      return arm(pc);
    case Opcode::when_handle: {
      ROB_ASK(machine_->when_handle(line(pc), pc->c() != 0), pc);
      ArmedWhen& when = whens_.last();
      when.chunk = loaded_.chunk;
      when.handler = pc;
      when.captured = stack_.numbers() + pc->a();
      when.settings = settings_.settings();
      return pc + 2;
    }
    case Opcode::leave_handler:
      ROB_ASK(machine_->leave_handler(line(pc)), pc);
      leave(pc + 1, pc, State::Running);
      end_handler();
      return State::Running;
    case Opcode::disarm:
      ROB_ASK(whens_.disarm(*machine_, line(pc), whens_.below(stack_.depth(), pc->x())), pc);
      return pc + 1;
    case Opcode::open_try:
      return open_try(pc);
    case Opcode::leave_try:
      ROB_ASK(machine_->leave_block(line(pc)), pc);
      tries_.close();
      return pc + 1;
    case Opcode::leave_rescue:
      tries_.close();
      return pc + 1;
    case Opcode::raise:
      return fail(pc, raised(t[pc->a()]));
    case Opcode::raise_again:
      tries_.fail_again();
      return give_up(pc);
    case Opcode::fail_timeout:
      return fail(pc, timeout(pc->a() != 0));
    case Opcode::fail_assertion:
      return fail(pc, assertion_failed(loaded_.chunk->texts[(pc + 1)->word]));
    case Opcode::call_test:  // or a TASK
      if (!enter(stack_.numbers() + pc->a(), stack_.texts() + pc->b(), asked_for_, pc + 1)) {
        return fail_calls_too_deep(pc);
      }
      return go(pc + 1, loaded_.callees[asked_for_].entry);
    case Opcode::end:
      if (role_ != Role::Entries) ROB_ASK(machine_->end(line(pc)), pc);
      whens_.keep();
      return leave(pc + 1, pc, State::Done);
    default:
      return step_command(pc);
  }
}

/// Commands that stand in the registers as they are.
Vm::Step Vm::step_command(Code pc) {
  const Slot* const n = stack_.numbers() + pc->a();
  ROB_SOUND(check_command(pc->opcode(), n));
  ROB_ASK(tell(*machine_, place(pc), *pc, n, stack_.texts()), pc);
  return pc + 1;
}

/// Into a routine or out of it; the current instruction ends at `end`.
Vm::Step Vm::go(Code end, Code next) {
  if (budget_.jump(end, next)) return next;
  return leave(next, next, State::Running);
}

/// Stores, and makes at once those turns of the loop around it that neither the budget nor the
/// array's end stops; they cost what they would cost one by one.
Vm::Step Vm::fill(Code pc, Slot value) {
  Slot* const n = stack_.numbers();
  Slot* const loop = &n[pc->b()];
  const std::uint32_t length = (pc + 2)->word;
  const auto which = static_cast<std::uint64_t>(loop[0].integer) - 1;
  if (which >= length) return fail_index(pc, loop[0].integer, length);
  Slot* element = stack_.place(n[pc->c()], (pc + 1)->word) + which;
  *element = value;
  if (loop[1].integer == 0) return pc + 3;
  const std::int64_t step = loop[2].integer;
  const std::int64_t turns =
      std::max<std::int64_t>(0, std::min({loop[1].integer, steps_within(which, step, length),
                                          budget_.turns_left(pc, kWordsAFill)}));
  if (turns == 0) return pc + 3;
  for (std::int64_t turn = 0; turn < turns; ++turn) *(element += step) = value;
  loop[0].integer += turns * step;
  loop[1].integer -= turns;
  budget_.pay(turns * kWordsAFill);
  instant_.turn();
  return pc + 3;
}

Watch Vm::watch(Code pc) const {
  const Chunk& chunk = *loaded_.chunk;
  return watch_of(chunk, chunk.watches[pc->x()], stack_.numbers() + pc->a(), settings_.setting());
}

Vm::Step Vm::end_guard(Code pc) {
  bool hit = false;
  const Reply reply = instant_.seen(machine_->ended(line(pc), hit));
  if (reply != Reply::Later) last_guard_ = {.ended = true, .hit = hit};
  if (reply != Reply::Done) return pause(pc, pc, reply);
  stack_.numbers()[pc->a()].integer = hit ? 1 : 0;
  return pc + 1;
}

/// All of the file is read before anything of the variable changes.
Vm::Step Vm::read_rows(Code pc) {
  const std::string& file = stack_.texts()[pc->a()];
  std::string text;
  ROB_ASK(machine_->read_file(line(pc), file, text), pc);
  const Type& type = loaded_.chunk->types[(pc + 1)->word];
  const bool list = type.is(Type::Kind::List);
  auto read = read_csv(file, text, type.detail->element,
                       list ? std::nullopt : std::optional<std::size_t>(type.detail->length));
  if (Refusal* const why = std::get_if<Refusal>(&read)) return fail(pc, std::move(*why));
  CsvRows& rows = std::get<CsvRows>(read);
  for (Refusal& warning : rows.warnings) machine_->warn(line(pc), std::move(warning));
  budget_.charge(text.size());
  const Slot* const n = stack_.numbers();
  if (list) {
    Objection why = stack_.lists().fill(stack_.list_at(n[pc->b()]), rows.numbers.data(),
                                        rows.texts.data(), rows.count);
    if (why) return fail(pc, std::move(*why));
    return pc + 2;
  }
  if (!rows.numbers.empty()) std::ranges::copy(rows.numbers, stack_.place(n[pc->b()], 0));
  if (!rows.texts.empty()) std::ranges::move(rows.texts, stack_.text_place(n[pc->c()], 0));
  return pc + 2;
}

Vm::Step Vm::arm(Code pc) {
  if (whens_.full()) return fail(pc, too_many_whens());
  ArmedWhen when{.depth = stack_.depth(), .level = (pc + 1)->word};
  ROB_ASK(machine_->when(line(pc), watch(pc), when.id), pc);
  whens_.arm(when);
  return pc + 2;
}

Vm::Step Vm::open_try(Code pc) {
  if (tries_.full()) return fail(pc, tries_too_deep());
  const Code jump = pc + 1;
  tries_.open({.rescue = jump + 1 + jump->distance(),
               .why = pc->a(),
               .depth = stack_.depth(),
               .whens = whens_.count(),
               .settings = settings_.settings(),
               .presses = settings_.presses()});
  return pc + 2;
}

#undef ROB_CHECKED
#undef ROB_SOUND
#undef ROB_ASK
#undef ROB_OBSERVE
#undef ROB_IF

}  // namespace rob::lang
