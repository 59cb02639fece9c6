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
  /// s within which every axis of these brakes from its greatest speed.
  double braking_time(const std::vector<WireAxis>& axes) const;
  /// Throws motion::DriverError that names everything with which these axes could not be moved.
  void check(const std::vector<WireAxis>& axes, const std::string& path) const;
  /// The travel counts where grbl keeps to it itself ($20), with its origin at the switches.
  WireLimits limits(const std::vector<WireAxis>& axes, const WireVector& offset) const;

 private:
  double value_or(int number, double other) const;

  std::map<int, double> values_;
};

/// What is asked of grbl before it moves; every call may take its time, and throws
/// motion::DriverError.
namespace grbl_setup {

/// Resets grbl, so that nothing of a former program is left in it, and waits for its banner.
void greet(GrblPort& port);
/// Asks for $$ until it is answered, for 5 s in all: a board that is still starting drops lines.
GrblSettings read_settings(GrblPort& port);
/// WCO by letter (X = 0): position in work coordinates = machine position − WCO. Of a report that
/// has it, otherwise of $# and $G.
using Offset = std::array<double, grbl::kMostAxes>;
Offset read_offset(GrblPort& port);
/// Sends a line and waits for its "ok". If it is `given_up` (empty: never), grbl is reset.
void carry_out(GrblPort& port, const std::string& line, double seconds, const std::string& what,
               const std::function<bool()>& given_up = {});

}  // namespace grbl_setup

}  // namespace rob::drivers
