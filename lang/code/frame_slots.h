#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "lang/code/chunk.h"

namespace rob::lang {

using Register = std::uint8_t;

/// The register so many slots after another.
constexpr Register behind(Register first, int slots) {
  return static_cast<Register>(first + slots);
}

/// The room that the top level of a prompt takes from one entry to the next.
struct Room {
  int numbers = 0;  ///< registers
  int texts = 0;
  Slots memory;
  std::size_t whens = 0;  ///< that are armed
};

/// The limits of the code. Beyond one of them it is worthless.
enum class Limit { None, Registers, Memory, Jump, Dimensions, Motions, Watch, WatchLength };

/// The limit that was exceeded first, and where.
class CodeLimits {
 public:
  void exceed(Limit limit, Place place) {
    if (exceeded_ != Limit::None) return;
    exceeded_ = limit;
    place_ = place;
  }
  Limit exceeded() const { return exceeded_; }
  Place place() const { return place_; }

 private:
  Limit exceeded_ = Limit::None;
  Place place_;
};

/// The registers and the memory of the frame whose code is made. They are given out like a stack:
/// what a block or an expression takes is given back in one go. Beyond a limit they are given out
/// all the same.
class FrameSlots {
 public:
  /// `code`: that is made.
  FrameSlots(const std::vector<Instruction>& code, CodeLimits& limits)
      : code_(code), limits_(limits) {}

  /// The first of `count` new registers in a row.
  Register number_registers(int count = 1) { return registers_.numbers.take(count); }
  Register text_register() { return registers_.texts.take(1); }
  Register text_registers(int count) { return registers_.texts.take(count); }

  struct Mark {
    int numbers;
    int texts;
    std::size_t names;
    Slots memory;
  };
  Mark mark() const {
    return {registers_.numbers.used, registers_.texts.used, live_names_.size(), memory_};
  }
  /// Gives back all that was taken, and forgets all names given, since `mark`.
  void release(const Mark& mark);
  Room room() const { return {registers_.numbers.used, registers_.texts.used, memory_}; }
  /// Later slots lie after these, which hold values of earlier code.
  void begin_behind(const Room& room);
  /// Notes for listings that a variable lives in a register from here on.
  void name_register(const std::string& name, Register index, bool text);
  /// Whether so many registers are left for a variable.
  bool has_room(Slots slots) const;
  /// Whether more registers are taken than an instruction can name.
  bool beyond_registers() const {
    return registers_.numbers.used > kMostRegisters || registers_.texts.used > kMostRegisters;
  }

  /// From here on the frame has memory after its registers.
  void open_memory() { memory_register_ = number_registers(2); }
  bool has_memory() const { return memory_register_.has_value(); }
  /// Holds the place of that memory's numbers; the one after it that of its texts.
  Register memory_register() const { return *memory_register_; }
  /// Takes slots of the memory; where they begin in it.
  Slots take_memory(Slots slots, Place place);

  /// The next code takes registers of its own, up to bring_back().
  void put_aside();
  void bring_back() { registers_ = aside_; }

  /// All that the frame needs.
  Slots most_registers() const { return {registers_.numbers.most, registers_.texts.most}; }
  Slots most_memory() const { return most_memory_; }
  /// A new frame.
  void begin();
  /// The names of all frames; to be called when the last one is complete.
  std::vector<NamedRegister> take_names() { return std::move(names_); }

 private:
  struct Stack {
    int used = 0;
    int most = 0;
    Register take(int count);
  };
  struct Registers {
    Stack numbers;
    Stack texts;
  };

  const std::vector<Instruction>& code_;
  CodeLimits& limits_;
  Registers registers_;
  Registers aside_;
  Slots memory_;  ///< in use
  Slots most_memory_;
  std::optional<Register> memory_register_;
  std::vector<NamedRegister> names_;
  std::vector<std::size_t> live_names_;  ///< indices into names_
};

}  // namespace rob::lang
