#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <string>

#include "drivers/serial/serial_port.h"
#include "motion/servo/servo_backend.h"
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

/// Where the axes shall be at an instant of wire_time().
struct WireCommand {
  double time = 0;
  WireVector position{};
  WireVector velocity{};
};

/// Where they are, at the instant of the references that this belongs to.
struct WireAnswer {
  double time = 0;
  WireVector position{};
  WireVector velocity{};
  double spread = 0;  ///< s by which the instant of an axis may differ from `time`
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
  virtual void connect(SerialPort& port) = 0;
  /// Drives to their places of reference by the machine itself, before it is enabled; throws
  /// motion::DriverError, where it cannot, too. When it is `given_up` (empty: never), the machine
  /// stops at once; that throws as well.
  virtual void home(const std::function<bool()>& given_up);
  /// What it permits. After connect().
  const WireLimits& limits() const { return limits_; }
  /// The least period of a cycle, s. After connect().
  virtual double least_period() const { return 0; }

  /// Under force where it stands.
  virtual motion::DriverStatus enable() noexcept = 0;
  /// Without force; 2 s at most, for what has to run dry.
  virtual void disable() noexcept = 0;
  /// One cycle until `deadline`; `command` is null while there is nothing to be told. Unless Ok,
  /// `answer` is as it was, or only some of its axes are new.
  virtual motion::DriverStatus exchange(const WireCommand* command, double deadline,
                                        WireAnswer& answer) noexcept = 0;

  /// Why the last call was not Ok, and what to do.
  const std::string& trouble() const { return trouble_; }
  /// Questions that had to be repeated, and answers that were not understood.
  std::uint32_t errors() const { return errors_; }

 protected:
  motion::DriverStatus fail(motion::DriverStatus status, std::string trouble) {
    trouble_ = std::move(trouble);
    return status;
  }
  motion::DriverStatus lost(const SerialPort& port) {
    return fail(motion::DriverStatus::Lost,
                "the machine on " + port.path() +
                    " is gone: its port has vanished;"
                    " check power and cable, and look where the machine stands");
  }

  WireLimits limits_;
  std::uint32_t errors_ = 0;

 private:
  std::string trouble_;
};

}  // namespace rob::drivers
