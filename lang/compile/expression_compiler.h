#pragma once

#include <cstdint>
#include <optional>
#include <utility>
#include <vector>

#include "lang/check/symbols.h"
#include "lang/code/code_builder.h"
#include "lang/code/location.h"
#include "lang/compile/operand_code.h"
#include "lang/compile/variables.h"
#include "lang/compile/world_code.h"
#include "lang/syntax/ast.h"
#include "lang/values/builtins.h"

namespace rob::lang {

/// Code for expressions. A value ends up in number registers (one for BOOL, INT and REAL, several
/// in a row for VEC and the like) or a text register (STRING), as the checker has settled.
///
/// into() overwrites nothing of its target before all operands have been read, so a variable can be
/// computed from itself in place.
class ExpressionCompiler : private OperandCode {
 public:
  ExpressionCompiler(CodeBuilder& code, Variables& variables, WorldCode& world)
      : code_(code), frame_(code.frame()), variables_(variables), world_(world) {}

  /// Every expression of a statement begins here: its observations belong to one control cycle.
  /// With `as_real` an INT becomes a REAL.
  void value_into(const Expr& expression, Register target, bool as_real = false);
  /// The register of a variable, or a new one with the value of the expression.
  Register value(const Expr& expression, bool as_real = false);
  /// Appends the value, as PRINT writes it, to a text register.
  void append_value(const Expr& expression, Register text);
  /// A call that is a statement of its own.
  void call(const Expr& expression);

  /// Where an array lies; what is no variable is computed, and stays till its slots are given back.
  Location array(const Expr& expression);
  /// Gives a variable or a part of one, wherever it lives, the value of an expression.
  void assign(const Expr& target, const Expr& value);
  /// READ: the file in a text register fills a variable.
  void read_rows(const Expr& target, Register file, Place place);
  /// Gives a variable, or a part of one, the value of a register.
  void assign_register(const Expr& target, Register value);
  /// A compound assignment: `value` is a Binary with a copy of `target` on its left.
  void change(const Expr& target, const Expr& value);
  /// Gives a new variable the value of an expression, which cannot use it.
  void initialise(const Expr& value, const Location& home, const Type& type);

  /// Jumps that are taken if the condition has the value `when`; else execution goes on after them.
  CodeBuilder::Jumps jumps_if(const Expr& condition, bool when);
  /// A jump that is taken if the value equals that of a register of its kind; `as_real` as above.
  CodeBuilder::Jump jump_if_equal(Register selector, const Expr& value, bool as_real);
  /// A comparison whose sides stay at hand; `holds`: the jumps that are taken if it is TRUE.
  struct Compared {
    CodeBuilder::Jumps holds;
    Register left;
    Register right;
    bool real;  ///< both sides are REAL slots
  };
  /// Empty if the condition is no comparison of two values that PRINT can write.
  std::optional<Compared> compare(const Expr& condition);

  /// Code for a condition that is evaluated in every control cycle; `values` is where the values
  /// begin that its variables have now.
  struct WatchCode {
    std::uint16_t index;
    Register values;
  };
  WatchCode watch(const Expr& condition);

 private:
  void begin(const Expr& expression);
  void begin_place(const Expr& target);

  // Values
  void into(const Expr& expression, Register target, bool as_real) override;
  void into_as_it_is(const Expr& expression, Register target, bool as_real);
  Register operand(const Expr& expression, bool as_real) override;
  /// The same where `then` is computed before the value is used: what that changes is no matter.
  Register operand_before(const Expr& then, const Expr& expression, bool as_real) override;
  void append(const Expr& expression, Register text);
  void compile(const Name& name, const Expr& expression, Register target);
  void compile_truth(const Expr& expression, Register target);

  // Operations
  void compile(const Unary& unary, const Expr& expression, Register target);
  void compile(const Binary& binary, const Expr& expression, Register target);
  void compile(const Chain& chain, const Expr& expression, Register target);
  void compile_on_vectors(const Binary& binary, const Expr& expression, Register target);
  void compile_on_poses(const Binary& binary, const Expr& expression, Register target);

  // Poses, VECs and JOINTS
  void compile(const Tuple& tuple, Register target);
  void into_world(const Expr& expression, Register target);
  void into_other_place(const Expr& expression, Register target);
  void compile_joints(const Call& call, const Expr& expression, Register target);
  void compile_csv(const Call& call, Register target, Place place);

  // Calls
  void compile(const Call& call, const Expr& expression, Register target);
  void call_on_numbers(const Builtin& builtin, const Call& call, const Expr& expression,
                       Register target);
  void call_on_texts(const Builtin& builtin, const Call& call, const Expr& expression,
                     Register target);
  void call_procedure(const Call& call, Place place);
  void change_list(BuiltinRule rule, const Call& call, Place place);
  /// Where the elements of an array lie, and how many they are, in three registers (opcodes.def).
  Register row(const Expr& expression);
  void draw(const Call& call, const Expr& expression, Register target);
  Location call_routine(const Call& call, const Expr& expression);
  /// Returns how many lists are held then.
  int pass(const Call& call, std::size_t parameter, const Location& home, Register first,
           Register first_text);

  // Conditions (expression_conditions.cpp)
  CodeBuilder::Jumps jumps(const Expr& condition, bool when);
  CodeBuilder::Jumps jumps_of_logical(const Binary& binary, bool when);
  CodeBuilder::Jumps jumps_of_comparison(const Binary& binary, bool when, Place place);
  CodeBuilder::Jumps jumps_of_compounds(const Binary& binary, bool when, Place place);
  CodeBuilder::Jumps jumps_of_memory(const Binary& binary, bool when, Place place);

  // Arrays, records, and parts of variables
  /// Where a value lies; what is no variable is computed into registers of its own.
  Location locate(const Expr& expression);
  /// `keep`: what is computed later may change the variable that it is.
  Location located_as(const Expr& expression, const Type& type, bool keep);
  Location element(const Index& index);
  void load_element(const Index& index, Register target, Place place);
  /// `value`: a register, or the index of a constant.
  void store_element(Opcode opcode, const Index& index, std::uint8_t value, Place place);
  /// A value into slots, wherever they lie, that hold nothing which it needs.
  void put(const Expr& value, const Location& to, const Type& type);
  void put_list(const Expr& value, const Location& to, const Type& type);
  void put_record(const Call& call, const Location& to, Place place);
  void assign_memory(const Expr& target, const Expr& value);
  /// An element becomes a number that is known; false if there is no such instruction for it.
  bool assign_constant_element(const Expr& target, const Expr& value);

  CodeBuilder& code_;
  FrameSlots& frame_;
  Variables& variables_;
  WorldCode& world_;
  /// Indices of the place of a compound assignment, and the registers that hold their values.
  std::vector<std::pair<const Expr*, Register>> settled_;
};

}  // namespace rob::lang
