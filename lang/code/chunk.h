#pragma once

#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "lang/machine/machine.h"
#include "lang/machine/obstacle.h"
#include "lang/text/diagnostic.h"
#include "lang/values/arithmetic.h"
#include "lang/values/types.h"

/// A compiled program: what the Vm executes and the disassembler lists.
namespace rob::lang {

enum class Opcode : std::uint8_t {
#define ROB_OPCODE(name, operands) name,
#include "lang/code/opcodes.def"
};

/// One word of code; its fields are explained in opcodes.def.
struct Instruction {
  std::uint32_t word = 0;

  static constexpr Instruction abc(Opcode op, unsigned a = 0, unsigned b = 0, unsigned c = 0) {
    return {static_cast<std::uint32_t>(op) | a << 8 | b << 16 | c << 24};
  }
  static constexpr Instruction ax(Opcode op, unsigned a, unsigned x) {
    return {static_cast<std::uint32_t>(op) | a << 8 | x << 16};
  }
  static constexpr Instruction jump(Opcode op, std::int32_t distance) {
    return {static_cast<std::uint32_t>(op) | static_cast<std::uint32_t>(distance) << 8};
  }

  Opcode opcode() const { return static_cast<Opcode>(byte(0)); }
  std::uint8_t a() const { return byte(1); }
  std::uint8_t b() const { return byte(2); }
  std::uint8_t c() const { return byte(3); }
  constexpr std::uint16_t x() const { return static_cast<std::uint16_t>(word >> 16); }
  constexpr std::int16_t signed_x() const { return static_cast<std::int16_t>(word >> 16); }
  constexpr std::int32_t distance() const { return static_cast<std::int32_t>(word) >> 8; }

 private:
  /// One load, where a part of the word would need a shift and a mask besides.
  std::uint8_t byte(std::size_t index) const {
    static_assert(std::endian::native == std::endian::little);
    return reinterpret_cast<const std::uint8_t*>(&word)[index];
  }
};

/// A REAL that stands in the code itself.
constexpr std::array<Instruction, 2> words_of(double value) {
  const auto bits = std::bit_cast<std::uint64_t>(value);
  return {Instruction{static_cast<std::uint32_t>(bits)},
          Instruction{static_cast<std::uint32_t>(bits >> 32U)}};
}
constexpr double real_at(const Instruction* words) {
  return std::bit_cast<double>(words[0].word | std::uint64_t{words[1].word} << 32U);
}

/// The farthest that a jump reaches, in words: what fits 24 bits with a sign.
inline constexpr std::size_t kFarthestJump = (std::size_t{1} << 23) - 1;
/// Number registers, and text registers, that one frame can have: what fits 8 bits.
inline constexpr int kMostRegisters = 256;
/// The number of them that variables may take; further ones lie in memory. [choice] what is left is
/// enough for FOR, and for all that one statement computes.
inline constexpr int kVariableRegisters = 160;

/// The registers of all frames together; the frames' memory lies after them (kMemory). [choice]
/// the numbers take 512 KiB.
inline constexpr std::size_t kNumberStack = 65536;
inline constexpr std::size_t kTextStack = 1024;

/// The contents of the registers from A on of a `move` instruction: the number of the axis where it
/// is computed, the given components in order or radius and turns of a spiral, then the values of
/// AT, OVER, ACCEL, JERK, ZONE, FINE, FOR and NEAR. A `via` finds components alone.
struct MoveForm {
  MotionKind kind = MotionKind::Joint;
  MoveCommand::Target means = MoveCommand::Target::Coordinates;
  JogFrame jog{};
  bool relative = false;
  bool in_frame = false;       ///< as in MoveCommand
  bool computed_axis = false;  ///< `given` says nothing: the first register does
  std::uint8_t lengths = 0;    ///< bit i: component i is a length, or a rate of one
  std::uint8_t angles = 0;     ///< or an angle
  int count = 0;               ///< components that there are
  std::uint8_t given = 0;      ///< as in MoveCommand
  MoveCommand::Pace pace = MoveCommand::Pace::Unspecified;
  bool over = false;
  MoveCommand::Bound accel = MoveCommand::Bound::Unspecified;
  MoveCommand::Bound jerk = MoveCommand::Bound::Unspecified;
  MoveCommand::Zone zone = MoveCommand::Zone::Unspecified;
  bool zone_angle = false;
  bool lasts = false;  ///< FOR
  bool fine = false;
  bool euler = false;
  FreeTurn free = FreeTurn::None;
  std::optional<Vector3> free_axis{};  ///< as in MoveCommand
  std::uint8_t near = 0;               ///< NEAR: so many joints, after all other values
  std::uint8_t near_lengths = 0;       ///< bit i: joint i is a length
  bool fine_within = false;
  bool live = false;  ///< AT LIVE has said the pace before
  Profile profile = Profile::Unspecified;

  bool operator==(const MoveForm&) const = default;
};

/// The number of values after a `move_to`: the given components, AT, ZONE.
constexpr int plain_values(const MoveForm& form) {
  return std::popcount(form.given) + (form.pace != MoveCommand::Pace::Unspecified ? 1 : 0) +
         (form.zone != MoveCommand::Zone::Unspecified ? 1 : 0);
}

/// A watch, which is evaluated in every control cycle, takes at most so many instructions. [choice:
/// about a microsecond each sixteenth of it]
inline constexpr std::size_t kLongestWatch = 256;
/// Slots of variables that it may use. [choice: as many names do not fit on a line]
inline constexpr int kMostWatched = 32;

/// The code of a condition that is evaluated in every control cycle (lang/code/watch.h).
struct WatchForm {
  std::uint32_t entry = 0;
  std::uint32_t end = 0;    ///< one past its last word
  std::uint8_t values = 0;  ///< registers that hold the values of variables, from 0 on
};

/// The operations of `row_int` and `row_real`.

enum class RowNumber : std::uint8_t { Sum, Least, Greatest };

/// Where a variable lives; for listings and, later, for looking at a halted program.
struct NamedRegister {
  std::string name;
  std::uint8_t index = 0;
  bool text = false;       ///< a text register
  std::uint32_t from = 0;  ///< first instruction at which the name means this register
  std::uint32_t to = 0;    ///< one past the last
};

/// The name that SIGNAL gives a channel, and for an analog one what its volts stand for; for
/// reports.
struct NamedSignal {
  std::string name;
  int signal = 0;  ///< its index in the RobotSignature
  Dimension dimension;
  double low = 0;   ///< at 0V
  double high = 0;  ///< at kMostVolts

