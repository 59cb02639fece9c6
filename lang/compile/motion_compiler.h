#pragma once

#include <array>
#include <vector>

#include "lang/check/meaning.h"
#include "lang/check/symbols.h"
#include "lang/code/code_builder.h"
#include "lang/compile/expression_compiler.h"
#include "lang/compile/open_blocks.h"
#include "lang/compile/variables.h"
#include "lang/machine/robot_signature.h"
#include "lang/syntax/ast.h"

namespace rob::lang {

/// Code for motions: their values into registers, in the order of MoveForm, and what they are
/// surrounded by: tools, frames, and the clauses of a PATH.
class MotionCompiler {
 public:
  MotionCompiler(CodeBuilder& code, Variables& variables, ExpressionCompiler& expressions,
                 OpenScopes& blocks, const RobotSignature& robot)
      : code_(code),
        frame_(code.frame()),
        variables_(variables),
        expressions_(expressions),
        blocks_(blocks),
        robot_(robot),
        elements_(elements_of(robot)) {}

  void compile(const Move& move, Place place);
  void compile(const PlainMotions& motions);
  /// Without its surroundings.
  void compile_motion(const Move& move, Place place);

  /// WITH and IN, of a block or a motion.
  void enter(const Surroundings& surroundings, Place place);
  void leave(const Surroundings& surroundings, Place place);
  /// The clauses of a WITH, which hold for its motions, and those of DEFAULT.
  void begin_defaults(const Clauses& clauses, Place place);
  void end_defaults(const Clauses& clauses, Place place);
  void set_defaults(const Clauses& clauses, Place place);
  /// The motions between these two calls are planned as one. The caller gives the registers of the
  /// clauses back.
  void begin_path(const PathBlock& path, Place place);
  void end_path(Place place);

 private:
  // Targets
  void compile_to(const Move& move, const Symbol* taught, Place place);
  void compile_via(const Expr& point, Place place);
  CodeBuilder::Jumps unless_at_joints(const Symbol& point, const Expr& target, Place place);
  /// The joints that a point was taught with: what the points file says, or TEACH has found.
  Register compile_taught(const Symbol& point, MoveForm& form, Place place);
  Register compile_way(const Move& move, MoveForm& form);
  Register compile_rates(const Move& move, MoveForm& form);
  Register compile_axis(const Move& move, MoveForm& form);
  Register compile_target(const Expr& target, MoveForm& form);
  Register compile_value(const Expr& target, MoveForm& form);
  void compile_component(const Expr& component, Dimension dimension, Register target);
  Register registers_for(const std::vector<const Tuple::Element*>& elements, MoveForm& form);

  // Clauses
  const Expr* live_pace(const Clauses& clauses) const;
  void compile_live(const Expr& pace);
  void compile_clauses(const Clauses& clauses, MoveForm& form);
  void compile_near(const Expr& joints, MoveForm& form);
  void emit_defaults(Opcode opcode, const Clauses& clauses, Place place);
  void compile_clause(Clause clause, const Expr& said, Register target);

  CodeBuilder& code_;
  FrameSlots& frame_;
  Variables& variables_;
  ExpressionCompiler& expressions_;
  OpenScopes& blocks_;
  const RobotSignature& robot_;
  const Coordinates elements_;                    ///< of a target
  const PathBlock* path_ = nullptr;               ///< around the motion; null outside of PATH
  std::array<Register, kClauses> path_values_{};  ///< of its clauses
};

}  // namespace rob::lang
