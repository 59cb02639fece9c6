#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <map>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <variant>
#include <vector>

#include "lang/diagnostic.h"
#include "lang/motion_words.h"
#include "lang/pose_math.h"
#include "lang/types.h"
#include "lang/units.h"

/// The syntax tree: what was written, in the shape of the grammar (docs/rob.ebnf). The parser
/// builds it; the checker fills in `Expr::type`, the symbols and the constants; the compiler
/// reads it. The depth of a tree is bounded by the parser, so recursion over it is safe.
namespace rob::lang {

struct Expr;
struct Statement;
struct Symbol;
struct Routine;
using ExprPtr = std::unique_ptr<Expr>;
using Block = std::vector<Statement>;

// ---------------------------------------------------------------- expressions

/// `10`, `0.5`, `20mm`: the value in SI. For a quantity the dimension is its unit's.
struct NumberLiteral {
  double value = 0;
  std::int64_t integer = 0;  ///< the value where is_integer
  bool is_integer = false;   ///< written without point, exponent or unit
  Dimension dimension;
  bool has_unit = false;  ///< written with a unit: tells 50% from 0.5, both dimensionless
};
struct BoolLiteral {
  bool value = false;
};
struct StringLiteral {
  std::string value;
};
/// A variable, constant, signal or built-in value; DIN[n], DOUT[n], AIN[n], AOUT[n] have an index.
struct Name {
  std::string text;
  const Symbol* symbol = nullptr;  ///< set by the checker; owned by the CheckedProgram
  ExprPtr index = nullptr;
};

enum class UnaryOp : std::uint8_t { Negate, Plus, Not };
struct Unary {
  UnaryOp op;
  ExprPtr operand;
};

enum class BinaryOp : std::uint8_t {
  Or,
  Xor,
  And,
  Equal,
  NotEqual,
  Less,
  LessEqual,
  Greater,
  GreaterEqual,
  Add,
  Subtract,
  Multiply,
  Divide,
  Div,
  Mod,
  Power
};
struct Binary {
  BinaryOp op;
  ExprPtr left;
  ExprPtr right;
};

/// `MAX(a, b)`, `place(part, above: 20mm)`: a built-in function or a routine of the program.
struct Call {
  std::string callee;
  std::vector<ExprPtr> arguments;
  std::vector<std::string> names;    ///< of the arguments; empty where one was not named
  const Routine* routine = nullptr;  ///< set by the checker; null for a built-in function
  std::vector<const Expr*> bound{};  ///< of a routine, set by the checker: one a parameter
};

/// `(140, , )` or `(x: 140mm)`. One unnamed element in parentheses is a group, not a tuple.
struct Tuple {
  struct Element {
    std::string name;  ///< empty where it was not named
    ExprPtr value;     ///< null where it was left out
    Place place;
  };
  std::vector<Element> elements;
};

/// `v.x`, `part.size`.
struct Member {
  ExprPtr object;
  std::string field;
  Place field_place;
};

/// `a[i]`, `v[2]`.
struct Index {
  ExprPtr object;
  ExprPtr index;
};

/// Any constant expression's value; settled by the checker. The last is the slots of a compound
/// value of nothing but REALs.
using Constant =
    std::variant<std::monostate, bool, std::int64_t, double, std::string, std::vector<double>>;

struct Expr {
  Place place;  ///< of the token a message should point at
  std::variant<NumberLiteral, BoolLiteral, StringLiteral, Name, Unary, Binary, Call, Tuple, Member,
               Index>
      node;
  Type type;  ///< set by the checker
  /// Set by the checker: a pose in this FRAME that stands where one in the world is wanted.
  mutable const Symbol* moved_from = nullptr;
  Constant constant;  ///< set by the checker where the value is known before the program runs
  int height = 1;     ///< levels of this tree; the parser keeps it at kMaxDepth (parser.h) at most
};

// ----------------------------------------------------------------- statements

/// Clauses of a motion that have a value, in the order of its registers (MoveForm).
enum class Clause : std::uint8_t { At, Over, Accel, Jerk, Zone };
inline constexpr std::size_t kClauses = 5;

struct Clauses {
  std::array<ExprPtr, kClauses> values;  ///< by Clause; null where left out
  Profile profile = Profile::Unspecified;
  bool fine = false;

