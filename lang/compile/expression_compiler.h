#pragma once

#include <optional>
#include <vector>

#include "lang/check/symbols.h"
#include "lang/code/code_builder.h"
#include "lang/code/location.h"
#include "lang/syntax/ast.h"
#include "lang/values/builtins.h"

namespace rob::lang {

/// Code for expressions. A value ends up in number registers (one for BOOL, INT and REAL, several
/// in a row for VEC and the like) or a text register (STRING), as the checker has settled.
///
/// Of the targets given to into() nothing is overwritten before all operands have been read, so a
/// variable can be computed from itself in place.
class ExpressionCompiler {
 public:
  ExpressionCompiler(CodeBuilder& code, std::size_t symbols) : code_(code), homes_(symbols) {}

  /// Where a variable lives, from its declaration on.
  void settle(const Symbol& symbol, const Location& home) { homes_[symbol.id] = home; }
  /// By Symbol::id.
  const std::vector<Location>& homes() const { return homes_; }

  /// From here on the code belongs to a routine: globals lie in another frame.
  void enter_routine() { in_routine_ = true; }
  /// Gives a variable or a part of one, wherever it lives, the value of an expression.
  void assign(const Expr& target, const Expr& value);
  /// Gives a variable, or a part of one, the value of a register.
  void assign_register(const Expr& target, Register value);
  /// Gives a variable the value of another one of its type.
  void copy(const Location& from, const Location& to, const Type& type, Place place);
  /// Gives a new variable the value of an expression, which cannot use it.
  void initialise(const Expr& value, const Location& home, const Type& type);
  /// 0, FALSE, "".
  void clear(const Location& home, const Type& type, Place place);
  /// Slots of the memory of the present frame.
  Location memory(Slots slots, Place place);
  /// Brings a whole array or record from one place to another.
  void copy_memory(const Location& to, const Location& from, Slots slots, Place place);
  /// A comparison whose sides stay at hand; `holds`: the jumps that are taken if it is TRUE.
  struct Compared {
    CodeBuilder::Jumps holds;
    Register left;
    Register right;
    bool real;  ///< both sides are REAL slots
  };
  /// Empty if the condition is no comparison of two values that PRINT can write.
  std::optional<Compared> compare(const Expr& condition);
  /// Appends the value of a register, as PRINT writes it, to a text register.
  void append_register(Register value, const Type& type, bool real, Register text, Place place);
  /// SIMULATE of an input: its value in `value`, which is overwritten, the delay behind it.
  void simulate(const Symbol& symbol, Register value, Place place);
  /// SIMULATE of a part of the force or the torque.
  void simulate_force(int component, Register value, Place place) {
    code_.emit(Opcode::simulate_force, place, value, static_cast<unsigned>(component));
  }
  /// Gives an output the value of a register, in motion order.
  void write_signal(const Symbol& symbol, Register value, Place place);
  /// The place of a variable's number slots, or text slots.
  void refer(const Symbol& symbol, bool text, Register target, Place place) {
    const Location at = home(symbol);
    refer(text ? at.texts : at.numbers, text, target, place);
  }
  /// A call that is a statement of its own.
  void call(const Expr& expression);

  /// Every expression of a statement begins here: its observations belong to one control cycle.
  /// With `as_real` an INT becomes a REAL.
  void value_into(const Expr& expression, Register target, bool as_real = false);
  /// The register of a variable, or a new one with the value of the expression.
  Register value(const Expr& expression, bool as_real = false);
  /// Appends the value, as PRINT writes it, to a text register.
  void append_value(const Expr& expression, Register text);
  /// Jumps that are taken if the condition has the value `when`; else execution goes on behind.
  CodeBuilder::Jumps jumps_if(const Expr& condition, bool when);
  /// A jump that is taken if the value equals that of a register of its kind; `as_real` as above.
  CodeBuilder::Jump jump_if_equal(Register selector, const Expr& value, bool as_real);

  /// Code for a condition that is evaluated in every control cycle; `values` is where the values
  /// begin that its variables have now.
  struct WatchCode {
    std::uint16_t index;
    Register values;
  };
  WatchCode watch(const Expr& condition);

  /// TASKs see the present value of a variable that they use.
  void publish(const Symbol& symbol, Place place);

  /// What lies in registers becomes the value of a point or of another variable.
  void store_variable(const Symbol& variable, Register value, Place place) {
    store(home(variable), variable.type, value, place);
    publish(variable, place);
  }
  /// The value of a variable of numbers, into registers.
  void load_variable(const Symbol& variable, Register target, Place place) {
    load(home(variable), variable.type, target, place);
  }
  /// The same into new ones.
  Register variable(const Symbol& variable, Place place) {
    const Register target = result_register(variable.type);
    load_variable(variable, target, place);
    return target;
  }

 private:
  void into(const Expr& expression, Register target, bool as_real);
  void into_as_it_is(const Expr& expression, Register target, bool as_real);
  Register operand(const Expr& expression, bool as_real);
  /// A number that is known, as an operand of 8 bits; none if it is not, or there is no room.
  std::optional<std::uint8_t> constant_operand(const Expr& expression, bool as_real);
  bool compile_by_constant(const Binary& binary, const Expr& expression, Register target);
  /// A sum or difference with a product in one instruction; false if it is no such thing.
  bool compile_with_product(const Binary& binary, const Expr& expression, Register target);
  /// Whether a value that is read in the end lies in a register of its own.
  bool stays_in_register(const Expr& expression) const;
  /// The same where `then` is computed before the value is used: what that changes is no matter.
  Register operand_before(const Expr& then, const Expr& expression, bool as_real);

