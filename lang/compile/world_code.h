#pragma once

#include "lang/check/symbols.h"
#include "lang/code/code_builder.h"
#include "lang/values/builtins.h"

namespace rob::lang {

/// Code that looks at the robot and its signals, and sets them. All that one expression
/// observes belongs to one control cycle: where that is more than one thing, the cycle is latched
/// first.
/// The program has quantities, the channel volts.
class WorldCode {
 public:
  explicit WorldCode(CodeBuilder& code) : code_(code) {}

  /// Begins an expression that makes so many observations.
  void begin(int observations, Place place);
  /// The rest of the expression belongs to a new instant: a routine with observations of its own
  /// was called in between.
  void begin_again(Place place);
  bool latched() const { return latched_; }

  void read(Reading reading, Register target, Place place);
  /// NOW(): the machine gives numbers, the function writes them into a text register.
  void now(const Builtin& function, Register target, Place place);
  void read_signal(const Symbol& symbol, Register target, Place place);
  /// EXISTS, of the file in a text register.
  void look_for_file(Register file, Register target, Place place);
  /// Gives an output the value of a register, in motion order.
  void write_signal(const Symbol& symbol, Register value, Place place);
  /// Switches an output ON for the time in a register.
  void pulse(const Symbol& symbol, Register time, Place place);
  /// SIMULATE of an input: its value in `value`, which is overwritten, the delay after it.
  void simulate(const Symbol& symbol, Register value, Place place);
  /// SIMULATE of a part of the force or the torque.
  void simulate_force(int component, Register value, Place place);

 private:
  void on_group(Opcode op, Register value, const Symbol& symbol, Place place);
  void to_volts(const Symbol& symbol, Register value, Register volts, Place place);

  CodeBuilder& code_;
  bool latched_ = false;
};

}  // namespace rob::lang
