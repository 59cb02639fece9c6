#include <algorithm>
#include <bit>
#include <cstring>
#include <string>
#include <utility>

#include "lang/text/codes.h"
#include "lang/values/builtins.h"
#include "lang/values/number_text.h"
#include "lang/values/pose_functions.h"
#include "lang/values/value_text.h"
#include "lang/vm/texts.h"
#include "lang/vm/vm.h"

/// Member functions of Vm that execute the instructions that its dispatch loop hands over.
namespace rob::lang {
namespace {

constexpr double kSameTime = 1e-9;  // s: sums of cycles that differ by less are one

bool equal_slots(const Slot* a, const Slot* b, std::size_t count) {
  return std::memcmp(a, b, count * sizeof(Slot)) == 0;
}

void copy_texts(std::string* to, const std::string* from, std::size_t count) {
  if (to < from) {
    std::copy(from, from + count, to);
  } else if (to > from) {
    std::copy_backward(from, from + count, to + count);
  }
}

}  // namespace

Vm::Step Vm::go(Code behind, Code next) {
  limit_ += address(next) - address(behind);
  return limit_ > address(next) ? Step(next) : Step(leave(next, next, State::Running));
}

#define ROB_CHECKED(operation)                                  \
  do {                                                          \
    const ArithmeticError error = (operation);                  \
    if (error != ArithmeticError::None) return fail(pc, error); \
  } while (false)
#define ROB_IF(name, condition) \
  case Opcode::name:            \
    return pc + ((condition) ? 2 + (pc + 1)->distance() : 2)
#define ROB_ASK(call, resume)                                  \
  do {                                                         \
    const Reply reply = (call);                                \
    if (reply != Reply::Done) return pause(pc, resume, reply); \
  } while (false)

Vm::Step Vm::step(Code pc) {
  Slot* const n = numbers_;
  switch (pc->opcode()) {
    case Opcode::load_constant_wide:
      n[pc->a()] = chunk_->constants[(pc + 1)->word];
      return pc + 2;
    case Opcode::call_text:
      ROB_CHECKED(builtins()[pc->c()].text(&n[pc->a()], &texts_[pc->b()]));
      return pc + 1;
    case Opcode::pose_angle:
      pose_functions::angle(&n[pc->b()], pc->c(), n[pc->a()]);
      return pc + 1;
    case Opcode::forward:
      ROB_ASK(forward(pc), pc);
      return pc + 1;
    case Opcode::at_joints:
      ROB_ASK(at_joints(pc), pc);
      return pc + 2;
    case Opcode::inverse:
      ROB_ASK(inverse(pc), pc);
      return pc + 2;
    case Opcode::random:
      n[pc->a()].real = random_.share();
      return pc + 1;
    case Opcode::random_int: {
      Slot* const range = &n[pc->a()];
      ROB_CHECKED(random_.between(range[0].integer, range[1].integer, range[0].integer));
      return pc + 1;
    }
    case Opcode::random_real: {
      Slot* const range = &n[pc->a()];
      ROB_CHECKED(random_.between(range[0].real, range[1].real, range[0].real));
      return pc + 1;
    }
#include "lang/vm/vm_memory.inc"
    case Opcode::leave_with_text:
      if (pc->a() != 0) texts_[0] = texts_[pc->a()];
      return go(pc + 1, leave_routine());
    case Opcode::equal_text:
      n[pc->a()].integer = texts_[pc->b()] == texts_[pc->c()] ? 1 : 0;
      return pc + 1;
    case Opcode::less_text:  // UTF-8 sorts by bytes as by code points
      n[pc->a()].integer = texts_[pc->b()] < texts_[pc->c()] ? 1 : 0;
      return pc + 1;
    case Opcode::less_equal_text:
      n[pc->a()].integer = texts_[pc->b()] <= texts_[pc->c()] ? 1 : 0;
      return pc + 1;
    case Opcode::load_text:
      texts_[pc->a()] = chunk_->texts[(pc + 1)->word];
      return pc + 2;
    case Opcode::copy_text:
      texts_[pc->a()] = texts_[pc->b()];
      return pc + 1;
    case Opcode::join_text:
      if (!join(texts_[pc->a()], texts_[pc->b()], texts_[pc->c()])) return fail_too_long(pc);
      return pc + 1;
    case Opcode::append_int:
      if (!append(texts_[pc->a()], std::to_string(n[pc->b()].integer))) return fail_too_long(pc);
      return pc + 1;
    case Opcode::append_real:
      if (!append(texts_[pc->a()], number_text(n[pc->b()].real, chunk_->dimensions[pc->c()]))) {
        return fail_too_long(pc);
      }
      return pc + 1;
    case Opcode::append_bool:
      if (!append(texts_[pc->a()], text_of(n[pc->b()].integer != 0))) return fail_too_long(pc);
      return pc + 1;
    case Opcode::append_value:
      if (!append_value_text(texts_[pc->a()], chunk_->types[(pc + 1)->word], &n[pc->b()], nullptr,
                             kMostText)) {
        return fail_too_long(pc);
      }
      return pc + 2;
    case Opcode::append_text:
      if (!append(texts_[pc->a()], texts_[pc->b()])) return fail_too_long(pc);
      return pc + 1;
    case Opcode::latch:
      latch_ = pc;
      latched_random_ = random_;
      return pc + 1;
    case Opcode::read_signal:
      if (next_cycle_is_due()) return leave(pc, pc, State::NextCycle);
      ROB_ASK(observe(pc), pc);
      return pc + 1;
    case Opcode::read_latched:
      if (next_cycle_is_due()) return leave(pc, latch_, State::NextCycle);
      ROB_ASK(observe(pc), latch_);
      return pc + 1;
    case Opcode::read_analog:
      if (next_cycle_is_due()) return leave(pc, pc, State::NextCycle);
      ROB_ASK(observe_analog(pc), pc);
      return pc + 1;
    case Opcode::read_analog_latched:
      if (next_cycle_is_due()) return leave(pc, latch_, State::NextCycle);
      ROB_ASK(observe_analog(pc), latch_);
      return pc + 1;
    case Opcode::read: {
      if (!check_hit_pose(pc)) return fail(pc, std::move(error_));
      const Code resume = pc->c() != 0 ? latch_ : pc;
      if (waits_for_cycle(pc)) return leave(pc, resume, State::NextCycle);
      ROB_ASK(read(pc), resume);
      return pc + 1;
    }
    case Opcode::write_signal:
      ROB_ASK(machine_->write_signal(line(pc), pc->x(), n[pc->a()].integer != 0), pc);
      return pc + 1;
    case Opcode::write_analog:
      ROB_ASK(machine_->write_analog(line(pc), pc->x(), n[pc->a()].real), pc);
      return pc + 1;
    case Opcode::pulse:
      if (!check_pulse(pc, n[pc->a()].real)) return fail(pc, std::move(error_));
      ROB_ASK(machine_->pulse(line(pc), pc->x(), n[pc->a()].real), pc);
      return pc + 1;
    case Opcode::move: {
      MoveCommand command;
      if (!build(pc, command)) return fail(pc, std::move(error_));
      ROB_ASK(machine_->move(line(pc), command), pc);
      ++motions_;
      return pc + 1;
    }
    case Opcode::move_to: {
      const MoveCommand command = build_plain(pc);
      ROB_ASK(machine_->move(line(pc), command), pc);
      ++motions_;
      return pc + 1 + 2 * std::popcount(command.given);
    }
    case Opcode::live_pace:
      ROB_ASK(live_pace(pc), pc);
      return pc + 2;
#include "lang/vm/vm_surroundings.inc"
    case Opcode::guard:
      ROB_ASK(guard(pc), pc);
      return pc + 1;
    case Opcode::ended:
      ROB_ASK(ended(pc), pc);
      return pc + 1;
    case Opcode::when:
      if (armed_count_ == kMostWhens) return fail_too_many_whens(pc);
      ROB_ASK(when(pc), pc);
      return pc + 2;
    case Opcode::when_raise:
      ROB_ASK(machine_->when_raise(place(pc), texts_[pc->a()]), pc);
      return pc + 1;
    case Opcode::when_handle:
      ROB_ASK(when_handle(pc), pc);
      return pc + 2;
    case Opcode::leave_handler:
      ROB_ASK(machine_->leave_handler(line(pc)), pc);
      leave(pc + 1, pc, State::Running);
      end_handler();
      return State::Running;
    case Opcode::on_the_way:
      if (!check_place(pc)) return fail(pc, std::move(error_));
      ROB_ASK(machine_->on_the_way(line(pc), place_of(pc)), pc);
      return pc + 1;
    case Opcode::disarm:
      ROB_ASK(disarm(line(pc), whens_below(pc->x())), pc);
      return pc + 1;
    case Opcode::read_hit:
      n[pc->a()].integer = hit_ ? 1 : 0;
      return pc + 1;
    case Opcode::answer:  // stands in code that is jumped over
      return pc + 1;
    case Opcode::stop:
      ROB_ASK(machine_->stop(line(pc)), pc);
      return pc + 1;
    case Opcode::zero_force:
      ROB_ASK(machine_->zero_force(line(pc)), pc);
      return pc + 1;
    case Opcode::brake:
      ROB_ASK(machine_->brake(line(pc)), pc);
      return pc + 1;
    case Opcode::teach:
      ROB_ASK(teach(pc), pc);
      return pc + 3;
    case Opcode::halt:
      ROB_ASK(machine_->halt(line(pc), texts_[pc->a()]), pc);
      return pc + 1;
    case Opcode::ask:
      ROB_ASK(ask(pc), pc);
      return pc + 2;
    case Opcode::wait:
      if (!check_wait(pc, n[pc->a()].real)) return fail(pc, std::move(error_));
      ROB_ASK(machine_->wait(line(pc), n[pc->a()].real), pc);
      return pc + 1;
    case Opcode::stand:
      if (next_cycle_is_due()) return leave(pc, pc, State::NextCycle);
      ROB_ASK(stand(pc), pc);
      return pc + 1;
      ROB_IF(if_elapsed, n[pc->a()].real - n[pc->b()].real >= n[pc->c()].real - kSameTime);
      ROB_IF(if_assumed, machine_->taken_as_met(line(pc)));
    case Opcode::waited:
      ROB_ASK(machine_->waited(line(pc)), pc);
      return pc + 1;
    case Opcode::fail_timeout:
      return fail_timeout(pc);
    case Opcode::print:
      ROB_ASK(machine_->print(line(pc), texts_[pc->a()]), pc);
      return pc + 1;
    case Opcode::fail_assertion:
      return fail_assertion_at(pc);
    case Opcode::call_test: {
      if (!enter(n + pc->a(), texts_ + pc->b(), test_, pc + 1)) return fail_calls_too_deep(pc);
      return go(pc + 1, callees_[test_].entry);
    }
    case Opcode::expect_failed:
      ROB_ASK(machine_->expectation_failed(line(pc), texts_[pc->a()]), pc);
      return pc + 1;
#include "lang/vm/vm_simulate.inc"
#include "lang/vm/vm_tasks.inc"
    case Opcode::open_try:
      if (!open_try(pc)) return fail_tries_too_deep(pc);
      return pc + 2;
    case Opcode::leave_try:
      ROB_ASK(machine_->leave_block(line(pc)), pc);
      guards_.pop_back();
      return pc + 1;
    case Opcode::leave_rescue:
      guards_.pop_back();
      return pc + 1;
    case Opcode::raise:
      return fail(pc,
                  {.code = std::string(code::kRaised),
                   .place = place(pc),
                   .message = texts_[pc->a()],
                   .help = texts_[pc->a()].empty() ? "the text behind this RAISE is empty" : ""});
    case Opcode::raise_again:
      return raise_again(pc);
    case Opcode::end:
      if (!entries_) ROB_ASK(machine_->end(line(pc)), pc);
      kept_whens_ = armed_count_;
      return leave(pc + 1, pc, State::Done);
    default:  // of the dispatch loop
      return pc;
  }
}

#undef ROB_ASK
#undef ROB_IF
#undef ROB_CHECKED

}  // namespace rob::lang
