#pragma once

#include <cstddef>
#include <map>
#include <type_traits>

#include "lang/check/checked_program.h"
#include "lang/code/code_builder.h"
#include "lang/compile/declaration_compiler.h"
#include "lang/compile/expression_compiler.h"
#include "lang/compile/motion_compiler.h"
#include "lang/compile/open_blocks.h"
#include "lang/compile/variables.h"
#include "lang/compile/world_code.h"
#include "lang/machine/robot_signature.h"
#include "lang/syntax/ast.h"

namespace rob::lang {

/// It is no code.
template <typename Node>
concept IsTypeDeclaration = std::is_same_v<Node, RecordDeclaration> ||
    std::is_same_v<Node, EnumDeclaration> || std::is_same_v<Node, ObstacleDeclaration>;
template <typename Node>
concept IsChannel =
    std::is_same_v<Node, SignalDeclaration> || std::is_same_v<Node, DeviceDeclaration>;
/// A statement that is one instruction.
template <typename Node>
concept IsWordAlone =
    std::is_same_v<Node, Stop> || std::is_same_v<Node, Brake> || std::is_same_v<Node, ZeroForce>;

/// Code for statements, one compile() for each kind, and for routines.
class StatementCompiler {
 public:
  StatementCompiler(CodeBuilder& code, Variables& variables, WorldCode& world,
                    ExpressionCompiler& expressions, const Program& program,
                    const RobotSignature& robot);

  void compile(const Statement& statement) {
    place_ = statement.place;
    std::visit([&](const auto& node) { compile(node); }, statement.node);
  }
  void compile(const Routine& routine);

  // Entries of a prompt
  /// Takes over a name that an earlier entry has declared.
  void know(const Symbol& symbol, const KeptName& kept) { declarations_.know(symbol, kept); }
  /// Registers, memory and WHENs that come now lie after those of earlier entries.
  void begin_behind(const Room& room);
  /// All that is taken at the top level, and armed.
  Room room() const;
  /// RETURN at the top level arrives here.
  void land_end() { blocks_.land_end(); }

 private:
  /// Gives back at the end of a block what it has declared.
  void compile(const Block& block);

  // Motions
  void compile(const Move& move) { motions_.compile(move, place_); }
  void compile(const PlainMotions& motions) { motions_.compile(motions); }
  void compile(const WatchedMotion& watched);
  void compile(const WayPoint& event);
  void compile(const With& with);
  void compile(const Defaults& defaults);
  void compile(const PathBlock& path);
  void compile(const Press& press);
  void compile(const SetOverride& statement);
  void compile(const Load& load);
  template <IsWordAlone Node>
  void compile(const Node& /*word*/) {
    code_.emit(std::is_same_v<Node, Stop>    ? Opcode::stop
               : std::is_same_v<Node, Brake> ? Opcode::brake
                                             : Opcode::zero_force,
               place_);
  }

  // Names and values
  void compile(const Declaration& declaration) { declarations_.compile(declaration, place_); }
  template <IsChannel Node>
  void compile(const Node& channel) {
    declarations_.compile(channel);
  }
  void compile(const PointDeclaration& points) { declarations_.compile(points, place_); }
  template <IsTypeDeclaration Node>
  void compile(const Node& /*type*/) {}
  void compile(const Use& use) {
    for (const Statement& statement : use.declarations) compile(statement);
  }
  void compile(const Teach& teach) { declarations_.compile(teach, place_); }
  void compile(const Assign& assign);
  void compile(const Pulse& pulse);
  void compile(const Print& print);
  void compile(const Write& write);
  void compile(const Allow& allow);
  void compile(const Send& send);
  void compile(const Receive& receive);
  void compile(const Read& read);
  /// A text of all the values, one after the other.
  Register joined(const std::vector<ExprPtr>& values, Place place);

  // HALT, ASK, and TESTs
  void compile(const Halt& halt);
  void compile(const Ask& ask);
  void compile(const Assert& assertion);
  void compile(const Expect& expectation);
  void compile(const Simulate& simulation);
  void simulate(const Simulate& simulation, Register value);

  // Flow
  void compile(const Wait& wait);
  void wait_for_condition(const Wait& wait);
  void compile(const If& conditional);
  void compile(const Select& select);
  void compile(const While& loop);
  void compile(const For& loop);
  void compile_elements(const For& loop);
  void compile(const Loop& loop);
  /// Code for the body; NEXT arrives after it.
  void compile_body(const Block& body);
  void compile(const Exit&) { blocks_.exit_loop(place_); }
  void compile(const Next&) { blocks_.next_turn(place_); }
  void compile(const Try& statement);
  void compile(const Raise& statement);

  // Routines, TASKs and handlers
  void settle_parameters(const Routine& routine);
  void compile(const CallStatement& statement) { expressions_.call(*statement.call); }
  void compile(const Return& statement);
  void compile(const Start& start);
  void compile(const When& when);
  Register capture(const Routine& handler);
  void settle_captured(const Routine& handler);

  const Program& program_;
  CodeBuilder& code_;
  FrameSlots& frame_;
  Variables& variables_;
  WorldCode& world_;
  ExpressionCompiler& expressions_;
  OpenScopes blocks_;
  MotionCompiler motions_;
  DeclarationCompiler declarations_;
  Place place_;  ///< of the current statement: its line is what the Machine is given
  const Routine* routine_ = nullptr;                 ///< null at the top level
  std::map<std::size_t, std::size_t> task_numbers_;  ///< of TASKs, by their Routine::index
};

}  // namespace rob::lang
