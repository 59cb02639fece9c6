#pragma once

#include <cstdint>
#include <deque>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "lang/values/dimension.h"

namespace rob::lang {

/// In words, for messages: "a length", "a time", "a plain number", "a [kg*mm]".
std::string in_words(Dimension dimension);

struct TypeDetail;

/// Slots that a value takes: numbers hold BOOL, INT and REAL, texts hold STRING.
struct Slots {
  int numbers = 0;
  int texts = 0;

  bool operator==(const Slots&) const = default;
  Slots operator+(const Slots& other) const {
    return {numbers + other.numbers, texts + other.texts};
  }
};

/// The memory after the registers, for arrays, records and what registers have no room for, of
/// all frames together. [choice] 262144 numbers are 2 MiB and more than a program of a robot has
/// points; 4096 texts of 64 KiB each are 256 MiB at most.
inline constexpr Slots kMemory{.numbers = 262144, .texts = 4096};

/// The static type of an expression or a variable. `Unknown` is the type of what is already
/// reported as wrong: it fits everywhere, so that one mistake makes one message.
///
/// Small and comparable: what more there is to know of a type is kept apart (TypeTable). Two ARRAY
/// types are equal where their elements and lengths are, others where their details are the same.
struct Type {
  enum class Kind : std::uint8_t {
    Unknown,
    Bool,
    Int,
    Real,
    Enum,  ///< which of its names, counted from 0
    String,
    Vec,     ///< three REALs of one dimension
    Pose,    ///< x y z in m, then the unit quaternion w i j k of the orientation
    Joints,  ///< one REAL an axis, each of its axis's dimension
    Wrench,  ///< a force, then a torque
    Frame,   ///< as Pose
    Tool,    ///< as Pose, then the mass, and x y z of its centre of gravity
    Array,
    List,  ///< one slot, by which the Vm finds its elements
    Record
  };

  Kind kind = Kind::Unknown;
  Dimension dimension{};               ///< of Real and Vec only
  const TypeDetail* detail = nullptr;  ///< of Joints, Array, List, Record, Enum, and Pose

  bool operator==(const Type& other) const;
  bool known() const { return kind != Kind::Unknown; }
  bool numeric() const { return kind == Kind::Int || kind == Kind::Real; }
  bool text() const { return kind == Kind::String; }
  bool is(Kind other) const { return kind == other; }
  /// An ARRAY of any length, as a REF parameter may be: its length is known while the program runs.
  bool is_open() const;
  /// Elements in a row whose number is known only while the program runs.
  bool is_row() const { return is_open() || is(Kind::List); }
  bool has_row() const { return is(Kind::Array) || is(Kind::List); }
  /// Whether the type takes one slot.
  bool scalar() const { return kind <= Kind::String; }
  /// Lies in registers of a row; all else lies in the memory of a frame.
  bool in_registers() const { return kind < Kind::Array; }

  static Type boolean() { return {Kind::Bool}; }
  static Type integer() { return {Kind::Int}; }
  static Type real(Dimension d = {}) { return {Kind::Real, d}; }
  static Type string() { return {Kind::String}; }
  static Type vec(Dimension d) { return {Kind::Vec, d}; }
  /// `axes`: those of the robot that the program is for.
  static Type joints(const TypeDetail* axes) { return {Kind::Joints, {}, axes}; }
  /// In the frame of `detail`; without one in the world.
  static Type pose(const TypeDetail* frame = nullptr) { return {Kind::Pose, {}, frame}; }
  /// POSE, FRAME and TOOL: a place and an orientation.
  bool is_place() const { return kind == Kind::Pose || kind == Kind::Frame || kind == Kind::Tool; }
};

/// The length of an ARRAY of any length.
inline constexpr std::int64_t kAnyLength = -1;

/// The parts of a compound type.
struct TypeDetail {
  struct Field {
    std::string name;
    Type type;
  };
  Slots slots;   ///< of a whole value; where there is any number of elements, of one
  Type element;  ///< of Array and List
  /// Of Array: kAnyLength, or 0 while it is not known, or where it is faulty.
  std::int64_t length = 0;
  int written = -1;             ///< of an Array with a length in the text: its TypeTable index
  int height = 1;               ///< of Array and Record: levels of them inside each other
  bool complete = false;        ///< of Record and Enum: all its fields, or names, are known
  bool faulty = false;          ///< of Record: it could not be read, and may have further fields
  std::string name;             ///< of Record and Enum; of Pose: the frame
  std::vector<Field> fields;    ///< of Record, in the order of their slots
  std::vector<Dimension> axes;  ///< of Joints
  bool enumeration = false;     ///< it is an Enum, not a Record
  std::vector<std::string> names{};  ///< of Enum, in the order of their values
};

inline bool Type::is_open() const { return kind == Kind::Array && detail->length == kAnyLength; }

/// The details of all types of one program. They keep their addresses.
struct TypeTable {
  /// By the number of the file that declares them, and name in capitals. Those that earlier entries
  /// of the prompt have declared are of their tables.
  using Named = std::map<std::pair<std::uint32_t, std::string>, TypeDetail*>;

