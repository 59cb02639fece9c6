#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "lang/code/chunk.h"
#include "lang/code/code_tables.h"
#include "lang/code/frame_slots.h"
#include "lang/code/last_element.h"

namespace rob::lang {

/// The instructions of a Chunk in the making. Knows the encoding and its limits, and nothing of the
/// language.
///
/// Beyond a limit the code is worthless but building goes on; limits() says so at the end.
class CodeBuilder {
 public:
  /// A jump whose target is not known yet.
  using Jump = std::size_t;
  using Jumps = std::vector<Jump>;

  explicit CodeBuilder(std::vector<std::string> signals) { chunk_.signals = std::move(signals); }
  CodeBuilder(const CodeBuilder&) = delete;
  CodeBuilder& operator=(const CodeBuilder&) = delete;

  /// The registers and the memory of the current frame.
  FrameSlots& frame() { return frame_; }

  void emit(Instruction instruction, Place place);
  void emit(Opcode op, Place place, unsigned a = 0, unsigned b = 0, unsigned c = 0) {
    emit(Instruction::abc(op, a, b, c), place);
  }
  void load_integer(Register target, std::int64_t value, Place place);
  void load_real(Register target, double value, Dimension dimension, Place place);
  /// The index of a constant for an operand of 8 bits; none where it lies beyond them, or where
  /// the code is that of a watch, which has no such operands.
  std::optional<std::uint8_t> constant_operand(Slot value, std::uint64_t bits, Type type);
  /// TEACH: a pose and so many joints, of the registers from these on; what is kept of them is
  /// there afterwards.
  void teach(Register pose, Register joints, int count, const std::string& point,
             const std::string& frame, Place place);
  void load_text(Register target, const std::string& text, Place place);
  /// An instruction with a text that is known.
  void with_text(Opcode op, unsigned a, unsigned b, const std::string& text, Place place);
  void append_real(Register text, Register value, Dimension dimension, Place place);
  /// ASK for a value of a type.
  void ask(Register text, Register answer, const Type& type, Place place);
  /// A compound value whose slots begin at a register.
  void append_value(Register text, Register first, const Type& type, Place place);
  /// The elements of a row, each of that type.
  void append_row(Register text, Register row, const Type& element, Place place);
  /// A value whose numbers and texts begin at the places in two registers: append_memory, or
  /// append_csv for fields of CSV.
  void append_memory(Opcode opcode, Register text, Register places, const Type& type, Place place);
  /// READ: a file into an array of records at these places.
  void read_rows(Register file, Register places, const Type& type, Place place);
  void move(Register first, const MoveForm& form, Place place);
  void via(Register first, const MoveForm& form, Place place);
  /// Clauses of motions: enter_defaults, set_defaults.
  void defaults(Opcode opcode, Register first, const MoveForm& form, Place place);
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

  LastElement& last_element() { return last_element_; }

  /// The current frame has memory after its registers; how much turns out at its end.
  void open_memory(Place place);

  void declare_safe(const SafeValue& value) { chunk_.safe_values.push_back(value); }
  void name_tool(NamedTool tool, bool shaped) {
    chunk_.tools.push_back(std::move(tool));
    chunk_.shaped = chunk_.shaped || shaped;
  }
  /// ALLOW, up to an end_with.
  void allow(std::vector<std::string> bodies, Place place);
  /// Gives reports the program's name of a signal.
  void name_signal(NamedSignal signal) { chunk_.named_signals.push_back(std::move(signal)); }

  /// The beginning of every TEST follows.
  void begin_tests() { chunk_.test_entry = static_cast<std::uint32_t>(chunk_.code.size()); }
  void add_test(TestCode test) { chunk_.tests.push_back(std::move(test)); }
  /// Calls the TEST that the Vm was given; its registers begin after those in use.
  void call_test(Place place);

  /// Where every TASK begins: it calls the routine that the Vm was given.
  void task_entry(Place place);
  void add_task(TaskCode task) { chunk_.tasks.push_back(std::move(task)); }
  /// START of a TASK, by its number.
  void start(std::size_t task, Place place);
  /// TASKs see the slots from the place in register `first` on as they are now.
  void publish(Register first, bool texts, int count, Place place);
  /// The slots of the top level from `first` on become what TASKs see.
  void refresh(std::size_t first, bool texts, int count, bool latched, Place place);

  /// Declares a PERSIST variable by its number, and gives it the value of an earlier run.
  void declare_persist(int number, PersistCode code);
  enum class Persist : std::uint8_t { Changed, Lent, Back };
  void persist(int number, Persist what, Place place) {
    emit(Instruction::ax(Opcode::persist, static_cast<unsigned>(what),
                         static_cast<std::uint16_t>(number)),
         place);
  }

  /// By its number.
  void declare_device(int number, DeviceCode code);
  void receive(Register text, Register timeout, Register came, int device, Place place);
  void simulate_line(Register after, Register text, int device, Place place);

  /// See Chunk::timed.
  void depends_on_time() { chunk_.timed = true; }
  /// See Chunk::first_signal.
  void uses_signal(Place place) {
    if (!chunk_.first_signal) chunk_.first_signal = place;
  }
  /// The code of a routine follows, with registers of its own.
  void begin_routine(const std::string& name, const Place& place, bool handler);
  /// Calls a routine, by its number, whose parameters lie in the registers from these two on.
  void call(std::size_t routine, Register numbers, Register texts, Place place);

  /// Code for every control cycle follows, up to end_watch(), with registers of its own. It must
  /// not be executed: it is jumped over.
  void begin_watch(Place place);
  /// `answer` holds its value; its first `values` registers are given. Returns its number.
  std::uint16_t end_watch(Register answer, int values, Place place);

  /// Arms a watch; `level`: how many stand before it in its frame.
  void when(Register values, std::uint16_t watch, std::size_t level, Place place);
  /// Its action: a handler, by its number as a routine, with `count` registers from the first on.
  void when_handle(Register first, int count, bool stops, std::size_t routine, Place place);

  const CodeLimits& limits() const { return limits_; }

  Chunk finish();

 private:
  void close_frame();
  void load_constant(Register target, Slot value, std::uint64_t bits, Type type, Place place);
  /// The number of a form, within what an instruction can hold.
  unsigned form_number(const MoveForm& form, Place place);
  void set_distance(std::size_t at, std::size_t target);

  /// A watch whose code is made.
  struct OpenWatch {
    Jump over = 0;
    std::size_t entry = 0;
  };

  Chunk chunk_;
  CodeTables tables_;
  CodeLimits limits_;
  FrameSlots frame_{chunk_.code, limits_};
  std::vector<std::size_t> reserves_;  ///< `reserve` instructions of the current frame
  std::optional<OpenWatch> watch_;
  LastElement last_element_{chunk_.code};
};

}  // namespace rob::lang
