#pragma once

#include <array>
#include <functional>
#include <map>
#include <string>
#include <vector>

#include "drivers/link/grbl_port.h"
#include "drivers/link/wire_link.h"

namespace rob::drivers {

/// grbl's settings ($$), by number.
class GrblSettings {
 public:
  explicit GrblSettings(std::map<int, double> values = {}) : values_(std::move(values)) {}

  bool homes() const { return (static_cast<int>(value_or(22, 0)) & 1) != 0; }
  /// Steps per mm of a letter (X = 0).
  double steps(int letter) const { return values_.at(100 + letter); }
  /// s that the slowest of these axes needs to brake from its maximum speed.
  double braking_time(const std::vector<WireAxis>& axes) const;
  /// Throws motion::DriverError, which names every setting that prevents Rob from moving these
  /// axes.
  void check(const std::vector<WireAxis>& axes, const std::string& path) const;
  /// Includes the travel if grbl enforces it ($20), with its origin at the switches.
  WireLimits limits(const std::vector<WireAxis>& axes, const WireVector& offset) const;

 private:
  double value_or(int number, double other) const;

  std::map<int, double> values_;
};

/// Rob's conversation with grbl before it moves. Every call may block, and throws
/// motion::DriverError if grbl refuses or does not answer.
namespace grbl_setup {

/// Resets grbl, so that nothing of a former program is left in it, and waits for its banner.
void greet(GrblPort& port);
/// Repeats $$ for up to 5 s, until grbl answers: a board that is still starting drops lines.
GrblSettings read_settings(GrblPort& port);
/// WCO by letter (X = 0): position in work coordinates = machine position − WCO. Taken from a
/// report that contains it, otherwise from $# and $G.
using Offset = std::array<double, grbl::kMostAxes>;
Offset read_offset(GrblPort& port);
/// Sends a line and waits for its "ok". Resets grbl as soon as `given_up` (empty: never) returns
/// true.
void carry_out(GrblPort& port, const std::string& line, double seconds, const std::string& what,
               const std::function<bool()>& given_up = {});

}  // namespace grbl_setup

}  // namespace rob::drivers