  // Routines (compile_calls.cpp)
  Location call_routine(const Call& call, const Expr& expression);
  /// Registers for the places of a value.
  void pass_places(const Location& at, const Type& type, const Location& home, Register first,
                   Place place);
  void load(const Expr& expression, Register target, bool as_real);
  void append(const Expr& expression, Register text);

  // Places (compile_places.cpp)
  Location home(const Symbol& symbol) const;
  /// Whether an expression is a variable, or a part of one.
  bool is_variable(const Expr& expression) const;
  /// Where a value lies; what is no variable is computed into registers of its own.
  Location locate(const Expr& expression);
  Location temporary(const Type& type, Place place);
  Location element(const Index& index);
  SlotsAt element_at(SlotsAt whole, bool text, Register which, std::int64_t count, int size,
                     Place place);
  void refer(SlotsAt at, bool text, Register target, Place place);
  void load(const Location& from, const Type& type, Register target, Place place);
  void store(const Location& to, const Type& type, Register value, Place place);
  void load_numbers(SlotsAt from, Register target, int count, Place place);
  void store_numbers(SlotsAt to, Register value, int count, Place place);
  void copy_registers(Register to, Register from, int count, Place place);
  void load_text(SlotsAt from, Register target, Place place);
  void store_text(SlotsAt to, Register value, Place place);
  Register result_register(const Type& type);

  // Arrays and records (compile_memory.cpp)
  SlotsAt reached(SlotsAt at, bool text, Place place);
  Location reached(const Location& home, const Type& type, Place place);
  /// A value into slots, wherever they lie, that hold nothing which it needs.
  void put(const Expr& value, const Location& to, const Type& type);
  void put_record(const Call& call, const Location& to, Place place);
  void assign_memory(const Expr& target, const Expr& value);
  bool is_number_element(const Expr& expression) const;
  void load_element(const Index& index, Register target, Place place);
  /// `value`: a register, or the index of a constant.
  void store_element(Opcode opcode, const Index& index, std::uint8_t value, Place place);
  /// An element becomes a number that is known; false if there is no such instruction for it.
  bool assign_constant_element(const Expr& target, const Expr& value);
  Register refer_whole(const Expr& expression);
  /// `keep`: what is computed later may change the variable that it is.
  Location located_as(const Expr& expression, const Type& type, bool keep);
  CodeBuilder::Jumps jumps_of_memory(const Binary& binary, bool when, Place place);

  // Poses (compile_poses.cpp)
  void into_world(const Expr& expression, Register target);
  void into_other_place(const Expr& expression, Register target);
  void compile_on_places(const Binary& binary, const Expr& expression, Register target);
  void compile_angle(const Member& member, Register target, Place place);

  // JOINTS (compile_joints.cpp)
  void read(Reading reading, Register target, Place place);
  void compile_joints(const Call& call, const Expr& expression, Register target);
  void compile_forward(const Call& call, const Expr& expression, Register target);

  // Compound values (compile_compounds.cpp)
  void compile(const Tuple& tuple, Register target);
  void compile_vector(const Binary& binary, const Expr& expression, Register target);
  void negate_vector(const Unary& unary, const Expr& expression, Register target);
  CodeBuilder::Jumps jumps_of_compounds(const Binary& binary, bool when, Place place);
  void append_compound(const Expr& expression, Register text);

  void read_signal(const Symbol& symbol, Register target, Place place);
  void to_volts(const Symbol& symbol, Register value, Register volts, Place place);
  void compile(const Name& name, const Expr& expression, Register target);
  void compile(const Unary& unary, const Expr& expression, Register target);
  void compile(const Binary& binary, const Expr& expression, Register target);
  void compile(const Call& call, const Expr& expression, Register target);
  void draw(const Call& call, const Expr& expression, Register target);
  void call_on_texts(const Builtin& builtin, const Call& call, const Expr& expression,
                     Register target);
  void compile_truth(const Expr& expression, Register target);

  CodeBuilder::Jumps jumps(const Expr& condition, bool when);
  CodeBuilder::Jumps jumps_of_logical(const Binary& binary, bool when);
  CodeBuilder::Jumps jumps_of_comparison(const Binary& binary, bool when, Place place);
  CodeBuilder::Jumps compare_numbers(const Binary& binary, Register left, Register right, bool when,
                                     Place place);
  CodeBuilder::Jumps compare_texts(const Binary& binary, Register left, Register right, bool when,
                                   Place place);
  CodeBuilder::Jumps jumps_of_texts(const Binary& binary, bool when, Place place);
  CodeBuilder::Jump jump_if(Register truth, bool when, Place place);

  void begin(const Expr& expression);
  void begin_place(const Expr& target);
  // Globals that TASKs use (compile_tasks.cpp)
  void refresh(const std::vector<const Symbol*>& globals, Place place);
  void publish(const Location& at, const Type& type, Place place);
  bool lives_in_register(const Symbol& symbol) const;

  CodeBuilder& code_;
  std::vector<Location> homes_;  ///< by Symbol::id
  bool in_routine_ = false;
  bool watching_ = false;  ///< the present code is a watch's: all it uses is in its own registers
  /// Elements of arrays and records that a watch uses, and where their values are in it.
  std::vector<std::pair<const Expr*, Location>> fixed_parts_;
  bool latched_ = false;  ///< the present expression reads more than one signal
};

/// Number slots that the value of an expression takes where it stands.
int numbers_of(const Expr& expression);
/// The operation on two REALs.
Opcode real_opcode(BinaryOp op);

}  // namespace rob::lang
