#pragma once

#include <cstdint>
#include <list>
#include <map>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <unordered_map>
#include <vector>

#include "lang/compile/compile.h"

namespace rob::lang {

/// A name that an entry has declared, for people.
struct DeclaredName {
  enum class Kind : std::uint8_t { Variable, Const, Point, Signal, Routine, Record };
  Kind kind = Kind::Variable;
  std::string name;
  std::string type;  ///< in words
  Place place;
};

/// The entries of a prompt, as far as later ones need them. An entry is compiled with the names
/// that occur in it, and with the text of the routines among these: so it takes the same time,
/// however many entries came before.
///
/// All entries form one text, whose lines count from 1.
class Entries {
 public:
  enum class Knowing : std::uint8_t {
    Needed,     ///< what occurs in the entry
    Everything  ///< for an entry with errors: so messages can say what a word was meant for
  };
  enum class As : std::uint8_t {
    Statements,
    Expression  ///< whose value is printed
  };

  /// The line on which the next entry begins.
  std::uint32_t line() const { return line_; }
  /// Compiled after all that has been kept, as by compile(). Nothing is kept of it before keep().
  Compilation compile(std::string_view entry, const RobotSignature& robot,
                      const PointTable& points = {}, const TargetJudge& judge = {},
                      const Sources* sources = nullptr, Knowing knowing = Knowing::Needed,
                      As as = As::Statements) const;
  /// The entry has been accepted, or has errors: the next one begins on the line after it.
  void keep(std::string_view entry, const Compilation& compiled);
  /// A line that declares nothing.
  void pass_line() { ++line_; }

  /// The names declared on these lines are unknown again: their entries have not been carried out.
  void forget(std::uint32_t first, std::uint32_t last);
  /// The name is unknown from here on. False if a routine uses it: then it stays.
  bool forget(std::string_view name);

  std::optional<DeclaredName> find(std::string_view name) const;
  /// The last of each name, in the order of their places.
  std::vector<DeclaredName> names() const;
  /// Those that occur in a text.
  std::vector<DeclaredName> named_in(std::string_view text) const;

 private:
  /// Lines that are read again with later entries: of a routine, or a USE.
  struct Definition {
    std::uint32_t first = 0;
    std::uint32_t last = 0;
    bool use = false;
    std::string text;
    std::vector<std::string> words;  ///< of it, in capitals, without its parameters
    Room room;                       ///< that was taken before it
    std::string routine;             ///< its name, in capitals; empty for a USE
  };
  struct SharedBefore {
    KeptName* name;
    bool shared;
    bool of_tasks;
  };
  /// An entry that has declared something.
  struct Entry {
    Room room;  ///< that was taken before it
    std::list<KeptName> names;
    std::list<Definition> definitions;
    std::vector<SharedBefore> shared;  ///< names of earlier ones that are shared since then
  };
  struct Known {
    KeptName* name = nullptr;
    const Definition* definition = nullptr;  ///< of a routine
  };
  struct Selection;
  using Users = std::vector<const Definition*>;

  const Known* known(const std::string& key) const;
  void select(std::vector<std::string> words, Selection& selection) const;
  void add_frames(const Type& type, std::vector<std::string>& words) const;
  bool holds(const Definition& definition) const;
  bool select_users(const std::vector<KeptName>& names, Selection& selection) const;
  EntryText text_of(Selection selection, std::string_view entry) const;
  void add(Entry& entry);
  void remove(const Entry& entry);
  void keep_shared(const Compilation& compiled, Entry& entry);

  std::uint32_t line_ = 1;
  Room room_;
  std::map<std::uint32_t, Entry> entries_;                     ///< by their first lines
  std::unordered_map<std::string, std::vector<Known>> known_;  ///< by name; the last one holds
  std::unordered_map<std::string, Users> users_;               ///< routines, by their words
  Users uses_;                                                 ///< USE
  std::set<std::string> tasks_;        ///< names of TASKs: what they use is shared in every entry
  std::vector<const KeptName*> safe_;  ///< SIGNALs with SAFE
  std::map<const TypeDetail*, std::string> frames_;  ///< names of FRAMEs
  TypeTable types_;  ///< names all that were declared; their details are in `tables_`
  std::vector<std::shared_ptr<const TypeTable>> tables_;
};

}  // namespace rob::lang
