#pragma once

#include <cstddef>
#include <cstdint>
#include <deque>
#include <functional>
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "lang/ast.h"
#include "lang/reading.h"
#include "lang/robot_signature.h"

namespace rob::lang {

/// What a name stands for.
struct Symbol {
  enum class Kind : std::uint8_t {
    Variable,       ///< VAR: may be assigned
    NamedConstant,  ///< CONST: computed where it stands, at the latest
    LoopVariable,   ///< of FOR: read-only in the body
    Signal,         ///< declared by the robot's file or by SIGNAL; DIN[n], DOUT[n]
    BuiltIn,        ///< PI, HIT
    Reading,        ///< CLOCK: read from the robot
    Routine,        ///< PROC or FUNC
    Point           ///< POINT: changed by TEACH alone; without one its value is known
  };

  Kind kind = Kind::Variable;
  std::string name;  ///< as it was declared
  Type type;
  Place place;         ///< of its declaration; line 0 for what is not declared in the program
  std::size_t id = 0;  ///< dense, from 0: an index for what later stages know of it
  Constant value;      ///< where it is known before the program runs
  Reading reading{};   ///< of Kind::Reading
  const TypeDetail* frame = nullptr;  ///< of a FRAME: the detail of poses in it
  int signal = 0;                     ///< its index in the RobotSignature
  bool output = false;                ///< a signal that may be assigned
  int channel = 0;                    ///< n of DIN[n], DOUT[n], AIN[n] or AOUT[n]
  bool analog = false;                ///< a signal that is a number
  double low = 0;                     ///< of an analog signal, SI: what 0V stand for
  double high = 0;                    ///< what kMostVolts stand for
  bool global = false;                ///< declared at the top level: routines see it
  bool by_reference = false;          ///< a REF parameter: stands for a variable of the caller
  const Routine* routine = nullptr;   ///< of Kind::Routine
  bool shared = false;                ///< a global that a TASK uses
  bool observed = false;              ///< and gives a value
};

/// The names that may be used at one place of the program. Scopes nest; the outermost holds what
/// the language and the robot provide, the second the program's own top level. A name declared in
/// an inner scope hides the same name further out.
class Scopes {
 public:
  /// `symbols` owns all symbols ever declared, and keeps their addresses.
  Scopes(std::deque<Symbol>& symbols, const RobotSignature& robot);

  void enter() { scopes_.emplace_back(); }
  void leave() { scopes_.pop_back(); }

  /// Whether what is declared now belongs to the whole program.
  bool at_top_level() const { return scopes_.size() == 2; }

  /// Null if the name is unknown here.
  const Symbol* find(std::string_view name) const;
  /// The name at the top level of the program, whatever hides it here; null if there is none.
  const Symbol* find_global(std::string_view name) const;
  /// Null if the innermost scope has no such name.
  const Symbol* find_innermost(std::string_view name) const;
  /// Whether the language or the robot gives this name a meaning.
  bool provided(std::string_view name) const;
  /// DIN[n], DOUT[n], AIN[n] or AOUT[n], by its word; null if the robot has no such channel.
  const Symbol* channel(std::string_view word, std::int64_t number) const;
  /// How many channels there are of a kind.
  std::int64_t channels(std::string_view word) const;
  /// Declares in the innermost scope; what had the same name there is replaced.
  const Symbol* declare(Symbol symbol);
  /// What is found out about a symbol behind its declaration.
  void define(const Symbol& symbol, const Routine& routine) {
    symbols_[symbol.id].routine = &routine;
  }
  void frame(const Symbol& symbol, const TypeDetail* detail) { symbols_[symbol.id].frame = detail; }
  void share(const Symbol& symbol, bool observed) {
    symbols_[symbol.id].shared = true;
    symbols_[symbol.id].observed = observed;
  }
  void refer(const Symbol& symbol) { symbols_[symbol.id].by_reference = true; }
  /// All names that can be seen from here, for "did you mean".
  std::vector<std::string_view> visible() const;

 private:
  void provide(Reading reading, const Type& type);

  using Scope = std::map<std::string, const Symbol*, std::less<>>;

  std::deque<Symbol>& symbols_;
  std::vector<Scope> scopes_;
  std::vector<const Symbol*> channels_;
};

}  // namespace rob::lang
