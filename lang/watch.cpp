#include "lang/watch.h"

#include <algorithm>

#include "lang/builtins.h"

namespace rob::lang {

namespace {

using Error = ArithmeticError;

/// Executes the code of one watch.
class Evaluation {
 public:
  Evaluation(const Watch& watch, const WatchedWorld& world) noexcept
      : chunk_(*watch.chunk), world_(world), pc_(chunk_.code.data() + watch.form.entry) {
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
  Error whole() noexcept;
  Error real() noexcept;
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
    case Opcode::read_analog:
      a().real = world_.analog(pc_->x());
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
    case Opcode::add_int:
    case Opcode::sub_int:
    case Opcode::mul_int:
    case Opcode::div_int:
    case Opcode::mod_int:
    case Opcode::pow_int:
    case Opcode::neg_int:
      return passed(whole());
    default:
      return passed(real());
  }
}

Error Evaluation::whole() noexcept {
  std::int64_t& result = a().integer;
  switch (pc_->opcode()) {
    case Opcode::add_int:
      return arithmetic::add(b().integer, c().integer, result);
    case Opcode::sub_int:
      return arithmetic::subtract(b().integer, c().integer, result);
    case Opcode::mul_int:
      return arithmetic::multiply(b().integer, c().integer, result);
    case Opcode::div_int:
      return arithmetic::floor_divide(b().integer, c().integer, result);
    case Opcode::mod_int:
      return arithmetic::floor_modulo(b().integer, c().integer, result);
    case Opcode::pow_int:
      return arithmetic::integer_power(b().integer, c().integer, result);
    default:
      return arithmetic::negate(b().integer, result);
  }
}

Error Evaluation::real() noexcept {
  double& result = a().real;
  switch (pc_->opcode()) {
    case Opcode::add_real:
      return arithmetic::add(b().real, c().real, result);
    case Opcode::sub_real:
      return arithmetic::subtract(b().real, c().real, result);
    case Opcode::mul_real:
      return arithmetic::multiply(b().real, c().real, result);
    case Opcode::quot_real:
      return arithmetic::divide(b().real, c().real, result);
    case Opcode::div_real:
      return arithmetic::floor_divide(b().real, c().real, a().integer);
    case Opcode::mod_real:
      return arithmetic::floor_modulo(b().real, c().real, result);
    case Opcode::pow_real:
      return arithmetic::real_power(b().real, c().real, result);
    default:
      return arithmetic::negate(b().real, result);
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
    case Opcode::read_analog:
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
    case Opcode::add_int:
    case Opcode::sub_int:
    case Opcode::mul_int:
    case Opcode::div_int:
    case Opcode::mod_int:
    case Opcode::pow_int:
    case Opcode::neg_int:
    case Opcode::add_real:
    case Opcode::sub_real:
    case Opcode::mul_real:
    case Opcode::quot_real:
    case Opcode::div_real:
    case Opcode::mod_real:
    case Opcode::pow_real:
    case Opcode::neg_real:
    case Opcode::answer:
      return true;
    default:
      return false;
  }
}

}  // namespace rob::lang