  const ExprPtr& operator[](Clause clause) const {
    return values[static_cast<std::size_t>(clause)];
  }
  ExprPtr& operator[](Clause clause) { return values[static_cast<std::size_t>(clause)]; }
};
/// MOVE(40, 40, 0) · MOVEL BY (20mm, 0mm, 0deg) · MOVE JOINT 3 TO 90deg
struct Move {
  MotionKind kind = MotionKind::Joint;
  bool by = false;  ///< BY: from the last commanded target
  ExprPtr axis;     ///< of MOVE JOINT; null else
  ExprPtr target;   ///< a Tuple; of MOVE JOINT the axis' value
  Clauses clauses;
};
/// AFTER 2mm LEAD 20ms : lift = ON
struct WayPoint {
  Place place;
  bool before = false;
  ExprPtr distance;
  bool lag = false;
  ExprPtr shift;  ///< of LEAD or LAG; null where left out
  Block action;   ///< one statement
};
/// MOVE(140, 40, 0) UNTIL touched ELSE PRINT "missed": a motion, and what is looked at on its way.
struct WatchedMotion {
  Block motion;   ///< one statement
  ExprPtr until;  ///< null where left out
  bool has_else = false;
  Block otherwise;  ///< of ELSE: one statement
  std::vector<WayPoint> events;
};
/// WHEN door : lift = OFF
struct When {
  ExprPtr condition;
  Block action;  ///< one statement
};
struct Stop {};
struct Brake {};
/// HALT "change the tool"
struct Halt {
  ExprPtr text;  ///< null where left out
};
/// ASK "how many? " INTO count
struct Ask {
  ExprPtr text;
  ExprPtr target;  ///< a Name, or a Member or Index of one
};
/// VAR a, b = 1 · VAR a: LENGTH · CONST c = 2mm · FRAME f = POSE(…) · TOOL t = POSE(…) MASS 1kg
struct Declaration {
  struct Declared {
    std::string name;
    Place place;
    const Symbol* symbol = nullptr;  ///< set by the checker
  };
  bool constant = false;
  std::vector<Declared> names;
  std::optional<Type> type;  ///< where it was written; Unknown where the parser found it faulty
  ExprPtr value;             ///< null where left out
  ExprPtr mass{};            ///< of TOOL; null where left out
  ExprPtr cog{};             ///< of TOOL: its centre of gravity; null where left out
  const TypeDetail* frame = nullptr;  ///< of FRAME: what poses in it have as their detail
};
/// SIGNAL part_here = DIN[1] · SIGNAL wire: SPEED = AOUT[1] SCALE 0mm/s TO 300mm/s
struct SignalDeclaration {
  std::string name;
  Place name_place;
  std::optional<Type> type;  ///< where it was written
  Place type_place;
  ExprPtr low;            ///< SCALE: what 0V stand for; null where left out
  ExprPtr high;           ///< what kMostVolts stand for
  ExprPtr safe;           ///< SAFE; null where left out
  double safe_value = 0;  ///< set by the checker: 1 for ON, V
  Name channel;
  Place channel_place;
  const Symbol* symbol = nullptr;  ///< set by the checker
};
/// POINT pick, place · POINT home = POSE(0mm, 0mm, 50mm)
struct PointDeclaration {
  struct Point {
    Declaration::Declared declared;
    std::optional<PoseValue> kept{};  ///< set by the checker: what the points file says
  };
  std::vector<Point> points;
  ExprPtr value;      ///< null where left out
  bool sound = true;  ///< could be read
};
/// TEACH pick
struct Teach {
  Name target;
  Place target_place;
  const Symbol* frame = nullptr;  ///< set by the checker: that the point is in; null for the world
};
struct Assign {
  ExprPtr target;  ///< a Name, or a Member or Index of one
  ExprPtr value;
};
/// PULSE coming 50ms
struct Pulse {
  Name target;
  Place target_place;
  ExprPtr time;
};
struct Print {
  std::vector<ExprPtr> values;
};
/// WAIT 0.5s · WAIT part_here TIMEOUT 3s ELSE lift = OFF
struct Wait {
  ExprPtr value;    ///< a time, or a condition
  ExprPtr timeout;  ///< null where left out
  bool has_else = false;
  Block otherwise;  ///< of ELSE: one statement
};
/// IF with any number of ELSIF branches, and ELSE.
struct If {
  struct Branch {
    ExprPtr condition;
    Block body;
  };
  std::vector<Branch> branches;
  Block otherwise;
};
struct While {
  ExprPtr condition;
  Block body;
};
struct For {
  std::string variable;
  Place variable_place;
  const Symbol* symbol = nullptr;  ///< set by the checker
  ExprPtr from;
  ExprPtr to;
  ExprPtr step;  ///< null: 1
  Block body;
};

struct Loop {
  Block body;
};
/// SELECT: the first CASE with a value equal to the selector's is executed, else ELSE.
struct Select {
  struct Case {
    Place place;
    std::vector<ExprPtr> values;
    Block body;
  };
  ExprPtr selector;  ///< null where it could not be read
  std::vector<Case> cases;
  Block otherwise;
  bool has_else = false;
};
struct Exit {};
struct Next {};
struct Assert {
  ExprPtr condition;
  std::string text;  ///< the condition as it was written, on one line
};
/// EXPECT count == 3
struct Expect {
  ExprPtr condition;
  std::string text;  ///< the condition as it was written, on one line
};
/// START blink
struct Start {
  Name task;
  Place task_place;
};
/// SIMULATE part_here = ON AFTER 2s
/// SIMULATE GO = ON AFTER 2s · SIMULATE ANSWER = "7"
struct Simulate {
  enum class What : std::uint8_t { Input, Go, Answer };

