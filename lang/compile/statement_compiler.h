#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <map>
#include <optional>
#include <vector>

#include "lang/check/checker.h"
#include "lang/code/code_builder.h"
#include "lang/compile/compiler.h"
#include "lang/compile/expression_compiler.h"
#include "lang/machine/robot_signature.h"
#include "lang/syntax/ast.h"
#include "lang/text/diagnostic.h"

namespace rob::lang {

/// Private to the compiler: code for statements, one compile() for each kind.
class StatementCompiler {
 public:
  StatementCompiler(const CheckedProgram& checked, const RobotSignature& robot,
                    const EntryRooms* rooms);

  Generated compile(const Program& program, Diagnostics& diagnostics);

 private:
  void compile_top_level(const Program& program);
  void know(const CheckedProgram::Known& known);
  void compile_entry(const Program& program);
  void begin_behind(const Room& room);
  /// What a block declares is given back at its end.
  void compile(const Block& block) {
    const auto mark = code_.mark();
    const std::size_t whens = whens_;
    for (const Statement& statement : block) compile(statement);
    leave_whens(whens);
    whens_ = whens;
    code_.release(mark);
  }
  void compile(const Statement& statement) {
    place_ = statement.place;
    std::visit([&](const auto& node) { compile(node); }, statement.node);
  }

  void compile(const Move& move);
  void compile(const PlainMotions& motions);
  void compile_motion(const Move& move);
  void compile_motion(const Move& move, const Symbol* taught);
  const Expr* live_pace(const Clauses& clauses) const;
  std::vector<CodeBuilder::Jump> unless_at_joints(const Symbol& point, const Expr& target);
  Register compile_taught(const Symbol& point, MoveForm& form);
  void compile(const WatchedMotion& watched);
  void compile(const When& when);
  Register capture(const Routine& handler);
  static int captures_of(const Routine& handler);
  void settle_captured(const Routine& handler);
  void compile(const WayPoint& event);
  void compile_live(const Expr& pace);
  /// Code that disarms what was armed in this frame beyond the first `kept`.
  void leave_whens(std::size_t kept);
  // WITH, PATH, PRESS, OVERRIDE (compile_surroundings.cpp)
  void enter(const Surroundings& surroundings);
  void leave(const Surroundings& surroundings, Place place);
  void compile(const With& with);
  void compile(const PathBlock& path);
  void compile(const Press& press);
  void compile(const SetOverride& statement);
  void compile(const Load& load);
  /// Code that leaves the WITHs and PRESSes of this frame beyond the first `kept`.
  void leave_scopes(std::size_t kept, Place place);
  void compile(const Stop&) { code_.emit(Opcode::stop, place_); }
  void compile(const Brake&) { code_.emit(Opcode::brake, place_); }
  // HALT and ASK (compile_operator.cpp)
  void compile(const Halt& halt);
  void compile(const Ask& ask);
  void simulate_operator(const Simulate& simulation, Register value);
  void compile(const Declaration& declaration);
  void compile(const SignalDeclaration& signal);
  void compile(const Use& use) {
    for (const Statement& statement : use.declarations) compile(statement);
  }
  // POINT and TEACH (compile_points.cpp)
  void compile(const PointDeclaration& declaration);
  void compile(const Teach& teach);
  void compile(const ZeroForce&) { code_.emit(Opcode::zero_force, place_); }
  void load_pose(const PoseValue& pose, Register first, Place place);
  void keep_joints(const Symbol& point);
  void teach_joints(const Symbol& point);
  void compile(const Assign& assign);
  void compile(const RecordDeclaration&) {}
  void compile(const Pulse& pulse);
  void compile(const Print& print);
  void compile(const Wait& wait);
  void wait_for_condition(const Wait& wait);
  void compile(const If& conditional);
  void compile(const While& loop);
  void compile(const For& loop);
  void compile(const Loop& loop);
  void compile(const Select& select);
  void compile(const Exit&);
  void compile(const Next&);
  void compile(const Assert& assertion);

  void compile(const Try& statement);
  void compile(const Raise& statement);
  /// Code that leaves the TRY and RESCUE blocks which are open beyond the first `kept`.
  void leave_guards(std::size_t kept, Place place);

  void compile(const CallStatement& statement) { expressions_.call(*statement.call); }
  void compile(const Return& statement);
  void compile(const Routine& routine);

  // TASK (compile_tasks.cpp)
  void compile(const Start& start);
  /// A variable has a new value, which TASKs see if they use it.
  void publish(const Symbol& symbol, Place place);

  // TEST (compile_tests.cpp)
  void compile_test_entry(const Program& program);
  void compile_variables(const Block& statements);
  void compile(const Expect& expectation);
  void compile(const Simulate& simulation);

  /// What EXIT and NEXT of an open loop jump to is known at its end.
  struct LoopJumps {
    CodeBuilder::Jumps exits;
    CodeBuilder::Jumps nexts;
    std::size_t whens = 0;   ///< that were armed in this frame when it began
    std::size_t guards = 0;  ///< open around the loop
    std::size_t scopes = 0;  ///< the same of WITH and PRESS
  };
  enum class Guard : std::uint8_t { Try, Rescue };
  /// Code for the body; NEXT arrives behind it.
  void compile_body(const Block& body);
  /// EXIT arrives here: behind the loop.
  void leave_loop();

  Location declare(const Symbol& symbol);
  /// What instructions look for in registers.
  Location declare_in_registers(const Symbol& symbol);
  void name_home(const Symbol& symbol, const Location& home);
  void name_constant(const Symbol& symbol);
  void name_signal(const Symbol& symbol);
  void compile_via(const Expr& point, Place place);
  Register compile_way(const Move& move, MoveForm& form);
  Register compile_rates(const Move& move, MoveForm& form);
  Register registers_for(const std::vector<const Tuple::Element*>& elements, MoveForm& form);
  Register compile_axis(const Move& move, MoveForm& form);
  Register compile_target(const Expr& target, MoveForm& form);
  Register compile_value(const Expr& target, MoveForm& form);
  void compile_clause(Clause clause, const Expr& said, Register target);
  void compile_clauses(const Clauses& clauses, MoveForm& form);
  void compile_component(const Expr& component, Dimension dimension, Register target);
  void report_limit(Diagnostics& diagnostics) const;

  const Program& program_;
  const RobotSignature& robot_;
  CodeBuilder code_;
  ExpressionCompiler expressions_;
  Place place_;  ///< of the present statement: its line is what the Machine is told
  std::vector<LoopJumps> loops_;
  std::size_t whens_ = 0;    ///< WHENs of this frame whose block is open
  const EntryRooms* rooms_;  ///< null if it is no entry of the prompt
  Room room_;                ///< what the entry leaves taken
  enum class Scope : std::uint8_t { With, Press };
  std::vector<Scope> scopes_;        ///< WITHs and PRESSes that are open, of the present routine
  const PathBlock* path_ = nullptr;  ///< around the motion; null outside of PATH
  std::array<Register, kClauses> path_values_{};  ///< of its clauses
  std::vector<Guard> guards_;                     ///< blocks that are open, of the present routine
  const Routine* routine_ = nullptr;              ///< that is being compiled; null at the top level
  std::map<std::size_t, std::size_t> task_numbers_;  ///< of TASKs, by their Routine::index
  CodeBuilder::Jumps returns_;  ///< RETURN at the top level: the end of the program
};

}  // namespace rob::lang
