#pragma once

#include <memory>
#include <span>
#include <string_view>

#include "drivers/link/wire_backend.h"
#include "drivers/link/wired_axis.h"

namespace rob::drivers {

/// A kind of machine on a wire: what `--backend NAME:PORT` opens.
struct Driver {
  const char* name;
  const char* description;
  int default_baud;
  bool sees_hand;  ///< it measures where a hand moves its axes
  /// Makes the machine, not yet open, with the axes of `axes`; those of `settings` are empty.
  /// Throws motion::DriverError for axes that this machine cannot have.
  std::unique_ptr<WireBackend> (*make)(WireSettings settings, std::span<const WiredAxis> axes);
};

/// All drivers. A new one gets one line in driver.cpp.
std::span<const Driver> drivers();
/// Null if no driver has that name.
const Driver* find_driver(std::string_view name);

}  // namespace rob::drivers
