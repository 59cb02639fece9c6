#include "lang/code/watch.h"

#include <algorithm>
#include <cassert>
#include <cstring>

#include "lang/machine/move_pose.h"
#include "lang/machine/seen_from.h"
#include "lang/values/builtins.h"
#include "lang/values/pose_functions.h"
#include "lang/values/pose_slots.h"

namespace rob::lang {

namespace {

using Error = ArithmeticError;

/// Executes the code of one watch.
class Evaluation {
 public:
  Evaluation(const Watch& watch, const WatchedWorld& world) noexcept
      : chunk_(*watch.chunk),
        setting_(watch.setting),
        world_(world),
        pc_(chunk_.code.data() + watch.form.entry) {
    std::copy_n(watch.values.begin(), watch.form.values, n_.begin());
  }

  WatchResult run() noexcept {
    while (pc_->opcode() != Opcode::answer) {
      const Error error = step();
      if (error != Error::None) return {.error = error};
    }
    return {.value = n_[pc_->a()]};
  }

 private:
  Slot& a() noexcept { return n_[pc_->a()]; }
  const Slot& b() const noexcept { return n_[pc_->b()]; }
  const Slot& c() const noexcept { return n_[pc_->c()]; }

  Error step() noexcept;
  void read(Reading what) noexcept;
  PoseValue tool() const noexcept;
  Error binary() noexcept;
  Error call() noexcept;
  Error next(int words) noexcept {
    pc_ += words;
    return Error::None;
  }
  /// An instruction that has succeeded is passed.
  Error passed(Error error) noexcept {
    if (error == Error::None) ++pc_;
    return error;
  }
  Error branch(bool truth, bool taken_if) noexcept {
    return next(truth == taken_if ? 2 + (pc_ + 1)->distance() : 2);
  }

  const Chunk& chunk_;
  const Setting& setting_;
  const WatchedWorld& world_;
  const Instruction* pc_;
  std::array<Slot, kMostRegisters> n_;  // what is read has been written: the compiler sees to it
};

Error Evaluation::step() noexcept {
  switch (pc_->opcode()) {
    case Opcode::load_constant:
      a() = chunk_.constants[pc_->x()];
      return next(1);
    case Opcode::load_constant_wide:
      a() = chunk_.constants[(pc_ + 1)->word];
      return next(2);
    case Opcode::load_int:
      a().integer = pc_->signed_x();
      return next(1);
    case Opcode::copy:
      a() = b();
      return next(1);
    case Opcode::int_to_real:
      a().real = static_cast<double>(b().integer);
      return next(1);
    case Opcode::read_signal:
      a().integer = world_.signal(pc_->x()) ? 1 : 0;
      return next(1);
    case Opcode::read_group:
      a().integer = 0;
      for (std::uint32_t i = 0; i < (pc_ + 1)->word; ++i) {
        a().integer |= std::int64_t{world_.signal(pc_->x() + static_cast<int>(i))} << i;
      }
      return next(2);
    case Opcode::read_analog:
      a().real = world_.analog(pc_->x());
      return next(1);
    case Opcode::read:
      read(static_cast<Reading>(pc_->b()));
      return next(1);
    case Opcode::copy_block:
      std::memmove(&a(), &b(), pc_->c() * sizeof(Slot));
      return next(1);
    case Opcode::equal_block:
      a().integer = std::memcmp(&b(), &c(), (pc_ + 1)->word * sizeof(Slot)) == 0 ? 1 : 0;
      return next(2);
    case Opcode::pose_product:
      return passed(pose_functions::product(&b(), &c(), &a()));
    case Opcode::pose_transform:
      return passed(pose_functions::transformed(&b(), &c(), &a()));
    case Opcode::pose_angle:
      pose_functions::angle(&b(), pc_->c(), a());
      return next(1);
    case Opcode::jump:
      return next(1 + pc_->distance());
    case Opcode::if_bool:
      return branch(a().integer != 0, pc_->b() != 0);
    case Opcode::if_equal_int:
      return branch(a().integer == b().integer, pc_->c() != 0);
    case Opcode::if_less_int:
      return branch(a().integer < b().integer, pc_->c() != 0);
    case Opcode::if_less_equal_int:
      return branch(a().integer <= b().integer, pc_->c() != 0);
    case Opcode::if_equal_real:
      return branch(a().real == b().real, pc_->c() != 0);
    case Opcode::if_less_real:
      return branch(a().real < b().real, pc_->c() != 0);
    case Opcode::if_less_equal_real:
      return branch(a().real <= b().real, pc_->c() != 0);
    case Opcode::call_int:
    case Opcode::call_real:
      return passed(call());
    case Opcode::neg_int:
      return passed(arithmetic::negate(b().integer, a().integer));
    case Opcode::neg_real:
      return passed(arithmetic::negate(b().real, a().real));
    default:
      return passed(binary());
  }
}

PoseValue Evaluation::tool() const noexcept {
  std::array<Slot, kPoseSlots> flange;
  world_.read(Reading::Here, flange.data());
  return tip_of(load_pose(flange.data()), setting_);
}

void Evaluation::read(Reading what) noexcept {
  if (what == Reading::Here) return store(from_si(tool()), &a());
  world_.read(what, &a());
  turn_into_frame(what, setting_, setting_.in_tool ? tool() : PoseValue{}, &a());
  read_in_units(what, axes_of(chunk_), &a());
}

Error Evaluation::binary() noexcept {
  switch (pc_->opcode()) {
#define ROB_ARITHMETIC(name, function, in, out) \
  case Opcode::name:                            \
    return arithmetic::function(b().in, c().in, a().out);
#include "lang/code/arithmetic_opcodes.def"
    default:
      assert(false);  // is_watchable() lets nothing else through
      return Error::None;
  }
}

Error Evaluation::call() noexcept {
  const Builtin& builtin = builtins()[pc_->b()];
  const auto function = pc_->opcode() == Opcode::call_int ? builtin.integer : builtin.real;
  return function({&a(), pc_->c()}, a());
}

}  // namespace

WatchResult evaluate(const Watch& watch, const WatchedWorld& world) noexcept {
  return Evaluation(watch, world).run();
}

bool is_watchable(Opcode opcode) {
  switch (opcode) {
    case Opcode::load_constant:
    case Opcode::load_constant_wide:
    case Opcode::load_int:
    case Opcode::copy:
    case Opcode::int_to_real:
    case Opcode::read_signal:
    case Opcode::read_group:
    case Opcode::read_analog:
    case Opcode::read:
    case Opcode::copy_block:
    case Opcode::equal_block:
    case Opcode::pose_product:
    case Opcode::pose_transform:
    case Opcode::pose_angle:
    case Opcode::jump:
    case Opcode::if_bool:
    case Opcode::if_equal_int:
    case Opcode::if_less_int:
    case Opcode::if_less_equal_int:
    case Opcode::if_equal_real:
    case Opcode::if_less_real:
    case Opcode::if_less_equal_real:
    case Opcode::call_int:
    case Opcode::call_real:
    case Opcode::neg_int:
    case Opcode::neg_real:
#define ROB_ARITHMETIC(name, function, in, out) case Opcode::name:
#include "lang/code/arithmetic_opcodes.def"
    case Opcode::answer:
      return true;
    default:
      return false;
  }
}

}  // namespace rob::lang
