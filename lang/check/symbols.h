#pragma once

#include <cstddef>
#include <cstdint>
#include <deque>
#include <functional>
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "lang/machine/point_table.h"
#include "lang/machine/reading.h"
#include "lang/machine/robot_signature.h"
#include "lang/syntax/ast.h"

namespace rob::lang {

/// The meaning of a name.
struct Symbol {
  enum class Kind : std::uint8_t {
    Variable,       ///< VAR: may be assigned
    NamedConstant,  ///< CONST: computed where it stands, at the latest
    LoopVariable,   ///< of FOR: read-only in the body
    Signal,         ///< declared by the robot's file or by SIGNAL; DIN[n], DOUT[n]
    BuiltIn,        ///< PI, HIT
    Reading,        ///< CLOCK: read from the robot
    Routine,        ///< PROC or FUNC
    Record,         ///< a type; called, it builds a value
    Enum,           ///< a type; its names are values
    Device,         ///< DEVICE: for SEND and RECEIVE
    Point           ///< POINT: changed by TEACH alone; without one its value is known
  };

  Kind kind = Kind::Variable;
  std::string name;  ///< as it was declared
  Type type;
  Place place;         ///< of its declaration; line 0 for what is not declared in the program
  std::size_t id = 0;  ///< dense, from 0: an index for what later stages know of it
  Constant value;      ///< where it is known before the program runs
  Reading reading{};   ///< of Kind::Reading
  Constant kept{};     ///< of a point: its value when the program starts
  std::vector<double> joints{};        ///< of a point, as the points file has them
  bool flange_joints = false;          ///< and these surely bring the bare flange to it
  bool moved_to = false;               ///< a point that is by itself the target of a MOVE
  const Symbol* taught = nullptr;      ///< of a point that TEACH changes: its joints, a variable
  const Symbol* has_taught = nullptr;  ///< and a BOOL, whether they are known
  const TypeDetail* frame = nullptr;   ///< of a FRAME: the detail of poses in it
  int signal = 0;                      ///< its index in the RobotSignature
  bool output = false;                 ///< a signal that may be assigned
  int channel = 0;                     ///< n of DIN[n], DOUT[n], AIN[n] or AOUT[n]
  int group = 0;                       ///< channels of a group, from `signal` on; 0: it is none
  bool analog = false;                 ///< a signal that is a number
  double low = 0;                      ///< of an analog signal: what 0V stand for
  double high = 0;                     ///< what kMostVolts stand for
  bool global = false;                 ///< declared at the top level: routines see it
  bool by_reference = false;           ///< a REF parameter: stands for a variable of the caller
  const Routine* routine = nullptr;    ///< of Kind::Routine
  bool shared = false;                 ///< a global that a TASK uses, or may at the prompt
  bool of_tasks = false;               ///< and it does
  bool observed = false;               ///< and gives a value
  int device = -1;                     ///< of Kind::Device: its number among them
  int persist = -1;                    ///< of PERSIST: its number among them
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

  /// At the top level: from here on the names of another file are known; returns which were.
  std::uint32_t enter_file(std::uint32_t file);
  /// From here on the current file knows the names of another one, plainly and after `name`.
  void use(const std::string& name, std::uint32_t file);
  bool is_file(std::string_view name) const;
  /// The USEd files, as the current one calls them, in which a plain name is found.
  std::vector<std::string> files_with(std::string_view name) const;
  /// The current file's own names that another file has, too.
  std::vector<const Symbol*> shared_with(std::uint32_t file) const;
  /// All names of a USEd file, by what the current one calls it.
  std::vector<std::string_view> names_in(std::string_view name) const;

  /// Null if the name is unknown here. `tools.grip` is the name of a USEd file.
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
  /// A global variable that no program can name.
  const Symbol* hide(const Type& type);
  /// The rest of a symbol, which becomes known after its declaration.
  void define(const Symbol& symbol, const Routine& routine) {
    symbols_[symbol.id].routine = &routine;
  }
  void frame(const Symbol& symbol, const TypeDetail* detail) {
    symbols_[symbol.id].frame = detail;
    frames_[detail] = &symbol;
  }
  void share(const Symbol& symbol, bool observed, bool of_tasks) {
    symbols_[symbol.id].shared = true;
    symbols_[symbol.id].observed = observed;
    symbols_[symbol.id].of_tasks = of_tasks;
  }
  void persist(const Symbol& symbol) { symbols_[symbol.id].persist = persistent_++; }
  void device(const Symbol& symbol) { symbols_[symbol.id].device = devices_++; }
  /// The FRAME, of any file, that poses of this detail are in; null if it is not declared yet.
  const Symbol* frame_of(const TypeDetail* detail) const;
  /// While `only` holds, find() sees the top level and what is provided alone.
  void look_from_top(bool only) { top_only_ = only; }
  void refer(const Symbol& symbol) { symbols_[symbol.id].by_reference = true; }
  void keep(const Symbol& point, Constant value) { symbols_[point.id].kept = std::move(value); }
  void keep_joints(const Symbol& point, const PointTable::Point& kept) {
    symbols_[point.id].joints = kept.joints;
    symbols_[point.id].flange_joints =
        !kept.joints.empty() && !kept.with_tool && kept.frame.empty();
  }
  void teach(const Symbol& point, const Symbol& joints, const Symbol& known, bool moved_to) {
    symbols_[point.id].moved_to = moved_to;
    symbols_[point.id].taught = &joints;
    symbols_[point.id].has_taught = &known;
  }
  /// How many symbols have been declared so far.
  std::size_t declared() const { return symbols_.size(); }
  /// All names that can be seen from here, for "did you mean".
  std::vector<std::string_view> visible() const;

 private:
  void provide(Reading reading, const Type& type);

  using Scope = std::map<std::string, const Symbol*, std::less<>>;

  struct UsedFile {
    std::string name;
    std::uint32_t file;
  };
  /// A file of the program: its names while it is not the current one, and what it USEs.
  struct File {
    Scope parked;
    std::vector<UsedFile> used;
  };
  const Scope& names_of(std::uint32_t file) const {
    return file == file_ ? scopes_[1] : files_[file].parked;
  }
  const Symbol* find_used(const std::string& key) const;

  std::deque<Symbol>& symbols_;
  std::vector<Scope> scopes_;
  std::vector<File> files_;
  std::uint32_t file_ = 0;
  bool top_only_ = false;
  int devices_ = 0;     ///< so far
  int persistent_ = 0;  ///< PERSIST variables so far
  std::map<const TypeDetail*, const Symbol*> frames_;
  std::vector<const Symbol*> channels_;
};

}  // namespace rob::lang
