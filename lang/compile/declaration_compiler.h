#pragma once

#include "lang/check/checked_program.h"
#include "lang/check/symbols.h"
#include "lang/code/code_builder.h"
#include "lang/compile/expression_compiler.h"
#include "lang/compile/variables.h"
#include "lang/machine/robot_signature.h"
#include "lang/syntax/ast.h"

namespace rob::lang {

/// Code for declarations, and for TEACH, which gives a declared point another value: finds homes
/// for variables, and notes what listings and reports call things.
class DeclarationCompiler {
 public:
  DeclarationCompiler(CodeBuilder& code, Variables& variables, ExpressionCompiler& expressions,
                      const RobotSignature& robot)
      : code_(code),
        frame_(code.frame()),
        variables_(variables),
        expressions_(expressions),
        robot_(robot) {}

  /// `place`: of the statement.
  void compile(const Declaration& declaration, Place place);
  void compile(const SignalDeclaration& signal);
  void compile(const DeviceDeclaration& device);
  void compile(const PointDeclaration& declaration, Place place);
  void compile(const Teach& teach, Place place);
  /// Takes over a name that an earlier entry of the prompt has declared.
  void know(const Symbol& symbol, const KeptName& kept);

  /// A home, wherever there is room for it.
  Location declare(const Symbol& symbol);
  /// A home in registers, where instructions look for it.
  Location declare_in_registers(const Symbol& symbol);
  /// Gives listings the names of the registers.
  void name_home(const Symbol& symbol, const Location& home);

 private:
  void restore(const Symbol& symbol);
  void name_constant(const Symbol& symbol);
  void name_signal(const Symbol& symbol);
  void load_pose(const PoseValue& pose, Register first, Place place);
  void keep_joints(const Symbol& point, Place place);
  void keep_taught_joints(const Symbol& point, Register joints, Place place);

  CodeBuilder& code_;
  FrameSlots& frame_;
  Variables& variables_;
  ExpressionCompiler& expressions_;
  const RobotSignature& robot_;
};

}  // namespace rob::lang
