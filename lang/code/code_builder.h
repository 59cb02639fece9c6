#pragma once

#include <cstddef>
#include <cstdint>
#include <map>
#include <optional>
#include <span>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

#include "lang/code/chunk.h"

namespace rob::lang {

using Register = std::uint8_t;

/// What the top level of a prompt holds from one entry to the next.
struct Room {
  int numbers = 0;  ///< registers
  int texts = 0;
  Slots memory;
  std::size_t whens = 0;  ///< that are armed
};

/// Instructions, constants and registers of a Chunk in the making. Knows the encoding and its
/// limits, and nothing of the language.
///
/// Registers are given out like a stack: what a block or an expression takes is given back in one
/// go. Beyond a limit the code is worthless but building goes on; failed() tells at the end.
class CodeBuilder {
 public:
  /// Code that is still to be told where to go.
  using Jump = std::size_t;
  using Jumps = std::vector<Jump>;

  explicit CodeBuilder(std::vector<std::string> signals) { chunk_.signals = std::move(signals); }

  void emit(Instruction instruction, Place place);
  void emit(Opcode op, Place place, unsigned a = 0, unsigned b = 0, unsigned c = 0) {
    emit(Instruction::abc(op, a, b, c), place);
  }
  void load_integer(Register target, std::int64_t value, Place place);
  void load_real(Register target, double value, Dimension dimension, Place place);
  /// The index of a constant for an operand of 8 bits; none where it lies beyond them, or where
  /// the code is that of a watch, which has no such operands.
  std::optional<std::uint8_t> constant_operand(Slot value, std::uint64_t bits, Type type);
  /// An ASSERT whose condition, as it was written, does not hold.
  void fail_assertion(const std::string& condition, Place place);
  /// TEACH: a pose of the registers from `pose` on.
  void teach(Register pose, const std::string& point, const std::string& frame, Place place);
  void load_text(Register target, const std::string& text, Place place);
  void append_real(Register text, Register value, Dimension dimension, Place place);
  /// ASK for a value of a type.
  void ask(Register text, Register answer, const Type& type, Place place);
  /// A compound value whose slots begin at a register.
  void append_value(Register text, Register first, const Type& type, Place place);
  /// A value whose numbers and texts begin at the places in two registers.
  void append_memory(Register text, Register places, const Type& type, Place place);
  void move(Register first, const MoveForm& form, Place place);
  void via(Register first, const MoveForm& form, Place place);
  /// A move with its components in the code, SI.
  void move_to(const MoveForm& form, std::span<const double> components, Place place);

  /// Memory for so many statements of so many words each that follow, where they are more than all
  /// before.
  void reserve(std::size_t statements, std::size_t words);

  /// A jump forward, aimed later with land().
  [[nodiscard]] Jump jump(Place place);
  /// Lets jumps arrive at the next instruction.
  void land(const Jumps& jumps);
  void land(Jump jump) { land(Jumps{jump}); }
  /// The place of the next instruction, as a target for loop().
  std::size_t here() const { return chunk_.code.size(); }
  /// A jump backward.
  void loop(std::size_t target, Place place);
  /// The body of a FOR over integers, up to here; its value is in a register. If all that it does
  /// is to store what never changes into the element of that number, many turns become one.
  void join_turns(std::size_t body, Register value);

  /// The first of `count` new registers in a row.
  Register number_registers(int count = 1) { return numbers_.take(count); }
  Register text_register() { return texts_.take(1); }
  Register text_registers(int count) { return texts_.take(count); }
  struct Mark {
    int numbers;
    int texts;
    std::size_t names;
    Slots memory;
  };
  Mark mark() const { return {numbers_.used, texts_.used, live_names_.size(), memory_}; }
  Room room() const { return {numbers_.used, texts_.used, memory_}; }
  /// What is taken now lies behind this, which holds values of earlier code.
  void begin_behind(const Room& room);
  /// Whether so many registers are left for a variable.
  bool has_room(Slots slots) const {
    return numbers_.used + slots.numbers <= kVariableRegisters &&
           texts_.used + slots.texts <= kVariableRegisters;
  }

  /// The present frame has memory behind its registers; how much turns out at its end.
  void open_memory(Place place);
  bool has_memory() const { return memory_register_.has_value(); }
  /// Holds the place of that memory's numbers; the one behind it that of its texts.
  Register memory_register() const { return *memory_register_; }
  /// Takes slots of the memory; where they begin in it.
  Slots take_memory(Slots slots, Place place);
  /// Gives back all registers taken, and forgets all names given, since `mark`.
  void release(const Mark& mark);
  /// Tells listings that a variable lives in a register from here on.
  void name_register(const std::string& name, Register index, bool text);

