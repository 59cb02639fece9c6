#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "runtime/command/program_effects.h"
#include "runtime/command/waits.h"
#include "runtime/devices/text_devices.h"

namespace rob::runtime {

/// Why SEND and RECEIVE are refused where there are no devices.
Words no_devices();
/// A text that goes to a device, or comes from it.
Note note_for(Note::Kind kind, std::size_t device, std::string_view text);

/// The lines between a program and its devices.
class DeviceDesk {
 public:
  DeviceDesk(const RobotLinks& links, Assumptions& assumptions, const CommandedProgress& progress,
             ProgramEffects& effects, Waits& waits)
      : links_(links),
        assumptions_(assumptions),
        progress_(progress),
        effects_(effects),
        waits_(waits) {}

  /// Before the run; they must outlive it. Without them (null) there are none.
  void connect(TextDevices* devices) { devices_ = devices; }
  TextDevices* devices() const { return devices_; }

  lang::Reply send(int line, std::size_t device, std::string_view text);
  lang::Reply receive(int line, std::size_t device, double timeout, std::string& text, bool& came);
  lang::Reply simulate(int line, std::size_t device, std::string_view text, double after);
  /// The current RECEIVE is given up.
  void drop() {
    first_look_.reset();
    standing_ = false;
  }

 private:
  std::optional<std::string> look(int line, std::size_t device);
  double now() const;

  const RobotLinks& links_;
  Assumptions& assumptions_;
  const CommandedProgress& progress_;
  ProgramEffects& effects_;
  Waits& waits_;
  TextDevices* devices_ = nullptr;
  std::optional<double> first_look_;  ///< of the current RECEIVE, s
  bool standing_ = false;             ///< it waits at standstill
};

}  // namespace rob::runtime
