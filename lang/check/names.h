#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "lang/check/checked_program.h"
#include "lang/check/routine_uses.h"
#include "lang/check/symbols.h"
#include "lang/syntax/ast.h"
#include "lang/text/diagnostic.h"
#include "lang/values/builtins.h"

namespace rob::lang {

/// Finds what names mean where they stand, and reports those that mean nothing there.
class Names {
 public:
  /// `program` is searched for names that are declared elsewhere.
  Names(const Scopes& scopes, const Program& program, RoutineUses& uses, Diagnostics& diagnostics)
      : scopes_(scopes), program_(program), uses_(uses), diagnostics_(diagnostics) {}

  /// The symbol that a name means here; null if none. No message.
  const Symbol* find(std::string_view name) const { return scopes_.find(name); }
  /// A symbol that may be used here; null, and a message, if there is none.
  const Symbol* resolve(std::string_view name, Place place);
  /// DIN[n], DOUT[n], AIN[n] or AOUT[n], whose index has been checked; null, and a message, if it
  /// is no constant or the robot has no such channel.
  /// The number of a DEVICE; reports where there is none of that name.
  const Symbol* resolve_device(std::string_view name, Place place);
  const Symbol* resolve_channel(const Name& name, Place place);
  /// The built-in function that a call with checked arguments means; null, and a message, if there
  /// is none.
  const Builtin* resolve_function(const Call& call, Place place);
  /// Whether several USEd files declare a plain name, which is an error then.
  bool report_ambiguous(std::string_view name, Place place);
  /// The first place in a file of the program that declares a name (VAR, CONST or FOR).
  std::optional<Place> declaration_of(std::string_view name, std::uint32_t file) const;

 private:
  void report_unknown(std::string_view name, Place place);
  void report_unknown_function(std::string_view name, Place place);
  void report_no_such_name(std::string_view name, Place place);

  const Scopes& scopes_;
  const Program& program_;
  RoutineUses& uses_;
  Diagnostics& diagnostics_;
};

/// Declares names in the innermost scope, and counts the slots that variables take.
class Declarations {
 public:
  /// `entry`: as Program::entry.
  Declarations(Scopes& scopes, RoutineUses& uses, std::uint32_t entry, Diagnostics& diagnostics)
      : scopes_(scopes), uses_(uses), entry_(entry), diagnostics_(diagnostics) {}

  /// An error or a warning where the name has a meaning already.
  const Symbol* declare(Symbol::Kind kind, const std::string& name, Place place, Type type,
                        Constant value);
  /// A PROC, FUNC or TASK, at the top level.
  void declare(const Routine& routine);
  /// A name that an earlier entry of the prompt has kept, at the top level. Notes in `known` which
  /// symbols stand for what it kept.
  const Symbol& declare(const KeptName& kept, std::vector<CheckedProgram::Known>& known);
  /// The messages of declare() alone.
  void warn_of_name(Symbol::Kind kind, const std::string& name, Place place);
  void warn_of_hiding(const std::string& name, const Place& place, const std::string& file);

  /// Slots of variables, of a routine or the top level.
  struct Count {
    Slots now{};   ///< of those that are known here
    Slots most{};  ///< that are known at once
  };
  /// A block is a scope: what it declares lives to its end.
  class OpenScope {
   public:
    explicit OpenScope(Declarations& declarations)
        : declarations_(declarations), outside_(declarations.count_.now) {
      declarations_.scopes_.enter();
    }
    OpenScope(const OpenScope&) = delete;
    OpenScope& operator=(const OpenScope&) = delete;
    ~OpenScope() {
      declarations_.scopes_.leave();
      declarations_.count_.now = outside_;
    }

   private:
    Declarations& declarations_;
    Slots outside_;
  };
  /// Begins to count anew; returns what was counted, to go on with.
  Count count_anew();
  void count_on(const Count& count) { count_ = count; }
  /// Whether there are more variables than may all find registers beside what is computed. Begins
  /// to count anew.
  bool take_many();

 private:
  void count(Slots slots);
  bool may_be_anew(Symbol::Kind kind, const Symbol& earlier) const;
  const Symbol& declare_hidden(const KeptName& kept, std::vector<CheckedProgram::Known>& known);
  void report_twice(Symbol::Kind kind, const std::string& name, Place place, const Symbol& earlier);

  Scopes& scopes_;
  RoutineUses& uses_;
  std::uint32_t entry_;
  Diagnostics& diagnostics_;
  Count count_;
};

/// Finds the points that are used although neither the points file nor the program gives them a
/// value. A TEACH at the top level, outside of all blocks, does so for the lines after it; what
/// routines do may come earlier.
class MissingPoints {
 public:
  void declare(const Symbol& point) { states_[&point]; }
  void teach(const Symbol& point, bool surely);
  void use(const Symbol& point);
  /// From here on come the routines.
  void enter_routines() { in_routines_ = true; }
  /// All of them, in the order of their declarations.
  std::vector<MissingPoint> found() const;

 private:
  struct State {
    bool surely = false;  ///< taught before what comes now
    bool taught = false;  ///< somewhere
    bool needed = false;  ///< used before it is surely taught
  };
  std::map<const Symbol*, State> states_;
  bool in_routines_ = false;
};

}  // namespace rob::lang