  TypeTable() = default;
  TypeTable(const TypeTable&) = delete;
  TypeTable& operator=(const TypeTable&) = delete;

  /// The type of a list of `length` such elements.
  Type array(const Type& element, std::int64_t length);
  Type list(const Type& element);
  /// One detail for each name, so that types are equal where their frames or records are.
  TypeDetail& frame(std::uint32_t file, std::string_view name) { return named(frames, file, name); }
  TypeDetail& record(std::uint32_t file, std::string_view name) {
    return named(records, file, name);
  }

  std::deque<TypeDetail> details;  ///< its own
  /// All of a program are of one robot, whose axes the checker puts in.
  std::shared_ptr<TypeDetail> joints = std::make_shared<TypeDetail>();
  Named frames;
  Named records;  ///< and ENUMs: no two types share a name

 private:
  TypeDetail& named(Named& types, std::uint32_t file, std::string_view name);
};

/// A pose that has no frame yet and takes the one that its place in the program wants.
Type free_pose();
bool is_free(const Type& type);
/// The type of a place as a pose: a FRAME one in the world, a TOOL one without frame.
Type as_pose(const Type& place);
/// The type of a variable that is given a value of this type: what is free is in the world.
Type settled(const Type& type);
/// "world", "pallet"; "no frame" of what is free.
std::string frame_name(const Type& pose);
/// 0, 1 or 2 for .a, .b or .c of a place; they are computed, and do not lie in it.
std::optional<int> angle_of(const Type& type, std::string_view field);

Slots slots_of(const Type& type);

/// Whether a variable may be declared without a value: then all its slots are 0, FALSE or "".
/// A pose or a place of the joints that nobody has given would be a place to crash into.
bool has_default(const Type& type);

/// Levels of arrays and records inside each other; 0 of what is neither.
int height_of(const Type& type);

/// Whether a value holds a pose or the like somewhere: then == does not compare it.
bool holds_place(const Type& type);

/// One part of a value: `v.x`, `part.size`.
struct Field {
  Type type;
  Slots offset;  ///< of its slots after those of the whole
};
/// Nothing if values of this type have no such field. `name` in any case.
std::optional<Field> field_of(const Type& type, std::string_view name);
/// The names of all fields, for messages.
std::vector<std::string_view> field_names(const Type& type);

/// The set that an index chooses from: elements of one type in a row.
struct Elements {
  Type type;  ///< of JOINTS that of the first axis; the others may be of another dimension
  std::int64_t count = 0;  ///< kAnyLength where it is known only while the program runs
  bool list = false;
};
/// The value of an ENUM's name, in any case; nothing if it has no such name.
std::optional<std::int64_t> value_of(const TypeDetail& enumeration, std::string_view name);

/// Nothing if values of this type have no elements.
std::optional<Elements> elements_of(const Type& type);

/// In words: "a whole number", "a length", "a text", "TRUE or FALSE", "a VEC, each a length".
std::string in_words(const Type& type);

}  // namespace rob::lang
