#pragma once

#include <utility>
#include <vector>

#include "lang/check/symbols.h"
#include "lang/code/code_builder.h"
#include "lang/code/location.h"
#include "lang/syntax/ast.h"

namespace rob::lang {

/// Where variables live, and code that moves their values between places: registers, the memory of
/// a frame, or where a reference points. The program has its own copy of the globals that TASKs
/// use: what it gives them is published, what TASKs give them is fetched.
class Variables {
 public:
  Variables(CodeBuilder& code, std::size_t symbols)
      : code_(code), frame_(code.frame()), homes_(symbols) {}

  /// Where a variable lives, from its declaration on.
  void settle(const Symbol& symbol, const Location& home) { homes_[symbol.id] = home; }
  /// By Symbol::id.
  const std::vector<Location>& homes() const { return homes_; }
  /// From here on the code belongs to a routine: globals lie in another frame.
  void enter_routine() { in_routine_ = true; }

  /// Where a variable lies, as the current code sees it.
  Location home(const Symbol& symbol) const;
  /// Whether a symbol is a value at a place. A symbol that is none is read anew each time; in a
  /// watch its value was fixed before.
  bool has_home(const Symbol& symbol) const;
  /// Whether an expression is a variable, or a part of one.
  bool is_variable(const Expr& expression) const;
  /// Whether a value that is read in the end lies in a register of its own.
  bool stays_in_register(const Expr& expression) const;
  /// Whether it is a number in an array whose index is computed.
  bool is_number_element(const Expr& expression) const;

  /// Registers for a value; memory where it does not lie in registers.
  Location temporary(const Type& type, Place place);
  /// The slot at a place becomes an empty LIST of this type.
  void open_list(const Location& at, const Type& type, Place place);
  /// The elements of a LIST become those of another.
  void fill_list(const Location& to, const Location& from, Place place);
  /// Where the elements of a LIST lie now, in three registers (opcodes.def).
  Register list_row(const Location& list, Place place);
  /// Three registers, the first two of them for elements that begin at a place.
  Register row_at(const Location& at, Slots slots, Place place);
  /// New registers for a value that lies in them.
  Register registers_for(const Type& type);
  /// Slots of the memory of the current frame.
  Location memory(Slots slots, Place place);
  /// Where a value lies that is reached from the current frame.
  Location reached(const Location& home, const Type& type, Place place);
  /// The number of elements, into a register.
  void count(const Location& whole, const Type& type, Register target, Place place);
  /// An element of what lies at `whole`, by the register of its index.
  Location element(const Location& whole, Register which, const Elements& elements, Place place);

  /// The place of number slots, or of text slots, into a register.
  void refer(SlotsAt at, bool text, Register target, Place place);
  void refer(const Symbol& symbol, bool text, Register target, Place place);
  /// Both places of a value into registers, where it has such slots: first that of its numbers.
  void refer_both(const Location& at, const Type& type, Register numbers, Register texts,
                  Place place);

  /// The value of a place, into registers; and back.
  void load(const Location& from, const Type& type, Register target, Place place);
  void store(const Location& to, const Type& type, Register value, Place place);
  void copy_registers(Register to, Register from, int count, Place place);
  /// Gives a variable the value of another one of its type.
  void copy(const Location& from, const Location& to, const Type& type, Place place);
  /// Brings a whole array or record from one place to another.
  void copy_memory(const Location& to, const Location& from, Slots slots, Place place);
  /// 0, FALSE, "".
  void clear(const Location& home, const Type& type, Place place);

  /// The value of a variable of numbers, into registers.
  void load_variable(const Symbol& variable, Register target, Place place) {
    load(home(variable), variable.type, target, place);
  }
  /// The same into new ones.
  Register variable(const Symbol& variable, Place place);
  /// A value in registers becomes that of a point or of another variable.
  void store_variable(const Symbol& variable, Register value, Place place);

  /// Where the numbers and the texts of a global lie on the stack.
  std::pair<std::size_t, std::size_t> places(const Symbol& global) const;
  /// A PERSIST variable has another value, or perhaps soon.
  void changed(const Symbol& symbol, Place place,
               CodeBuilder::Persist how = CodeBuilder::Persist::Changed) {
    if (symbol.persist >= 0) code_.persist(symbol.persist, how, place);
  }
  /// TASKs see the current value of a variable that they use.
  void publish(const Symbol& symbol, Place place);
  void publish(const Location& at, const Type& type, Place place);
  /// The same of the part of a variable that has its home `at`; of a LIST all is published.
  void publish_part(const Symbol& root, const Location& at, const Type& type, Place place);
  /// Globals become what TASKs see; `latched`: at the instant of the latch.
  void refresh(const std::vector<const Symbol*>& globals, bool latched, Place place);

  /// The code that follows is a watch's, up to end_watch(). All that it uses is in registers of its
  /// own: `parts`, variables and parts of variables, side by side in the first ones.
  void begin_watch(const std::vector<const Expr*>& parts, Place place);
  void end_watch();
  bool watching() const { return watching_; }
  /// Where a part of a variable lies in the watch; null if it is no such part.
  const Location* fixed_part(const Expr& expression) const;

 private:
  SlotsAt reached(SlotsAt at, bool text, Place place);
  SlotsAt element_at(SlotsAt whole, bool text, Register which, std::int64_t count, int size,
                     Place place);
  void load_numbers(SlotsAt from, Register target, int count, Place place);
  void store_numbers(SlotsAt to, Register value, int count, Place place);
  void load_slot(SlotsAt from, Register target, Place place);
  void store_slot(SlotsAt to, Register value, Place place);
  void load_text(SlotsAt from, Register target, Place place);
  void store_text(SlotsAt to, Register value, Place place);

  CodeBuilder& code_;
  FrameSlots& frame_;
  std::vector<Location> homes_;  ///< by Symbol::id
  bool in_routine_ = false;
  bool watching_ = false;
  std::vector<std::pair<const Expr*, Location>> fixed_parts_;    ///< elements and fields in a watch
  std::vector<std::pair<const Symbol*, Location>> homes_aside_;  ///< while a watch is made
};

}  // namespace rob::lang