  /// Tells reports what the program calls a signal.
  void declare_safe(const SafeValue& value) { chunk_.safe_values.push_back(value); }
  void name_tool(NamedTool tool) { chunk_.tools.push_back(std::move(tool)); }
  void name_signal(NamedSignal signal) { chunk_.named_signals.push_back(std::move(signal)); }

  /// What follows is what every TEST begins with.
  void begin_tests() { chunk_.test_entry = static_cast<std::uint32_t>(chunk_.code.size()); }
  void add_test(TestCode test) { chunk_.tests.push_back(std::move(test)); }
  /// Calls the TEST that the Vm was told; its registers begin behind those in use.
  void call_test(Place place) {
    emit(Opcode::call_test, place, static_cast<unsigned>(numbers_.used),
         static_cast<unsigned>(texts_.used));
  }

  /// Where every TASK begins: it calls the routine that the Vm was told.
  void task_entry(Place place);
  void add_task(TaskCode task) { chunk_.tasks.push_back(std::move(task)); }
  std::size_t tasks() const { return chunk_.tasks.size(); }
  /// START of a TASK, by its number.
  void start(std::size_t task, Place place);
  /// TASKs see the slots from the place in register `first` on as they are now.
  void publish(Register first, bool texts, int count, Place place);
  /// The slots of the top level from `first` on become what TASKs see.
  void refresh(std::size_t first, bool texts, int count, bool latched, Place place);

  /// See Chunk::timed.
  void depends_on_time() { chunk_.timed = true; }
  /// See Chunk::first_signal.
  void uses_signal(Place place) {
    if (!chunk_.first_signal) chunk_.first_signal = place;
  }
  /// What follows is the code of a routine, with registers of its own.
  void begin_routine(const std::string& name, const Place& place, bool handler);
  /// Calls a routine, by its number, whose parameters lie in the registers from these two on.
  void call(std::size_t routine, Register numbers, Register texts, Place place);

  /// What follows, up to end_watch(), is code for every control cycle, with registers of its own.
  /// It must not be executed: it is jumped over.
  void begin_watch(Place place);
  /// `answer` holds its value; its first `values` registers are given. Returns its number.
  std::uint16_t end_watch(Register answer, int values, Place place);

  /// Arms a watch; `level`: how many stand before it in its frame.
  void when(Register values, std::uint16_t watch, std::size_t level, Place place);
  /// Its action: a handler, by its number as a routine, with `count` registers from the first on.
  void when_handle(Register first, int count, bool stops, std::size_t routine, Place place);

  enum class Limit { None, Registers, Memory, Jump, Dimensions, Motions, Watch, WatchLength };
  /// The limit that was exceeded, and where first.
  Limit failed() const { return failed_; }
  Place failed_at() const { return failed_at_; }

  Chunk finish();

 private:
  struct Registers {
    int used = 0;
    int most = 0;
    Register take(int count);
  };

  std::size_t text_index(const std::string& text);
  std::uint16_t form_index(const MoveForm& form, Place place);
  void close_frame();
  void fail(Limit limit, Place place);
  std::uint32_t constant_index(Slot value, std::uint64_t bits, Type type);
  void load_constant(Register target, Slot value, std::uint64_t bits, Type type, Place place);
  void set_distance(std::size_t at, std::size_t target);

  /// What a watch puts aside while its code is built.
  struct OpenWatch {
    Registers numbers;
    Registers texts;
    Jump over = 0;
    std::size_t entry = 0;
  };

  Chunk chunk_;
  OpenWatch watch_;
  bool watching_ = false;  ///< watch_ is open
  Registers numbers_;
  Registers texts_;
  Slots memory_;  ///< in use
  Slots most_memory_;
  std::optional<Register> memory_register_;
  std::vector<std::size_t> reserves_;    ///< `reserve` instructions of the present frame
  std::vector<std::size_t> live_names_;  ///< indices into chunk_.names
  /// Constants are kept once: by bits, kind and dimension (which only listings look at).
  std::map<std::tuple<std::uint64_t, Type::Kind, Dimension>, std::uint32_t> constant_indices_;
  std::map<std::string, std::uint32_t> text_indices_;
  Limit failed_ = Limit::None;
  Place failed_at_;
};

}  // namespace rob::lang
