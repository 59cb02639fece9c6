#pragma once

#include <cstdint>

#include "lang/code/chunk.h"
#include "lang/machine/machine.h"
#include "lang/values/random.h"

namespace rob::lang {

/// The control cycle that a program sees.
///
/// At standstill a program would see the same world again and again without any time passing; so
/// the first observation after a loop has turned is put off to the next control cycle if the
/// current one was observed before. A routine called a second time is like a loop that has turned.
/// It may be called in the middle of an expression: what is observed after the call belongs to a
/// new instant.
///
/// All observations of one expression belong to one cycle: if the machine must wait in the middle
/// of it, the expression starts anew, and draws the same random numbers.
class Instant {
 public:
  using Code = const Instruction*;

  /// The state that a handler puts back at its end.
  struct Expression {
    Code latch = nullptr;                 ///< the `latch` of the expression that is computed
    Random random{Random::kDefaultSeed};  ///< as it was there
    bool turned = false;                  ///< a loop has turned since the last observation
  };

  Instant(std::uint64_t seed, Code start) : random_(seed), expression_{start, random_, false} {}

  /// A loop has turned.
  void turn() { expression_.turned = true; }
  /// A routine is called whose last call was in the cycle `called_in`.
  void call(std::int64_t& called_in) {
    if (called_in == cycle_) expression_.turned = true;
    called_in = cycle_;
  }
  /// Whether an observation is put off to the next cycle.
  bool due() const { return expression_.turned && observed_; }
  /// The reply to an observation.
  Reply seen(Reply reply) {
    if (reply == Reply::Done) {
      observed_ = true;
      expression_.turned = false;
    }
    return reply;
  }
  /// Time may have passed.
  void pass() {
    observed_ = false;
    ++cycle_;
  }
  /// Counts whenever time may have passed.
  std::int64_t cycle() const { return cycle_; }

  Random& random() { return random_; }
  /// An expression begins.
  void latch(Code at) {
    expression_.latch = at;
    expression_.random = random_;
  }
  Code latch() const { return expression_.latch; }
  void start_anew() { random_ = expression_.random; }
  /// Code that no expression has begun in.
  void begin(Code start) { expression_.latch = start; }
  void begin_anew(Code start) {
    begin(start);
    expression_.turned = false;
  }

  const Expression& expression() const { return expression_; }
  void go_on_with(const Expression& expression) { expression_ = expression; }

 private:
  Random random_;
  Expression expression_;
  std::int64_t cycle_ = 1;
  bool observed_ = false;  ///< the world was observed in the current cycle
};

}  // namespace rob::lang
