#pragma once

#include <cstddef>
#include <vector>

#include "lang/machine/machine.h"

namespace rob::lang {

/// The WITHs and PRESSes that are open. When a block is left, by its end, EXIT, RETURN or
/// an error, the machine gets what held before it.
class ActiveSettings {
 public:
  /// That of the innermost WITH; without one the flange in the world.
  const Setting& setting() const { return setting(settings_.size()); }
  /// The same where only the first `open` WITHs are.
  const Setting& setting(std::size_t open) const { return around(open).setting; }
  std::size_t settings() const { return settings_.size(); }
  void enter(Machine& machine, int line, const Setting& setting);
  /// A handler begins: all is as where the first `open` WITHs are.
  void enter_as_of(Machine& machine, int line, std::size_t open);
  /// Leaves all beyond the first `kept`.
  void leave(Machine& machine, int line, std::size_t kept);
  /// The same where another machine knows of them.
  void drop(std::size_t kept) { settings_.resize(kept); }

  /// The clauses of motions that have none of their own: DEFAULT, and the WITHs around them.
  const MoveCommand& defaults() const { return around(settings_.size()).defaults; }
  /// WITH: those of `clauses` come before those around it.
  void enter(MoveCommand clauses);
  /// DEFAULT, from here on.
  void set_defaults(const MoveCommand& clauses) { program_.defaults = clauses; }

  std::size_t presses() const { return presses_; }
  Reply press(Machine& machine, int line, const PressCommand& command);
  /// Ends all beyond the first `kept`.
  Reply end_presses(Machine& machine, int line, std::size_t kept);

 private:
  struct Around {
    Setting setting;
    MoveCommand defaults;  ///< nothing but clauses
    bool told = false;     ///< the machine knows of it
  };
  const Around& around(std::size_t open) const {
    return open == 0 ? program_ : settings_[open - 1];
  }

  Around program_;  ///< where no WITH is
  std::vector<Around> settings_;
  std::size_t presses_ = 0;
};

}  // namespace rob::lang
