#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <map>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "lang/machine/motion_words.h"
#include "lang/machine/obstacle.h"
#include "lang/syntax/ast_motion.h"
#include "lang/syntax/expression_tree.h"
#include "lang/text/diagnostic.h"
#include "lang/values/pose_math.h"
#include "lang/values/types.h"
#include "lang/values/units.h"

/// The syntax tree: what was written, in the shape of the grammar (docs/rob.ebnf). The parser
/// builds it; the checker fills in `Expr::type`, the symbols and the constants; the compiler
/// reads it. The depth of a tree is bounded by the parser, so recursion over it is safe.
namespace rob::lang {

struct Statement;
using Block = std::vector<Statement>;

// ----------------------------------------------------------------- statements

/// WHEN door : lift = OFF, or WHEN door DO … ENDWHEN
struct When {
  ExprPtr condition;
  Block action;             ///< one statement, or a handler, which the checker makes a routine of
  bool handled = false;     ///< by a handler, not by the control cycle itself
  std::size_t handler = 0;  ///< set by the checker: its Routine::index
};
struct Stop {};
struct Brake {};
/// ZERO force
struct ZeroForce {};
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
  bool persist = false;  ///< PERSIST VAR: keeps its values between runs
  std::vector<Declared> names;
  std::optional<Type> type;  ///< where it was written; Unknown where the parser found it faulty
  ExprPtr value;             ///< null where left out
  ExprPtr mass{};            ///< of TOOL; null where left out
  ExprPtr cog{};             ///< of TOOL: its centre of gravity; null where left out
  std::vector<std::array<ExprPtr, 3>> shape{};  ///< of TOOL: from, to and radius of each CAPSULE
  const TypeDetail* frame = nullptr;            ///< of FRAME: what poses in it have as their detail
};
/// RECORD part … ENDRECORD
struct RecordDeclaration {
  struct Fields {
    std::vector<Declaration::Declared> names;
    Type type;
  };
  Declaration::Declared declared;
  std::vector<Fields> groups;
  TypeDetail* detail = nullptr;  ///< what values of it have as their detail
  bool sound = true;             ///< could be read
};
/// ENUM colour: red, green, blue
struct EnumDeclaration {
  Declaration::Declared declared;
  std::vector<Declaration::Declared> names;
  TypeDetail* detail = nullptr;  ///< what values of it have as their detail
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
  ExprPtr last;  ///< of a group: the number of its last channel; null where left out
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
  /// Of a compound assignment a Binary, with a copy of `target` on its left.
  ExprPtr value;
  bool compound = false;  ///< +=, -=, *=, /=
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
/// WRITE "log.csv": count, ",", t
struct Write {
  ExprPtr file;
  std::vector<ExprPtr> values;
};
/// READ "parts.csv" INTO rows
struct Read {
  ExprPtr file;
  ExprPtr target;  ///< a Name, or a Member or Index of one
};
/// DEVICE scale = "tcp://192.168.1.30:4001" ENDING "\r\n"
struct DeviceDeclaration {
  Declaration::Declared declared;
  ExprPtr address;  ///< null where it could not be read
  ExprPtr ending;   ///< null where left out
};
/// OBSTACLE table = BOX(POSE(…), 800mm, 600mm, 20mm)
struct ObstacleDeclaration {
  Declaration::Declared declared;
  Obstacle::Kind kind = Obstacle::Kind::Box;
  Place shape_place;
  std::vector<ExprPtr> values;  ///< as many as the kind takes; none where it could not be read
  Obstacle obstacle;            ///< set by the checker
};
/// ALLOW gripper, part DO
struct Allow {
  std::vector<Declaration::Declared> bodies;
  Block body;
};
/// SEND scale: "W"
struct Send {
  Name device;
  Place device_place;
  std::vector<ExprPtr> values;
};
/// RECEIVE scale INTO line TIMEOUT 2s ELSE line = ""
struct Receive {
  Name device;
  Place device_place;
  ExprPtr target;  ///< a Name, or a Member or Index of one
  ExprPtr timeout;
  bool has_else = false;
  Block otherwise;  ///< of ELSE: one statement
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
  bool has_else = false;
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
  ExprPtr elements{};              ///< of FOR x IN a; null in one that counts
  ExprPtr from;
  ExprPtr to;
  ExprPtr step;  ///< null: 1
  Block body;
  bool turns = false;  ///< set by the checker: once at least, as its range is constant
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
  enum class What : std::uint8_t { Input, Go, Answer, Device };

