#pragma once

#include <cstddef>
#include <vector>

#include "lang/machine/machine.h"

namespace rob::lang {

/// The WITHs and PRESSes that are open. When a block is left, by its end, EXIT, RETURN or
/// an error, the machine is told what held before it.
class ActiveSettings {
 public:
  /// That of the innermost WITH; without one the flange in the world.
  Setting setting() const { return setting(settings_.size()); }
  /// The same where only the first `open` WITHs are.
  Setting setting(std::size_t open) const { return open == 0 ? Setting{} : settings_[open - 1]; }
  std::size_t settings() const { return settings_.size(); }
  void enter(Machine& machine, int line, const Setting& setting);
  /// Leaves all beyond the first `kept`.
  void leave(Machine& machine, int line, std::size_t kept);
  /// The same where another machine has been told of them.
  void drop(std::size_t kept) { settings_.resize(kept); }

  std::size_t presses() const { return presses_; }
  Reply press(Machine& machine, int line, const PressCommand& command);
  /// Ends all beyond the first `kept`.
  Reply end_presses(Machine& machine, int line, std::size_t kept);

 private:
  std::vector<Setting> settings_;
  std::size_t presses_ = 0;
};

}  // namespace rob::lang