  What what = What::Input;
  Name target;  ///< of Input
  Place target_place;
  ExprPtr value;
  ExprPtr after;  ///< null: at once
};

/// A PROC that is called.
struct CallStatement {
  ExprPtr call;
};
struct Return {
  ExprPtr value;  ///< null where left out
};

/// TRY: where the body goes wrong, the rescue is executed.
struct Try {
  Block body;
  Declaration::Declared why;  ///< the name of the reason; empty where left out
  Block rescue;
};
struct Raise {
  ExprPtr value;  ///< null: the error that is being handled, again
};

struct Statement {
  Place place;  ///< of its first word
  std::variant<Move, WatchedMotion, When, Stop, Brake, Declaration, SignalDeclaration, Assign,
               Pulse, Print, Wait, If, While, For, Loop, Select, Exit, Next, Assert, Expect,
               Simulate, CallStatement, Return, Try, Raise, PointDeclaration, Teach, Halt, Ask,
               Start>
      node;
};

/// PROC, FUNC, TASK and TEST.
struct Routine {
  /// `REF a, b: LENGTH` or `n: INT = 1`.
  struct Parameters {
    bool by_reference = false;
    std::vector<Declaration::Declared> names;
    Type type;
    ExprPtr value;  ///< the default; null where left out
  };
  Place place;
  bool function = false;
  bool test = false;  ///< its name is a text
  bool task = false;
  bool sound = true;      ///< its header could be read
  std::size_t index = 0;  ///< in Program::routines
  std::string name;
  Place name_place;
  std::vector<Parameters> parameters;
  Type result;  ///< of a FUNC
  Block body;
  Place end;  ///< of ENDPROC and the like
};

/// ROBOT, UNITS and LAW: what holds for the whole program.
struct Header {
  bool robot = false;        ///< ROBOT was written; declared_robot() (robot_name.h) tells which
  std::vector<Unit> units;   ///< UNITS: of bare numbers in targets, at most one of a dimension
  std::optional<Place> law;  ///< where LAW is
  bool look_ahead = false;   ///< LAW LOOKAHEAD
};

struct Program {
  Header header;
  Block statements;
  std::vector<Routine> routines;
  /// A FRAME that a type names.
  struct FrameUse {
    const TypeDetail* frame = nullptr;
    Place place;
  };
  std::map<std::string, TypeDetail> frames{};  ///< by name in capitals; details keep their address
  std::vector<FrameUse> frame_uses{};
  std::set<std::string> taught{};  ///< names behind TEACH, in capitals
  /// Where END stands, or the end of the file if there is none.
  Place end;
};

}  // namespace rob::lang
