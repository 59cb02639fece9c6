#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <string>

#include "drivers/serial/wire_port.h"
#include "motion/servo/servo_backend.h"
#include "motion/space/analog_channels.h"
#include "motion/space/joint_vector.h"

namespace rob::drivers {

/// A value per axis in the machine's own units: ticks, mm, 1e-6 of them …
using WireVector = std::array<double, motion::kMaxJoints>;

/// How a machine sees one axis of the robot:  u = (q − offset)·scale,  q in m or rad.
struct WireAxis {
  std::string name;      ///< for messages
  int address = 0;       ///< ID of a servo; letter of grbl, X = 0
  double scale = 1;      ///< units per m or rad, below 0 where it counts the other way
  double offset = 0;     ///< m or rad where it stands at its 0
  double most_step = 0;  ///< |u'|, units/s: twice that is not believed
};

/// Where the axes must be at an instant of wire_time(), and what the outputs must be from then on.
struct WireCommand {
  double time = 0;
  WireVector position{};
  WireVector velocity{};
  std::uint64_t outputs = 0;              ///< bit i: digital output channel i
  motion::AnalogValues analog_outputs{};  ///< V
};

/// Where the axes are, and what the inputs are.
struct WireAnswer {
  /// The instant of the references that the position belongs to: a machine that follows its
  /// references later than they are sent is compared with what it was sent for this instant.
  double time = 0;
  WireVector position{};
  WireVector velocity{};
  double spread = 0;         ///< s by which the instant of an axis may differ from `time`
  double seen = 0;           ///< wire_time() at which the machine reported this position
  std::uint64_t inputs = 0;  ///< bit i: digital input channel i
  motion::AnalogValues analog_inputs{};  ///< V
};

/// What a machine permits of an axis, in its units; infinite where it does not say.
struct WireLimits {
  WireVector min;
  WireVector max;
  WireVector speed;
  WireVector acceleration;

  WireLimits();
};

/// One protocol on one wire. WireBackend calls it, first from open(), then from a thread of its
/// own; so a call may wait, but not longer than it says here.
class WireLink {
 public:
  virtual ~WireLink() = default;

  /// Finds the machine and learns what it is; it does not move. Throws motion::DriverError.
  virtual void connect(WirePort& port) = 0;
  /// Drives to their places of reference by the machine itself, before it is enabled; throws
  /// motion::DriverError, where it cannot, too. When it is `given_up` (empty: never), the machine
  /// stops at once; that throws as well.
  virtual void home(const std::function<bool()>& given_up);
  /// What it permits. After connect().
  const WireLimits& limits() const { return limits_; }
  /// The least period of a cycle, s. After connect().
  virtual double least_period() const { return 0; }
  /// The period that it will be, s.
  virtual void use_period(double /*period*/) {}

  /// Puts the drives under force where they stand.
  virtual motion::DriverStatus enable() noexcept = 0;
  /// Takes the force away. A machine that answers first carries out what it has been sent, for 2 s
  /// at most; one that does not answer is left within the time that its axes need to brake.
  virtual void disable() noexcept = 0;
  /// One cycle until `deadline`; `command` is null while there is nothing to send. With an Alarm
  /// `answer` still is what the machine reports. Otherwise, unless Ok, it is as it was, or only
  /// some of its axes are new.
  virtual motion::DriverStatus exchange(const WireCommand* command, double deadline,
                                        WireAnswer& answer) noexcept = 0;

  /// Whether its outputs and inputs are those of the machine.
  virtual bool carries_signals() const { return false; }
  /// Why the last call was not Ok, and what to do: "what is wrong; the remedy".
  const std::string& trouble() const { return trouble_; }
  /// What the machine shows of itself that explains why its axes are not where they should be, in
  /// the same form; empty: nothing.
  const std::string& remark() const { return remark_; }
  /// Questions that had to be repeated, and answers that were not understood.
  std::uint32_t errors() const { return errors_; }

 protected:
  motion::DriverStatus fail(motion::DriverStatus status, const std::string& what,
                            const std::string& remedy) {
    trouble_ = what + "; " + remedy;
    return status;
  }
  void remark(const std::string& what, const std::string& remedy) {
    remark_ = what + "; " + remedy;
  }
  motion::DriverStatus lost(const WirePort& port) {
    return fail(motion::DriverStatus::Lost, "the machine on " + port.path() + " is gone",
                "check its power and its cable, and where the machine stands");
  }

  WireLimits limits_;
  std::uint32_t errors_ = 0;

 private:
  std::string trouble_;
  std::string remark_;
};

}  // namespace rob::drivers