  bool operator==(const NamedSignal&) const = default;
};

/// The value of an output after the run has gone wrong: SAFE.
struct SafeValue {
  int signal = 0;    ///< its index in the RobotSignature
  double value = 0;  ///< 1 for ON, V
  int line = 0;      ///< line_tag() of its declaration
};

/// A PROC, FUNC, TASK, TEST or handler: where its code begins, and how much of the stack it takes.
struct RoutineCode {
  std::string name;
  Place place;           ///< where it is defined
  bool handler = false;  ///< of a WHEN, which nobody calls
  std::uint32_t entry = 0;
  int registers = 0;
  int text_registers = 0;
  Slots memory;  ///< after the registers
};

/// A place for each word of code, in order. Words in a row that come from one place take no more
/// than one, and statements that differ in their line alone, as a million motions may, 8 bytes.
class PlaceTable {
 public:
  void push_back(const Place& place);
  Place operator[](std::size_t word) const;
  std::size_t size() const { return size_; }
  Place back() const { return (*this)[size_ - 1]; }
  /// Memory for so many words of statements in a row.
  void reserve(std::size_t statements) { runs_.reserve(statements); }

 private:
  struct Run {
    std::uint32_t first = 0;  ///< its first word
    std::uint32_t line = 0;
  };
  /// The rest of the places, from a run on.
  struct Rest {
    std::uint32_t run = 0;
    Place place;  ///< its line says nothing
  };
  std::vector<Run> runs_;
  std::vector<Rest> rests_;
  std::uint32_t size_ = 0;
};

/// A DEVICE: what SEND and RECEIVE name by its number.
struct DeviceCode {
  std::string name;
  std::string address;
  std::string ending;
  Place place;
};

/// A PERSIST variable, and where its slots lie on the stack.
struct PersistCode {
  std::string name;
  Type type;
  Place place;
  std::size_t numbers = 0;
  std::size_t texts = 0;
};

/// A TEST: what it is called, where it stands, and its routine.
struct TestCode {
  std::string name;
  Place place;
  std::uint32_t routine = 0;
};

/// A TASK: what it is called, and its routine.
/// [choice] TASKs look after things beside the program; one of many small programs is another
/// language.
inline constexpr std::size_t kMostTasks = 16;

struct TaskCode {
  std::string name;
  std::uint32_t routine = 0;
  Place place{};          ///< of its first line
  bool outdated = false;  ///< this entry declares anew what the TASK uses
};

/// A TOOL of the program.
struct NamedTool {
  std::string name;
  PoseValue tip;
};

struct Chunk {
  std::vector<Instruction> code;
  PlaceTable places;  ///< of every word of code: where it comes from
  std::vector<Slot> constants;
  std::vector<Type> constant_types;  ///< parallel to constants; for listings
  std::vector<std::string> texts;
  std::vector<Dimension> dimensions;
  std::vector<Type> types;  ///< of the compound values that are made into texts
  std::vector<MoveForm> moves;
  std::vector<WatchForm> watches;
  std::vector<std::string> signals;  ///< names by number; for listings
  std::vector<NamedSignal> named_signals;
  std::vector<SafeValue> safe_values;
  std::vector<NamedTool> tools;  ///< for TEACH
  std::vector<Obstacle> obstacles;
  std::vector<std::vector<std::string>> allowed;  ///< names after each ALLOW
  bool shaped = false;                            ///< a TOOL has a SHAPE
  std::vector<NamedRegister> names;
  std::vector<RoutineCode> routines;
  std::vector<TestCode> tests;
  std::vector<PersistCode> persists;
  std::vector<DeviceCode> devices;
  std::uint32_t test_entry = 0;  ///< where every TEST begins: with the program's declarations
  std::vector<TaskCode> tasks;
  std::uint32_t task_entry = 0;  ///< where every TASK begins
  /// Something in it depends on the time beside the motion: CLOCK, TIMEOUT, PULSE, RANDOM, a TASK,
  /// a handler.
  bool timed = false;
  std::optional<Place> first_signal;  ///< where the text first reads, sets or pulses one
  std::optional<Place> first_teach;   ///< where the text first keeps a point
  int registers = 0;                  ///< of the top level
  int text_registers = 0;
  Slots memory;                                 ///< of the top level, after its registers
  std::shared_ptr<const TypeTable> type_table;  ///< where `types` point to
};

/// The dimensions of the robot's axes.
std::span<const Dimension> axes_of(const Chunk& chunk);
/// Whether a routine takes memory after its registers.
bool takes_memory(const Chunk& chunk);
/// Whether a WHEN has a handler.
bool has_handlers(const Chunk& chunk);

/// "add_int", and what its operands are: the letters of opcodes.def.
struct OpcodeInfo {
  std::string_view name;
  std::string_view operands;
};
const OpcodeInfo& info(Opcode opcode);

}  // namespace rob::lang
