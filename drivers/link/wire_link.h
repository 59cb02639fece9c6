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

/// The positions of the axes at an instant of wire_time(), and the outputs from then on.
struct WireCommand {
  double time = 0;
  WireVector position{};
  WireVector velocity{};
  std::uint64_t outputs = 0;              ///< bit i: digital output channel i
  motion::AnalogValues analog_outputs{};  ///< V
};

/// The measured positions of the axes, and the inputs.
struct WireAnswer {
  /// The instant of the references that the position belongs to. A machine may follow its
  /// references with a delay: Rob compares its position with the reference of this instant.
  double time = 0;
  WireVector position{};
  WireVector velocity{};
  double spread = 0;         ///< s by which the instant of an axis may differ from `time`
  double seen = 0;           ///< wire_time() at which the machine reported this position
  std::uint64_t inputs = 0;  ///< bit i: digital input channel i
  motion::AnalogValues analog_inputs{};  ///< V
};

/// The limits of the machine's axes, in its units; infinite if it does not report them.
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

  /// Finds the machine and reads its settings, without moving it. Throws motion::DriverError.
  virtual void connect(WirePort& port) = 0;
  /// Lets the machine home itself, before enable(). Throws motion::DriverError if it fails or
  /// cannot home. Stops the machine at once, and throws, as soon as `given_up` (empty: never)
  /// returns true.
  virtual void home(const std::function<bool()>& given_up);
  /// The machine's limits. After connect().
  const WireLimits& limits() const { return limits_; }
  /// The least period of a cycle, s. After connect().
  virtual double least_period() const { return 0; }
  /// Announces the period of the cycle, s.
  virtual void use_period(double /*period*/) {}

  /// Enables the drives where they stand.
  virtual motion::DriverStatus enable() noexcept = 0;
  /// Disables the drives. A machine that answers first executes what it has received, for 2 s at
  /// most. If it does not answer, returns within the time its axes need to brake.
  virtual void disable() noexcept = 0;
  /// One cycle, until `deadline`; `command` is null while there is nothing to send. On Ok and Alarm
  /// `answer` is the machine's report. Otherwise it is unchanged, or new for only some axes.
  virtual motion::DriverStatus exchange(const WireCommand* command, double deadline,
                                        WireAnswer& answer) noexcept = 0;

  /// Whether the wire carries the machine's outputs and inputs.
  virtual bool carries_signals() const { return false; }
  /// Why the last call was not Ok, and what to do: "what is wrong; the remedy".
  const std::string& trouble() const { return trouble_; }
  /// A cause, known to the machine, for axes that are off their references, in the same form;
  /// empty: none.
  const std::string& remark() const { return remark_; }
  /// Number of questions that Rob repeated, and of answers it could not read.
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
