#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <string_view>
#include <vector>

#include "lang/machine/motion_words.h"
#include "lang/machine/move_command.h"
#include "lang/text/diagnostic.h"

/// The part of the syntax tree (lang/syntax/ast.h) that is motions and what lies around them.
namespace rob::lang {

struct Expr;
struct Statement;
using ExprPtr = std::unique_ptr<Expr>;
using Block = std::vector<Statement>;

/// Clauses of a motion that have a value, in the order of its registers (MoveForm).
enum class Clause : std::uint8_t { At, Over, Accel, Jerk, Zone, ZoneAngle, Fine, For };
inline constexpr std::size_t kClauses = 8;

/// WITH cup IN pallet: the tool that moves, and the frame of what has none of its own.
struct Surroundings {
  ExprPtr tool;          ///< a Name; null where left out
  ExprPtr frame;         ///< a Name; null where left out, and of IN TOOL
  bool in_tool = false;  ///< IN TOOL
  Place frame_place{};   ///< of what stands after IN
  bool none() const { return tool == nullptr && frame == nullptr && !in_tool; }
  bool has_frame() const { return frame != nullptr || in_tool; }
};

struct Clauses {
  std::array<ExprPtr, kClauses> values;  ///< by Clause; null where left out
  Surroundings surroundings;
  Profile profile = Profile::Unspecified;
  bool fine = false;
  bool euler = false;  ///< EULER: of MOVEL
  Place euler_place{};
  FreeTurn free = FreeTurn::None;  ///< FREE
  Place free_place{};
  ExprPtr near;  ///< NEAR: of JOINTS; null where left out
  Place near_place{};
  bool live = false;  ///< AT LIVE: computed anew in every control cycle
  Place live_place{};

  /// Whether the motion comes to rest at its target whatever follows; so does ZONE 0mm.
  bool at_rest() const { return fine || profile != Profile::Unspecified; }
  const ExprPtr& operator[](Clause clause) const {
    return values[static_cast<std::size_t>(clause)];
  }
  ExprPtr& operator[](Clause clause) { return values[static_cast<std::size_t>(clause)]; }
};
/// MOVE(40, 40, 0) · MOVEL BY (20mm, 0mm, 0deg) · MOVE JOINT 3 TO 90deg · MOVES VIA p, q TO r ·
/// SPIRAL FROM 4mm TURNS 5 · JOG WORLD (x: 5mm/s) FOR 2s
struct Move {
  MotionKind kind = MotionKind::Joint;
  bool by = false;           ///< BY: from the last commanded target
  ExprPtr axis;              ///< of MOVE JOINT; null else
  ExprPtr target;            ///< a Tuple or a value; of MOVE JOINT the axis' value; null of SPIRAL
  std::vector<ExprPtr> via;  ///< of MOVEC and MOVES: the points before the target
  ExprPtr radius;            ///< of SPIRAL
  ExprPtr turns;             ///< of SPIRAL
  JogFrame jog{};            ///< of JOG, whose target are the rates
  Clauses clauses;
};
/// MOVE(140, 40, 0), and further motions of this kind on the lines that follow it: in numbers
/// alone, and kept so (plain_motion.h).
struct PlainMotions {
  struct Written {
    std::uint32_t offset = 0;  ///< of its first letter in the source, bytes
    std::uint32_t line = 0;
    std::uint32_t column = 0;
    MotionKind kind = MotionKind::Joint;
    std::uint8_t given = 0;  ///< set by the checker: as in MoveCommand
    MoveCommand::Pace pace = MoveCommand::Pace::Unspecified;
    MoveCommand::Zone zone = MoveCommand::Zone::Unspecified;
  };
  std::string_view source;  ///< that all of them stand in
  std::uint32_t file = 0;   ///< its number
  std::vector<Written> motions;
  std::vector<double> paces_and_zones{};  ///< of those that have them, in order, SI
  /// Set by the checker: the given components of all, SI, in order, after those of each its AT and
  /// its ZONE.
  std::vector<double> values{};

  Place place(const Written& motion) const {
    return {motion.line, motion.column, static_cast<std::uint32_t>(word_of(motion.kind).size()),
            file};
  }
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
/// PATH AT 8mm/s DO: its clauses are the defaults of the motions in it.
struct PathBlock {
  Clauses clauses;
  Block body;
};
/// PRESS Z 10N LIMIT 5mm/s DO
struct Press {
  int axis = 0;  ///< 0, 1, 2 for X, Y, Z
  ExprPtr force;
  ExprPtr limit;              ///< null where left out
  Surroundings surroundings;  ///< of the axis: IN alone
  Block body;
};
/// WITH cup IN pallet AT 50mm/s DO: its clauses are the defaults of all motions until its end.
struct With {
  Clauses clauses;
  Block body;
};
/// DEFAULT AT 200mm/s ZONE 1mm: the defaults of all motions of the program.
struct Defaults {
  Clauses clauses;
};
/// LOAD 2kg COG (0mm, 0mm, 150mm)
struct Load {
  ExprPtr mass;
  ExprPtr cog;  ///< null where left out
};
/// OVERRIDE 30%
struct SetOverride {
  ExprPtr share;
};

}  // namespace rob::lang
