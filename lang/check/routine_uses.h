#pragma once

#include <cstddef>
#include <cstdint>
#include <map>
#include <set>
#include <utility>
#include <vector>

#include "lang/check/symbols.h"
#include "lang/syntax/ast.h"
#include "lang/text/diagnostic.h"

namespace rob::lang {

/// Which routine uses which global and calls which routine. A routine sees all globals of its
/// file, but a call that stands above the declaration of one that it needs, itself or through what
/// it calls, would find it without a value: that is an error.
///
/// The checker reports what it meets; statements of the top level count from 1.
class RoutineUses {
 public:
  explicit RoutineUses(std::size_t routines) : callers_(routines) {}

  /// From here on things belong to `routine`, or to the top level where it is null; returns what
  /// they belonged to.
  const Routine* enter(const Routine* routine) { return std::exchange(inside_, routine); }
  void next_statement() { ++statement_; }
  void declared(const Symbol& global) { declared_in_[&global] = statement_; }
  void used(const Symbol& symbol);
  void called(const Routine& routine, Place place);

  void report(Diagnostics& diagnostics) const;

  // Handlers
  /// Symbols up to number `first` are of what is around the handler.
  void enter_handler(std::size_t first) { handler_begins_ = first; }
  /// Whether the handler, or what it calls, does what the axes have to stand for. To be called when
  /// all is checked, as report_handlers() is.
  bool stops(const Routine& handler) const;
  /// The variables around the handler that it uses, in the order of their declaration.
  std::vector<const Symbol*> captured(const Routine& handler) const;
  /// A handler, and what it calls, has no WHEN.
  void report_handlers(const std::vector<Routine>& routines, Diagnostics& diagnostics) const;

  // TASKs
  void statement(const Statement& statement);
  void written(const Symbol& symbol, Place place);
  /// Given to a REF parameter.
  void referred(const Symbol& symbol, Place place);
  /// By SEND or RECEIVE.
  void spoke_with(const Symbol& device, Place place);
  /// To be called when all is checked: what TASKs, and what they call, must not do is an error.
  void report_tasks(const std::vector<Routine>& routines, Diagnostics& diagnostics);
  /// A LIST is there that is no global, or one changes: TASKs only look at those of the program.
  void met_list(Place place);
  // PATHs
  /// A signal or something of the robot is looked at, or set.
  void met_robot(Place place);
  /// Whether what comes now stands in a PATH; returns whether the last did.
  bool in_path(bool now) { return std::exchange(in_path_, now); }
  /// After report_tasks(): a PATH is planned before it starts, so a routine that it calls can only
  /// compute.
  void report_paths(const std::vector<Routine>& routines, Diagnostics& diagnostics) const;
  /// Whether a TASK uses, itself or through what it calls, what is declared from this line of the
  /// program's own file on.
  bool uses_since(const Routine& task, std::uint32_t line,
                  const std::vector<Routine>& routines) const;
  /// Whether a routine is a TASK or is called by one; null: the top level. After report_tasks().
  bool in_task(const Routine* routine) const;
  struct Shared {
    const Symbol* symbol;
    bool observed;  ///< a TASK gives it a value, or may
    bool of_tasks;  ///< a TASK uses it now
  };
  /// At the prompt a TASK may come after a WHEN: what the handlers use is shared with it already.
  void share_with_handlers(const std::vector<Routine>& routines);
  /// The globals that TASKs use, in the order of their declaration. After report_tasks().
  std::vector<Shared> shared() const;

 private:
  struct TopLevelCall {
    const Routine* routine;
    Place place;
    std::size_t statement;
  };
  struct Reference {
    const Symbol* symbol;
    Place place;
  };
  struct Talk {
    const Symbol* device;
    const Routine* inside;
    Place place;
  };
  struct PathCall {
    const Routine* routine;
    Place place;
  };
  std::vector<std::vector<std::size_t>> callees() const;
  std::set<std::size_t> reached_from(std::size_t routine) const;
  std::vector<const Symbol*> latest_needs() const;
  void gather_tasks(const std::vector<Routine>& routines);
  void report_references(Diagnostics& diagnostics) const;
  std::set<std::size_t> reached_by_program(const std::vector<Routine>& routines) const;
  void report_devices(const std::vector<Routine>& routines, Diagnostics& diagnostics) const;
  bool any_in_task(const std::set<std::size_t>& routines) const;

  const Routine* inside_ = nullptr;
  std::size_t statement_ = 0;
  std::map<const Symbol*, std::size_t> declared_in_;
  std::map<const Symbol*, std::set<std::size_t>> users_;  ///< routines by index
  std::map<const Symbol*, std::set<std::size_t>> writers_;
  std::map<const Symbol*, std::set<std::size_t>> named_;  ///< all of the top level, constants too
  std::vector<Reference> references_;
  std::vector<Talk> talks_;
  std::vector<std::set<std::size_t>> callers_;  ///< of each routine
  std::vector<TopLevelCall> calls_;

  std::size_t handler_begins_ = 0;
  std::map<std::size_t, std::map<std::size_t, const Symbol*>> captured_;  ///< by handler and id
  std::set<std::size_t> stopping_;         ///< routines that the axes have to stand for
  std::map<std::size_t, Place> watching_;  ///< routines that have a WHEN

  std::map<std::size_t, Place> listed_;  ///< by routine: the first LIST that it uses
  std::map<std::size_t, Place> barred_;  ///< by routine: the first statement that no TASK can have
  std::set<std::size_t> of_handlers_;    ///< routines that share what they use with later TASKs
  std::vector<const Routine*> task_of_;  ///< of each routine: a TASK that it is or that calls it

  std::map<std::size_t, Place> robots_;  ///< by routine: what no PATH can have in a routine
  std::vector<PathCall> path_calls_;
  bool in_path_ = false;
};

}  // namespace rob::lang