  What what = What::Input;
  Name target;  ///< of Input
  Place target_place;
  std::string part{};  ///< "z" of force.z; empty for an input
  Place part_place{};
  int component = 0;  ///< of a part, set by the checker: force x y z, torque x y z
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

/// USE tools
struct Use {
  std::string name;
  std::uint32_t file = 0;  ///< its number; 0 where it could not be read
  /// What the file declares, if this is the first USE of it in the whole program.
  Block declarations;
};

struct Statement {
  Place place;  ///< of its first word
  std::variant<Move, PlainMotions, WatchedMotion, When, Stop, Brake, Declaration, SignalDeclaration,
               Assign, Pulse, Print, Wait, If, While, For, Loop, Select, Exit, Next, Assert, Expect,
               Simulate, CallStatement, Return, Try, Raise, PointDeclaration, Teach, ZeroForce, Use,
               PathBlock, WayPoint, Press, With, SetOverride, Load, RecordDeclaration, Halt, Ask,
               Write, Read, DeviceDeclaration, Send, Receive, Start, Defaults, EnumDeclaration,
               ObstacleDeclaration, Allow>
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
  bool handler = false;   ///< of the WHEN at `place`; it has no name in the program
  bool sound = true;      ///< its header could be read
  bool whole = true;      ///< and so could every line of it
  std::size_t index = 0;  ///< in Program::routines
  std::string name;
  Place name_place;
  std::vector<Parameters> parameters;
  Type result;  ///< of a FUNC
  Block body;
  Place end;              ///< of ENDPROC and the like
  bool memory = false;    ///< set by the checker: not all it computes with fits into registers
  bool outdated = false;  ///< a TASK of an earlier entry, which declares anew what it uses
  // Of a handler, set by the checker:
  bool stops = false;                   ///< the axes stop before it begins
  std::vector<const Symbol*> captured;  ///< variables of the routine around it that it uses
};

/// ROBOT, UNITS and LAW: what holds for the whole program.
struct Header {
  bool robot = false;       ///< ROBOT was written; declared_robot() (robot_name.h) says which
  std::vector<Unit> units;  ///< UNITS: of bare numbers in targets, at most one of a dimension
  struct Law {
    Place place;
    TransitionLaw law = TransitionLaw::Paul;
  };
  std::optional<Law> law;
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
  /// The length in a type ARRAY[n] OF t, which the checker computes.
  struct ArrayLength {
    TypeDetail* array = nullptr;
    ExprPtr length;
    Place place;
    bool settled = false;
  };
  /// Shared with the Chunk, whose types go on pointing into it.
  std::shared_ptr<TypeTable> types = std::make_shared<TypeTable>();
  std::vector<ArrayLength> array_lengths{};
  bool memory = false;  ///< as of Routine, of the top level
  std::vector<FrameUse> frame_uses{};
  std::set<std::string> taught{};  ///< names after TEACH, in capitals
  bool surroundings = false;       ///< WITH or IN stand somewhere: routines may run in them
  /// Where END stands, or the end of the file if there is none.
  Place end;
  std::size_t nodes = 0;  ///< statements and expressions read so far, in the files before, too
  std::size_t names = 0;  ///< declared so far, in the same
  bool whole = true;      ///< all that it USEs could be read
  /// From this line on it is an entry of the prompt: what stands before has been executed, and its
  /// names may be declared anew. 0: it is a program.
  std::uint32_t entry = 0;
  /// It begins at this line: of the statements before only the declarations are executed.
  std::uint32_t from = 0;
  std::vector<Program> used{};                  ///< what is left of the files that it USEs
  std::vector<std::vector<Unit>> used_units{};  ///< UNITS of each file, its own first
};

}  // namespace rob::lang
