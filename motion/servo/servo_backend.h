#pragma once

#include <cstdint>
#include <stdexcept>
#include <string>

#include "motion/dynamics/arm_load.h"
#include "motion/space/analog_channels.h"
#include "motion/space/joint_vector.h"
#include "motion/space/wrench.h"

namespace rob::motion {

/// A backend that cannot be opened: what is wrong, and the remedy.
class DriverError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

enum class DriverStatus : std::uint8_t {
  Ok,
  Pending,  ///< nothing new since the last read(), and no time for it yet
  Silent,   ///< no answer this time
  Late,     ///< this computer kept the thread that asks the machine waiting for too long
  Alarm,    ///< the machine itself says that it has stopped, or cannot be trusted any more
  Lost      ///< it is gone
};

/// The command of one servo cycle to the machine. A backend with its own position loop follows
/// `reference`; one that takes forces applies `drive`.
struct ServoCommand {
  JointReference reference;
  JointVector drive;          ///< N or Nm; of drives that take pulses: how many until the next
  std::uint64_t outputs = 0;  ///< bit i: digital output channel i
  AnalogValues analog_outputs{};
  const CarriedLoad* carried = nullptr;  ///< what the program says the arm carries; null: nothing
};

/// The state that one servo cycle learns from it.
struct ServoState {
  JointMeasurement measured;
  double spread = 0;         ///< s by which the instant of an axis may differ from measured.time
  double seen = 0;           ///< when the machine reported this position, by the servo's clock, s
  double late = 0;           ///< with Late: s for which nobody has asked the machine
  std::uint64_t inputs = 0;  ///< bit i: digital input channel i
  AnalogValues analog_inputs{};
  Wrench wrench;           ///< of the force sensor, about the flange and along its axes
  double wrench_time = 0;  ///< when that was measured; 0: never
  double wire_errors = 0;  ///< share of the exchanges of the last second that went wrong at first
};

/// Where motion control ends and a machine begins: a simulation, or drives on a wire.
///
/// open() and close() may block and allocate; open() throws DriverError. enable(), disable(),
/// read() and write() run inside the servo tick: they return at once, take no memory, and report
/// trouble by their value. `now` is the time of the servo's clock in s and never goes back.
///
/// `measured.time` that read() returns may lie before `now`: it is the instant of the references
/// that the measurement belongs to. A machine that follows later is thus compared with what it was
/// sent, and not with what it has not come to yet. It lies after `now` if the thread of the servo
/// was kept waiting between looking at its clock and reading; a clock that has not begun shows
/// times below 0.
class ServoBackend {
 public:
  virtual ~ServoBackend() = default;

  virtual int axes() const noexcept = 0;
  virtual void open() = 0;
  virtual void close() noexcept = 0;
  /// Drives hold their current position until the first write().
  virtual DriverStatus enable(double now) noexcept = 0;
  /// Drives are without force from now on.
  virtual void disable(double now) noexcept = 0;
  virtual DriverStatus read(double now, ServoState& state) noexcept = 0;
  virtual DriverStatus write(double now, const ServoCommand& command) noexcept = 0;

  /// It closes the position loop itself: references are what it takes, no servo law stands before
  /// it, and it gets them as long as it is not lost.
  virtual bool follows_references() const noexcept { return false; }
  /// Why the last status was not Ok: "what is wrong; the remedy". Empty if nothing more is known.
  /// From any thread but the tick.
  virtual std::string trouble() const { return {}; }
  /// A remark of the machine that explains why its axes are not where they should be, in the same
  /// form. Empty: nothing. From any thread but the tick.
  virtual std::string remark() const { return {}; }
};

}  // namespace rob::motion
