#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "lang/values/arithmetic.h"
#include "lang/values/types.h"

/// The built-in functions: one table (builtins.def) for the checker, constant folding and the Vm.
namespace rob::lang {

/// How the types of arguments and result hang together. D is any dimension, or none.
enum class BuiltinRule : std::uint8_t {
  SameNumber,      ///< all of one D → D; INT if all are INT
  NumberToInt,     ///< D → INT
  Root,            ///< D² → D
  SameReal,        ///< all of one D → D, never INT
  AngleToReal,     ///< ANGLE → REAL
  RealToAngle,     ///< REAL → ANGLE
  SameToAngle,     ///< all of one D → ANGLE
  RealToReal,      ///< REAL → REAL
  RealToInt,       ///< REAL → INT
  AngleToAngle,    ///< ANGLE → ANGLE
  NumbersToVec,    ///< 3 of one D → VEC of D
  VecsToProduct,   ///< VEC of D, VEC of E → D·E
  VecsToVec,       ///< VEC of D, VEC of E → VEC of D·E
  VecsToNumber,    ///< one VEC of D, or two → D
  VecToDirection,  ///< VEC of D → VEC of REAL
  AnyToText,       ///< any → STRING; compiled in line, so it has no function
  Random,          ///< none → REAL, two of one D → D; the Vm's own, so it has no function
  ToFrame,         ///< pose, FRAME → pose in it
  ArrayLength,     ///< ARRAY → INT; known from its type, so it has no function
  Joints,   ///< none, one value an axis, or pose [, JOINTS] → JOINTS; the robot computes it
  Forward,  ///< JOINTS → pose in the world; the same
  Wrench,   ///< none → WRENCH; read from the robot
  Unix,     ///< none → TIME; read from the machine
  Ordinal,  ///< a value of an ENUM → INT, counted from 1; compiled in line, so it has no function
  RowNumber,   ///< a row of numbers of D → D; the Vm's own, so it has no function
  ListAppend,  ///< LIST of t, t; no value: it changes the list; the same
  ListRemove,  ///< LIST, INT; so does it
  ListClear,   ///< LIST; so does it
  Split,       ///< STRING, STRING → LIST OF STRING; the same
  Join,        ///< a row of texts, STRING → STRING; the same
  RowSort,     ///< a row of numbers or texts, which it changes; no value; the same
  FileExists,  ///< STRING → BOOL; read from the world, so it has no function
  AnyToCsv,    ///< any → STRING; compiled in line
  Places,      ///< of poses, as its signature says
  Texts        ///< as its signature says
};

/// Pure; takes no memory. The slots of all arguments in a row; all are INT, or all are REAL, as the
/// function was chosen. `result` is the first of the result's slots. It may be that of the first
/// argument: all is read before anything is written.
using BuiltinFunction = ArithmeticError (*)(std::span<const Slot> arguments, Slot& result);

/// The types of the arguments of a function on texts or poses, letter by letter, and after a colon
/// its result: "SII:S" (builtins.def).
struct Signature {
  std::string_view parameters;
  char result = 0;
};
/// The numbers among the arguments, and the texts; the result lies in the first of its kind. Texts
/// take memory.
using TextFunction = ArithmeticError (*)(Slot* numbers, std::string* texts);

/// No built-in takes more arguments than this. [choice] a MIN of more is not readable.
inline constexpr std::size_t kMostArguments = 16;

struct Builtin {
  std::string_view name;
  std::size_t least = 0;  ///< arguments
  std::size_t most = 0;
  BuiltinRule rule = BuiltinRule::SameNumber;
  BuiltinFunction integer = nullptr;
  BuiltinFunction real = nullptr;
  Signature signature{};  ///< of BuiltinRule::Texts and Places
  TextFunction text = nullptr;
};

/// All of builtins.def, in its order; the index is what an instruction carries.
std::span<const Builtin> builtins();
/// The one that takes so many arguments, or the first of that name, or null. `name` in any case.
const Builtin* find_builtin(std::string_view name, std::size_t arguments);
/// Whether programs from before this function call other things so: it is hidden without a word.
bool is_common_name(std::string_view name);
/// Each name once, for "did you mean".
std::vector<std::string_view> builtin_names();

}  // namespace rob::lang
